// The residual vectors of solve/static_correction.hpp, over ranks.
#pragma once

#include "engine/distributed_matrix.hpp"

namespace plica {

struct DistributedBasis {
  Eigen::VectorXd lambda; // the modes, then the pseudo-modes
  Eigen::MatrixXd pseudo; // own rows of the pseudo-modes
};

// Collective. X: own rows of static solutions, one column per load.
DistributedBasis with_residual_vectors(const DistributedMatrix& K, const DistributedMatrix& M,
                                       const Eigen::VectorXd& lambda, const Eigen::MatrixXd& Phi,
                                       const Eigen::MatrixXd& X, const Ranks& ranks);

} // namespace plica
