// What ties the grid points of a Nastran deck: RBE2, RBE3, RBAR, CRIGD1, MPC; and what holds them
// in every load case (the cards themselves, SPC and SPC1: held_by in nastran_loads.hpp).
#pragma once

#include "io/decks/nastran_elements.hpp"

namespace plica {

void read_rigid_elements(const NastranReading& reading);
// RBE1, CRIGD3, RROD, CRIGDR: rows between single degrees of freedom.
void read_rigid_bodies(const NastranReading& reading);

// Of the sets that the first subcase chooses, or, in a file without case control, of the only one
// there is. A set that is chosen and not there is an error; what is not chosen is noted. Gives what
// is held without any SPC.
std::vector<Constraint> read_constraints(const NastranReading& reading, const BulkData& bulk);

} // namespace plica
