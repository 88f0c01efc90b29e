// What ties and holds the grid points of a Nastran deck: RBE2, RBE3, RBAR, MPC, SPC.
#pragma once

#include "io/decks/nastran_grids.hpp"

namespace plica {

void read_rigid_elements(const CardsByName& cards, const NastranGrids& grids, DeckModel& deck);

// Of the sets that case control chooses, or, without it, of the only one there is.
void read_constraints(const CardsByName& cards, const std::map<std::string, std::set<int>>& chosen,
                      const NastranGrids& grids, DeckModel& deck);

} // namespace plica
