// Static condensation onto boundary DOFs and the end stiffness of a part between two caps.
#pragma once

#include "solve/sparse_factor.hpp"

namespace plica {

using Matrix66 = Eigen::Matrix<double, 6, 6>;

// K_bb - K_bi K_ii^-1 K_ib. `boundary`: increasing numbers of DOFs of K; `inner`: factor of K
// without them, in the same order.
Eigen::MatrixXd condense(const SparseMatrix& K, const std::vector<int>& boundary,
                         const SparseFactor& inner);

// The same from the static shapes Psi of unit motions of the boundary: its reactions.
Eigen::MatrixXd boundary_stiffness(const SparseMatrix& K, const std::vector<int>& boundary,
                                   const Eigen::MatrixXd& Psi);

// All DOFs of K when those of the boundary move by the columns of u_b and nothing else acts:
// u_i = -K_ii^-1 K_ib u_b, refined with residuals in extended precision.
Eigen::MatrixXd follow_boundary(const SparseMatrix& K, const std::vector<int>& boundary,
                                const SparseFactor& inner, const Eigen::MatrixXd& u_b);

// DOFs 0..n-1 that are not in `removed` (increasing).
std::vector<int> complement(int n, const std::vector<int>& removed);

// What a rig measures between two caps, the first one held, y along the pipe: axial and lateral
// force over displacement with the moving end kept parallel; moment over rotation of a free end;
// torque over twist.
struct EndStiffness {
  double axial = 0, transverse_x = 0, transverse_z = 0; // N/m
  double bending_x = 0, bending_z = 0, torsion = 0;     // Nm/rad
};

// From the 6x6 stiffness of the moving end. Throws std::runtime_error when it is not positive
// definite; `loaded`, around a state, it may be: a bending stiffness below zero says that the end
// would not stay where it is if it were free.
EndStiffness end_stiffness(const Matrix66& K, bool loaded = false);

} // namespace plica
