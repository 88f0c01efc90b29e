// Shells, bars, masses and springs of a Nastran deck.
#pragma once

#include "io/decks/nastran_properties.hpp"

namespace plica {

struct NastranReading {
  const CardsByName& cards;
  NastranGrids& grids;
  const NastranProperties& properties;
  DeckModel& deck;
  DeckProblems& problems;
  bool coupled_mass = false; // PARAM COUPMASS: of trusses

  template <class F> void each(const char* name, F&& read) const {
    if (const auto found = cards.find(name); found != cards.end())
      for (const Card* card : found->second) problems.collect([&] { read(*card); });
  }
};

void read_shells(const NastranReading& reading);           // and shear panels
void read_bars(const NastranReading& reading);             // beams, rods
void read_points(const NastranReading& reading);           // masses and springs
void read_general_elements(const NastranReading& reading); // GENEL
// DMIG that case control adds by K2GG and M2GG, as elements; of assigned OP4 as well, which name
// neither points nor components: their rows are those of ASET and its like, else of all points, by
// number. External superelements (SEBULK, EXTOP4), whose rows are those of EXTRN.
void read_matrices(const NastranReading& reading, const BulkData& bulk);

} // namespace plica
