// Rigid motions that supports leave to a structure: a carriage on rails, a wheel on its axle.
#pragma once

#include "solve/model.hpp"

namespace plica {

// Those of the whole that strain nothing and move no support: combinations of rigid_body_motions()
// about the origin, 6 x their number.
Eigen::MatrixXd loose_motions(const Model& model);

// The model with a spring to the ground so soft that these motions come at a thousandth of the
// frequency of its first mode, which is changed by a millionth at most.
Model on_a_soft_spring(Model model, Eigen::Index loose);

} // namespace plica
