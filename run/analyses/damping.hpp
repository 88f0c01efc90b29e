// Damping of each mode from what the case states.
#pragma once

#include "model/shape/build.hpp"

#include <functional>

namespace plica {

struct ModalDamping {
  Eigen::VectorXd zeta; // fraction of critical, viscous
  Eigen::VectorXd eta;  // loss factor, structural
};

// For modes of the given eigenvalues (rad2/s2) and shapes u (all DOFs x modes, mass-normalised);
// the first `numbered` columns are modes that a number of the case may mean, the rest pseudo-modes.
//   zeta_j: the value of mode j, else of the range its frequency lies in, else that of all
//   eta_j = sum_c eta_c phi_j' K_c phi_j / lambda_j over the components
// The off-diagonal terms that unequal loss factors bring are left out.
// Throws InputError for a loss factor of what is not a component.
ModalDamping modal_damping(const Damping& damping, const Model& model,
                           const Eigen::VectorXd& lambda, const Eigen::MatrixXd& u, int numbered);

// With phi_j' K_c phi_j by component (rows) of some of the columns from 0, asked for where a loss
// factor needs it.
ModalDamping
modal_damping(const Damping& damping, const Model& model, const Eigen::VectorXd& lambda,
              const std::function<Eigen::MatrixXd(const std::vector<int>& columns)>& energy,
              int numbered);

} // namespace plica
