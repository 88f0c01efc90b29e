// Beams as they are drawn: tubes of their own radius.
#pragma once

#include "run/results/results.hpp"

namespace plica {

// A point of a picture: a node of the mesh and an arm from it, which turns with it.
struct DrawnPoint {
  int node = 0;
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();
};

// Is a line of the results drawn as a tube?
bool has_tube(const Results& results, std::size_t line);

// Appends the points of the tubes and their quads, whose corners are numbers of points from `first`
// on (that of the first point in the list) and run counter-clockwise from outside.
void add_tubes(const Results& results, int first, std::vector<DrawnPoint>& points,
               std::vector<std::array<int, 4>>& quads);

// Where the points are at rest, and their displacements in a mode (nodes x 6: motion, small turn).
Eigen::Vector3d place_of(const Results& results, const DrawnPoint& point);
Eigen::MatrixXd motion_of(const std::vector<DrawnPoint>& points, const Eigen::MatrixXd& shape);

} // namespace plica
