// Clamps that a case draws as rigid, on springs that a hypothesis may soften.
//
// The springs are so stiff that the nominal structure does not feel them: at least a thousand times
// what the elements at the clamp resist to a motion of its node, all other nodes held,
//
//   k >= 1000 K_dd,  d a degree of freedom of the cap's node in the model with the clamp rigid.
//
// A force that a mode sends through the clamp strains these elements, too, and with them the rest
// of the parts: of the energy of a mode the springs have less than a thousandth of what they have.
#pragma once

#include "model/description/case.hpp"

namespace plica {

// Puts such springs, alike at all, into caps that join parts in a row, and names these caps. Left
// rigid are caps that are mounted, that hold several ends of one part, whose parts meet in another
// cap too (side by side, as a pipe within a pipe), whose node a support holds, and all of a case
// that a state loads. Throws as build() does.
std::vector<std::string> put_springs_in_clamps(Case& data);

// Keys of caps that join ends rigidly all the same and are not mounted.
std::vector<std::string> clamps_left_rigid(const Case& data);

} // namespace plica
