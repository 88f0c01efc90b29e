// Places between the nodes of shells: where the wall is under a point, and the rows that tie a node
// of its own there by the shape functions of the element,
//   u = sum N_a u_a + theta x d,  theta = sum N_a theta_a,
// d from the point of the wall to the node. Rigid motions are followed exactly; at a corner of the
// element the node is that corner with an arm.
#pragma once

#include "model/shape/building.hpp"

namespace plica {

// The point of the mid-surface that is nearest to another.
struct WallPoint {
  std::vector<int> nodes; // of the shell; none: there is no shell
  std::vector<double> N;  // shape functions, of sum 1
  Eigen::Vector3d at{0, 0, 0};
  double distance = 0;  // m, from the mid-surface
  double thickness = 0; // there
};

// On the shells of one component (index into Model::components), or -1: on any.
WallPoint nearest_on_wall(const Model& model, const Eigen::Vector3d& point, int component = -1);

// How far a point is beyond the wall's surfaces, m.
double off_wall(const WallPoint& wall);

// The node follows the wall.
void tie_to_wall(Model& model, int node, const WallPoint& wall, const std::string& origin);

// A node for each place of the shells of a part, as the set "part.place"; `component` is the
// part's. InputError for a place that is more than 5 mm off the wall.
void add_wall_places(Building& b, const std::string& part, const std::vector<PartPlace>& places,
                     int component);

// Ties these nodes, when everything else stands. A corner of the element follows the place and the
// other corners, so that the place moves by itself and may be held and joined; where no corner is
// free the place follows. InputError where that is no way either.
void tie_wall_places(Building& b);

} // namespace plica
