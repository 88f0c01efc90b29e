#include "engine/residual_vectors.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Columns that the modes do not hold, M-orthonormal. Twice, because one pass leaves rounding.
MatrixXd outside_of_modes(const DistributedMatrix& M, const MatrixXd& Phi, const MatrixXd& X,
                          const Ranks& ranks) {
  constexpr double held = 1e-7; // of the M-norm before: nothing but rounding is left
  MatrixXd R(X.rows(), X.cols());
  int count = 0;
  const auto dot = [&](const MatrixXd& a, const MatrixXd& b) {
    return ranks.sum(MatrixXd(a.transpose() * b));
  };
  for (Index j = 0; j < X.cols(); ++j) {
    MatrixXd x = X.col(j);
    const double before = std::sqrt(dot(x, M * x)(0, 0));
    for (int pass = 0; pass < 2; ++pass) {
      const MatrixXd Mx = M * x;
      x -= Phi * dot(Phi, Mx) + R.leftCols(count) * dot(R.leftCols(count), Mx);
    }
    const double norm = std::sqrt(std::max(0., dot(x, M * x)(0, 0)));
    if (norm > held * before) R.col(count++) = x / norm;
  }
  return R.leftCols(count);
}

} // namespace

DistributedBasis with_residual_vectors(const DistributedMatrix& K, const DistributedMatrix& M,
                                       const Eigen::VectorXd& lambda, const MatrixXd& Phi,
                                       const MatrixXd& X, const Ranks& ranks) {
  const MatrixXd R = outside_of_modes(M, Phi, X, ranks);
  DistributedBasis basis{.lambda = lambda, .pseudo = R};
  if (R.cols() == 0) return basis;
  const MatrixXd reduced = ranks.sum(MatrixXd(R.transpose() * (K * R)));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pseudo(
      MatrixXd((reduced + reduced.transpose()) / 2));
  basis.lambda.conservativeResize(lambda.size() + R.cols());
  basis.lambda.tail(R.cols()) = pseudo.eigenvalues();
  basis.pseudo = R * pseudo.eigenvectors();
  return basis;
}

} // namespace plica
