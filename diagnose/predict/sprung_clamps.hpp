// Clamps that a case draws as rigid, on springs that a hypothesis may soften.
//
// The springs are so stiff that the nominal structure does not feel them: at least a thousand times
// what the elements at the clamp resist to a motion of its node, all other nodes held,
//
//   k >= 1000 K_dd,  d a degree of freedom of the cap's node in the model with the clamp rigid.
//
// A force that a mode sends through the clamp strains these elements, too, and with them the rest
// of the parts: of the energy of a mode the springs have less than a thousandth of what they have.
//
// Where a cap joins two ends in one place and is not mounted the springs stand between these (its
// `stiffness`); else each end hangs on springs of its own (`ends`), so that one of several bolts
// may be loose.
#pragma once

#include "model/description/case.hpp"

namespace plica {

// Puts such springs, alike at all, into caps that join ends and have none, and names the places:
// "caps.joint", "caps.flange.pipe.end". Left rigid are caps at which nothing resists in one
// direction or more. Throws as build() does.
std::vector<std::string> put_springs_in_clamps(Case& data);

// Keys of caps that join ends rigidly all the same.
std::vector<std::string> clamps_left_rigid(const Case& data);

} // namespace plica
