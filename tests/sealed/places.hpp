// Named places of the wall, and rows that read them off displacements of mid-surface nodes.
//
//   ring.<k>      mean motion of crown circle k, six rows
//   station.<k>   mean motion of root circle k, six rows
//   point.<name>  a node: three rows (mid, quarter, low)
//   <name>.<a><b> the 3 x 3 nodes round a sensor: a along the meridian, b around, from 0
#pragma once

#include "wall.hpp"

#include <functional>

namespace sealed {

// How one displacement of a mid-surface node depends on the free unknowns.
using Terms = std::vector<std::pair<int, double>>;
using Displacement = std::function<Terms(int node, int axis)>;

struct Circle {
  std::vector<Eigen::Vector3d> x; // from x towards z in equal steps
  std::vector<int> nodes;
};

struct WallSpots {
  std::map<int, Circle> crowns, roots;
  std::array<Circle, 3> mid, quarter; // circles before, at and after that crown
};

void add_places(FullWall& wall, const WallSpots& spots, const Displacement& displacement,
                int unknowns);

} // namespace sealed
