#include "solve/static_correction.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace plica {
namespace {

using Eigen::MatrixXd;

// Columns that the modes do not hold, M-orthonormal. Twice, because one pass leaves rounding.
MatrixXd outside_of_modes(const SparseMatrix& M, const MatrixXd& Phi, const MatrixXd& X) {
  constexpr double held = 1e-7; // of the M-norm before: nothing but rounding is left
  MatrixXd R(X.rows(), X.cols());
  int count = 0;
  for (Eigen::Index j = 0; j < X.cols(); ++j) {
    Eigen::VectorXd x = X.col(j);
    const double before = std::sqrt(x.dot(symmetric_product(M, x).col(0)));
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd Mx = symmetric_product(M, x);
      x -= Phi * (Phi.transpose() * Mx) + R.leftCols(count) * (R.leftCols(count).transpose() * Mx);
    }
    const double norm = std::sqrt(std::max(0., x.dot(symmetric_product(M, x).col(0))));
    if (norm > held * before) R.col(count++) = x / norm;
  }
  return R.leftCols(count);
}

} // namespace

ModalBasis add_static_correction(const SparseMatrix& K, const SparseMatrix& M,
                                 const Eigen::VectorXd& lambda, const MatrixXd& Phi,
                                 const MatrixXd& X) {
  const int modes = static_cast<int>(lambda.size());
  const MatrixXd R = outside_of_modes(M, Phi, X);
  ModalBasis basis{.lambda = lambda, .Phi = Phi, .modes = modes};
  if (R.cols() == 0) return basis;
  const MatrixXd reduced = R.transpose() * symmetric_product(K, R);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pseudo(
      MatrixXd((reduced + reduced.transpose()) / 2));
  basis.lambda.conservativeResize(modes + R.cols());
  basis.lambda.tail(R.cols()) = pseudo.eigenvalues();
  basis.Phi.conservativeResize(Eigen::NoChange, modes + R.cols());
  basis.Phi.rightCols(R.cols()) = R * pseudo.eigenvectors();
  return basis;
}

} // namespace plica
