// How much of a motion's strain energy lies in the drilling stiffness of single shell nodes.
//
// The rotation of a shell about its normal is tied to the rotation of its membrane by a penalty (a
// fraction of G t), so that the matrix is regular; the penalty has no physics. A body with a lever
// in the plane of one shell node, or a beam that is twisted by it, swings on that penalty alone:
// its frequency falls with the size of the elements and has no limit.
#pragma once

#include "solve/model.hpp"

#include <set>

namespace plica {

// Nodes that masses, beams, springs, matrices or couplings reach.
std::set<int> nodes_with_something(const Model& model);

struct DrillingShare {
  double share = 0; // of the strain energy, in the shells that meet at one node
  int node = -1;    // with the largest share; -1 = nothing sits on a shell
};

// One per column of u (all DOFs). `energy`: u' K u of each. Looked at are the shell nodes that
// something sits on.
std::vector<DrillingShare> drilling_shares(const Model& model, const Eigen::MatrixXd& u,
                                           const Eigen::VectorXd& energy);

} // namespace plica
