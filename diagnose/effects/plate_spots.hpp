// Where something may touch a plate or sit on it: the crossings of up to five lines either way.
//
// "plate.spot[25][50]" is 25 % of the way along edge 1 (corner 1 to 2) and 50 % along edge 2
// (corner 2 to 3), at a node of the mesh: spot[0][0] is corner 1, spot[100][100] corner 3.
#pragma once

#include "diagnose/effects/effect.hpp"
#include "diagnose/effects/spot.hpp"

namespace plica {

// Those that move along the normal; none where the mesh is not the grid that the plate asks for.
std::vector<Spot> plate_spots(const BuiltCase& built, const std::string& part, const Plate& plate);

} // namespace plica
