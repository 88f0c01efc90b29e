// What ties and holds the grid points of a Nastran deck: RBE2, RBE3, RBAR, MPC, SPC.
#pragma once

#include "io/decks/nastran_grids.hpp"

namespace plica {

void read_rigid_elements(const CardsByName& cards, const NastranGrids& grids, DeckModel& deck);

// Of the sets that case control chooses, or, in a file without it, of the only one there is. Cards
// that are there and not chosen, and a set that is chosen and not there, are errors.
void read_constraints(const CardsByName& cards, const BulkData& bulk, const NastranGrids& grids,
                      DeckModel& deck);

} // namespace plica
