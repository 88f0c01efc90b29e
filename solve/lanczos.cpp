// Spectra's long vector operations through BLAS.
#define EIGEN_USE_BLAS
#include "solve/lanczos.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Spectra/SymEigsSolver.h>
#include <random>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Eigen::VectorXi;

// Matrix in the order of the factor, with both triangles.
SparseMatrix in_order(const SparseMatrix& lower, const SparseFactor& factor) {
  const Eigen::PermutationMatrix<Eigen::Dynamic> to_rows{VectorXi(factor.order())};
  SparseMatrix full;
  full = lower.selfadjointView<Eigen::Lower>().twistedBy(to_rows.transpose());
  return full;
}

// y = L^-1 P M P' L'^-1 x; the shift is already in the factor.
class ShiftInvert {
public:
  using Scalar = double;

  ShiftInvert(const SparseMatrix& M, const SparseFactor& factor)
      : factor_(factor), mass_(in_order(M, factor)), x_(M.rows()), Mx_(M.rows()) {}

  Eigen::Index rows() const { return mass_.rows(); }
  Eigen::Index cols() const { return mass_.cols(); }

  void perform_op(const double* x, double* y) const {
    factor_.solve_upper(x, x_.data());
    range(x_, y);
  }

  // y = L^-1 P M P' x. The product on all cores: a column of the full matrix is also a row, summed
  // in one order.
  void range(const VectorXd& x, double* y) const {
    constexpr Eigen::Index worth_a_team = 500000;
#pragma omp parallel for schedule(static) if (mass_.nonZeros() > worth_a_team)
    for (int i = 0; i < mass_.outerSize(); ++i) {
      double sum = 0;
      for (SparseMatrix::InnerIterator it(mass_, i); it; ++it) sum += it.value() * x[it.row()];
      Mx_[i] = sum;
    }
    factor_.solve_lower(Mx_.data(), y);
  }

private:
  const SparseFactor& factor_;
  SparseMatrix mass_;
  mutable VectorXd x_, Mx_;
};

// In the range of the operator.
VectorXd start_vector(const ShiftInvert& shift_invert, unsigned seed) {
  std::mt19937 random(seed);
  VectorXd v(shift_invert.rows()), y(shift_invert.rows());
  for (double& x : v) x = double(random()) / double(std::mt19937::max()) - 0.5;
  shift_invert.range(v, y.data());
  return y;
}

// phi = P' L'^-1 y
MatrixXd shapes(const MatrixXd& y, const SparseFactor& factor) {
  MatrixXd phi(y.rows(), y.cols());
  VectorXd x(y.rows());
  for (Eigen::Index i = 0; i < y.cols(); ++i) {
    factor.solve_upper(y.col(i).data(), x.data());
    phi(factor.order(), i) = x;
  }
  return phi;
}

// One pass x = A^-1 M v, A = K - sigma M, removes what is not in the range of the operator; then
// Rayleigh-Ritz on the span of x, whose stiffness x' A x = x' M v needs no product with A.
void purify(EigenPairs& pairs, const SparseMatrix& M, const SparseFactor& factor, double sigma) {
  const MatrixXd Mv = symmetric_product(M, pairs.vectors);
  const MatrixXd x = factor.solve(Mv);
  const MatrixXd stiffness = x.transpose() * Mv, gram = x.transpose() * symmetric_product(M, x);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(
      (stiffness + stiffness.transpose()) / 2, (gram + gram.transpose()) / 2);
  pairs.vectors = x * ritz.eigenvectors();
  pairs.values = sigma + ritz.eigenvalues().array();
}

} // namespace

EigenPairs lanczos(const SparseMatrix& M, const SparseFactor& factor, double sigma,
                   const LanczosSettings& settings) {
  const int n = static_cast<int>(M.rows());
  const int count = std::min(settings.count, n - 1);
  // Wide enough for most runs to need no restart; at least 2 count + 20.
  const int subspace =
      std::min(n, std::max(settings.subspace, std::max(2 * count + 20, 3 * count + 16)));
  const SparseMatrix pruned =
      M.pruned(); // M has the pattern of K; two thirds of a shell's are zero
  ShiftInvert shift_invert(pruned, factor);
  Spectra::SymEigsSolver<ShiftInvert> solver(shift_invert, count, subspace);
  const VectorXd start = start_vector(shift_invert, settings.seed);
  constexpr int max_restarts = 300;
  solver.init(start.data());
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, max_restarts, 1e-8,
                                    Spectra::SortRule::LargestAlge);
  EigenPairs pairs;
  pairs.operations = static_cast<int>(solver.num_operations());
  pairs.converged = solver.info() == Spectra::CompInfo::Successful;
  if (!pairs.converged)
    pairs.reason = "Lanczos converged " + std::to_string(found) + " of " + std::to_string(count) +
                   " modes in " + std::to_string(max_restarts) + " restarts";
  pairs.values = sigma + solver.eigenvalues().cwiseInverse().array();
  pairs.vectors = shapes(solver.eigenvectors(), factor);
  if (pairs.vectors.cols() > 0) purify(pairs, pruned, factor, sigma);
  return pairs;
}

} // namespace plica
