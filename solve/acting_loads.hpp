// What brings a model into a state (base_state.hpp), beside pressure and thermal strain, which its
// sections have.
#pragma once

#include "solve/assembly.hpp"

#include <map>
#include <vector>

namespace plica {

// A node whose six DOFs are moved to a place; `turn` is a rotation vector, rad.
struct MovedHold {
  int node = 0;
  Eigen::Vector3d shift{0, 0, 0}, turn{0, 0, 0};
};

struct StateLoads {
  std::vector<MovedHold> holds;     // of nodes that are held, also those that stay where they are
  Eigen::VectorXd force;            // over all DOFs, N and Nm, of constant direction; empty = none
  std::map<int, double> growth;     // thermal strain of what follows a node rigidly, by that node
  Eigen::Vector3d gravity{0, 0, 0}; // acceleration that acts on the masses at rest, m/s2
};

} // namespace plica
