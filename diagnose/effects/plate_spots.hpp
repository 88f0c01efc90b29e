// Places of a plate that a case may ask for by name: the crossings of up to five lines either way.
// Unasked, all of it is looked at (plate_places.hpp).
//
// "plate.spot[25][50]" is 25 % of the way along edge 1 (corner 1 to 2) and 50 % along edge 2
// (corner 2 to 3), at a node of the mesh: spot[0][0] is corner 1, spot[100][100] corner 3.
#pragma once

#include "diagnose/effects/effect.hpp"
#include "diagnose/effects/spot.hpp"

#include <set>

namespace plica {

// Numbers of the lines of nodes across an edge of so many elements that part it into up to `most`
// cells, both ends among them.
std::set<int> lines_across(int elements, int most);
// Of the bilinear surface through the corners, at shares of the way along edges 1 and 2.
Triple point_at(const Plate& plate, double a, double b);
Eigen::Vector3d normal_at(const Plate& plate, double a, double b);

// Those that move along the normal; none where the mesh is not the grid that the plate asks for.
std::vector<Spot> plate_spots(const BuiltCase& built, const std::string& part, const Plate& plate);

} // namespace plica
