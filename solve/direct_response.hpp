// Steady response of the whole model at one frequency by a direct solution: what modal sums, modal
// springs and reductions are held against. Over the free DOFs
//
//   (K + i sum_c eta_c K_c + sum_k t_k g_k(i w) t_k' + M Phi D(w) Phi' M - w^2 M) u = F,
//   D = diag(i eta_j lambda_j + 2 i zeta_j sqrt(lambda_j) w)
//
// D is damping that is stated for the modes: no other matrix has it. K - w^2 M is factored by
// UMFPACK (Davis, ACM TOMS 30 (2004) 196-199), complex where parts have a loss factor; springs and
// modal damping are joined to it by Woodbury's identity, which takes w off the undamped
// eigenfrequencies by more than rounding.
#pragma once

#include "solve/assembly.hpp"
#include "solve/dissipation.hpp"

namespace plica {

struct DirectModel {
  SparseMatrix K, M;                 // lower triangles over the free DOFs
  SparseMatrix loss;                 // sum_c eta_c K_c, likewise; 0 x 0: none
  Eigen::MatrixXd springs;           // t_k, free DOFs x springs
  std::vector<AddedStiffness> added; // one per spring
  Eigen::MatrixXd shapes;            // M Phi, free DOFs x modes
  Eigen::VectorXd lambda, zeta, eta; // of them
};

// u, free DOFs x loads; omega > 0 in rad/s. Throws std::runtime_error where the matrix is singular
// or memory is short.
Eigen::MatrixXcd direct_response(const DirectModel& model, const Eigen::MatrixXcd& force,
                                 double omega);

// sum_c eta_c K_c over the independent DOFs, lower triangle; `eta`: one per component.
SparseMatrix loss_matrix(const Model& model, const DofMap& map, const Eigen::VectorXd& eta);

} // namespace plica
