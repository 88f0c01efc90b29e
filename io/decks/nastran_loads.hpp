// Static load cases of a Nastran deck: the subcases with LOAD, each with its SPC.
#pragma once

#include "io/decks/nastran_elements.hpp"

namespace plica {

bool is_load_card(const std::string& name);

// What is held by sets of SPC, SPC1 and by the grid points themselves.
struct HeldBySets {
  std::vector<Constraint> supports;
  std::map<std::pair<int, int>, double> moved; // displacements other than zero
  std::size_t moved_cards = 0;
  std::map<std::string, std::vector<int>> sets; // nodes by "SPC[1]"
};
HeldBySets held_by(const NastranReading& reading, const std::set<int>& sets,
                   std::vector<Constraint> supports);

// Fills load_cases. `loads`: cards by name that act; `supports`: what no SPC holds. In a file
// without case control there is one, of the only set of loads, with what holds the deck. What is
// wrong or not had goes into DeckLoadCase::not_had: it concerns who asks for the loads alone.
void read_loads(const NastranReading& reading, const CardsByName& loads, const BulkData& bulk,
                const std::vector<Constraint>& supports);

} // namespace plica
