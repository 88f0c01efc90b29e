#include "solve/dense_modes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// What is orthogonal in m to modes of unit mass; twice, as the first time leaves rounding.
VectorXd without(const MatrixXd& modes, const MatrixXd& m, VectorXd x) {
  for (int pass = 0; pass < 2; ++pass) x -= modes * (modes.transpose() * (m * x));
  return x;
}

} // namespace

bool better_dense(const SparseMatrix& K, const SparseMatrix& M) {
  constexpr Index few = 60, some = 300;
  if (K.rows() <= few || K.rows() > some) return K.rows() <= few;
  const VectorXd mass = M.diagonal();
  return K.nonZeros() > K.rows() * K.rows() / 8 || (mass.array() == 0).any();
}

// Far above the lowest mode, rounding leaves lower ones and motions without mass in a vector of the
// dense solver: each is made orthogonal to those below it and improved by one inverse iteration.
EigenPairs dense_modes(const SparseMatrix& K, const SparseMatrix& M, double sigma) {
  constexpr double finite = 1e-14; // theta / largest theta
  const MatrixXd m = MatrixXd(M).selfadjointView<Eigen::Lower>();
  MatrixXd k = MatrixXd(K).selfadjointView<Eigen::Lower>();
  k -= sigma * m;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(m, k);
  const auto& theta = solver.eigenvalues(); // increasing
  EigenPairs pairs;
  pairs.converged = solver.info() == Eigen::Success;
  if (!pairs.converged) pairs.reason = "the dense eigenvalue solver did not converge";
  const Index count = (theta.array() > finite * theta[theta.size() - 1]).count();
  const Eigen::LLT<MatrixXd> factor(k);
  pairs.values.resize(count);
  pairs.vectors.resize(K.rows(), count);
  for (Index j = 0; j < count; ++j) {
    const auto below = pairs.vectors.leftCols(j);
    const VectorXd start = without(below, m, solver.eigenvectors().col(theta.size() - 1 - j));
    const VectorXd force = m * start;
    const VectorXd phi = without(below, m, factor.solve(force));
    const double mass = phi.dot(m * phi);
    pairs.values[j] = phi.dot(force) / mass + sigma; // phi' (K - sigma M) phi / mass
    pairs.vectors.col(j) = phi / std::sqrt(mass);
  }
  std::sort(pairs.values.begin(), pairs.values.end()); // but for rounding they are
  return pairs;
}

} // namespace plica
