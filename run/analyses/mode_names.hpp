// Names for modes that would be called the same.
#pragma once

#include "run/results/results.hpp"
#include "solve/model.hpp"

namespace plica {

// Sets the place of modes of one shape, direction and order: the part that is strained most, or
// where that is one for all, which of them they are ("no. 2"; the two of a pair are one). `u`: all
// DOFs x modes at least, as listed. Rigid modes keep their name.
void tell_apart(std::vector<ModeResult>& modes, const Model& model, const Eigen::MatrixXd& u);

} // namespace plica
