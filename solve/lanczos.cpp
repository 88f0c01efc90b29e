// Spectra's long vector operations through BLAS.
#define EIGEN_USE_BLAS
#include "solve/lanczos.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Spectra/SymGEigsShiftSolver.h>
#include <random>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// y = (K - sigma M)^-1 x; the shift is already in the factor.
struct ShiftInvert {
  using Scalar = double;
  const SparseFactor& factor;
  Eigen::Index rows() const { return factor.rows(); }
  Eigen::Index cols() const { return factor.rows(); }
  void set_shift(const double&) const {}
  void perform_op(const double* x, double* y) const { factor.solve(x, y); }
};

// y = M x, on all cores: a column of the full matrix is also a row, summed in one order. Spectra
// asks for several products in each step.
struct MassProduct {
  using Scalar = double;
  SparseMatrix full;
  Eigen::Index rows() const { return full.rows(); }
  Eigen::Index cols() const { return full.cols(); }
  void perform_op(const double* x, double* y) const {
    constexpr Eigen::Index worth_a_team = 500000;
#pragma omp parallel for schedule(static) if (full.nonZeros() > worth_a_team)
    for (int i = 0; i < full.outerSize(); ++i) {
      double sum = 0;
      for (SparseMatrix::InnerIterator it(full, i); it; ++it) sum += it.value() * x[it.row()];
      y[i] = sum;
    }
  }
};

VectorXd start_vector(const SparseMatrix& M, const SparseFactor& factor, unsigned seed) {
  std::mt19937 random(seed);
  VectorXd v(M.rows());
  for (double& x : v) x = double(random()) / double(std::mt19937::max()) - 0.5;
  return factor.solve(symmetric_product(M, v));
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
  ShiftInvert shift_invert{factor};
  const SparseMatrix pruned =
      M.pruned(); // M has the pattern of K; two thirds of a shell's are zero
  MassProduct mass{pruned.selfadjointView<Eigen::Lower>()};
  Spectra::SymGEigsShiftSolver<ShiftInvert, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(
      shift_invert, mass, count, subspace, sigma);
  const VectorXd start = start_vector(pruned, factor, settings.seed);
  constexpr int max_restarts = 300;
  solver.init(start.data());
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, max_restarts, 1e-8,
                                    Spectra::SortRule::SmallestAlge);
  EigenPairs pairs;
  pairs.operations = static_cast<int>(solver.num_operations());
  pairs.converged = solver.info() == Spectra::CompInfo::Successful;
  if (!pairs.converged)
    pairs.reason = "Lanczos converged " + std::to_string(found) + " of " + std::to_string(count) +
                   " modes in " + std::to_string(max_restarts) + " restarts";
  pairs.values = solver.eigenvalues();
  pairs.vectors = solver.eigenvectors();
  if (pairs.vectors.cols() > 0) purify(pairs, pruned, factor, sigma);
  return pairs;
}

} // namespace plica
