#include "solve/dense_modes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::MatrixXd;

bool better_dense(const SparseMatrix& K, const SparseMatrix& M) {
  constexpr Eigen::Index few = 60, some = 300;
  if (K.rows() <= few || K.rows() > some) return K.rows() <= few;
  const Eigen::VectorXd mass = M.diagonal();
  return K.nonZeros() > K.rows() * K.rows() / 8 || (mass.array() == 0).any();
}

EigenPairs dense_modes(const SparseMatrix& K, const SparseMatrix& M, double sigma) {
  constexpr double finite = 1e-14; // theta / largest theta
  const MatrixXd m = MatrixXd(M).selfadjointView<Eigen::Lower>();
  MatrixXd k = MatrixXd(K).selfadjointView<Eigen::Lower>();
  k -= sigma * m;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(m, k);
  const auto& theta = solver.eigenvalues();
  EigenPairs pairs;
  pairs.converged = solver.info() == Eigen::Success;
  if (!pairs.converged) pairs.reason = "the dense eigenvalue solver did not converge";
  std::vector<int> kept; // largest theta first
  for (Eigen::Index j = theta.size() - 1; j >= 0; --j)
    if (theta[j] > finite * theta[theta.size() - 1]) kept.push_back(static_cast<int>(j));
  pairs.values = theta(kept).cwiseInverse().array() + sigma;
  pairs.vectors = solver.eigenvectors()(Eigen::all, kept);
  for (Eigen::Index j = 0; j < pairs.vectors.cols(); ++j) // from unit K - sigma M to unit M
    pairs.vectors.col(j) /= std::sqrt(theta(kept)[j]);
  return pairs;
}

} // namespace plica
