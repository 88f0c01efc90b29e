// All eigenpairs of a small symmetric-definite pencil, A x = theta B x. From about seventy unknowns
// on by LAPACK (dsygvd: divide and conquer), which blocks what Eigen does column by column; below,
// Eigen is as fast.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace plica {

struct SymmetricPairs {
  Eigen::VectorXd values;  // increasing
  Eigen::MatrixXd vectors; // X' B X = I
};

// Of both the lower triangle is read. None: B is not positive definite, or no convergence.
std::optional<SymmetricPairs> symmetric_pairs(Eigen::MatrixXd A, Eigen::MatrixXd B);

} // namespace plica
