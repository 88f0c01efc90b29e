// Places on a part that is read from a file, a surface or a deck, and where such a part or a plate
// may be damaged: nodes spread all over it.
//
// "duct.spot[120][-4][33]" is the node at x = 120, y = -4, z = 33 mm. Some twenty are looked at
// first, each as far from the others as may be; up to four hundred between them where these come
// near.
#pragma once

#include "diagnose/effects/spot.hpp"
#include "model/shape/build.hpp"

namespace plica {

bool is_from_file(const Part& part);

// Nodes of shells along their mean normal, of beams alone along any axis; none where that is held,
// and none of what a deck has as matrices: laminates, solids.
std::vector<Spot> wall_spots(const BuiltCase& built, const std::string& part);

// Nodes of shells and beams, held or not, of which something about them may be damaged.
std::vector<Spot> damage_spots(const BuiltCase& built, const std::string& part);

} // namespace plica
