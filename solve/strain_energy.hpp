// Strain energy by component: where a shape stores what it stores.
#pragma once

#include "solve/model.hpp"

#include <vector>

namespace plica {

// u' K_c u for every component c (rows) and shape (columns); u: all DOFs x shapes. The sum over the
// components is u' K u, twice the strain energy.
Eigen::MatrixXd strain_energy(const Model& model, const Eigen::MatrixXd& u);

// u' K_c u in full for every component: its stiffness in the coordinates of the columns of u.
std::vector<Eigen::MatrixXd> component_stiffness(const Model& model, const Eigen::MatrixXd& u);

} // namespace plica
