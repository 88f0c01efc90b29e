// Spectra's long vector operations through BLAS.
#define EIGEN_USE_BLAS
#include "solve/lanczos.hpp"

#include "solve/shift_invert.hpp"

#include <Eigen/Eigenvalues>
#include <Spectra/SymEigsSolver.h>

namespace plica {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void purify(EigenPairs& pairs, const SparseMatrix& M, const SparseFactor& factor, double sigma) {
  const MatrixXd Mv = symmetric_product(M, pairs.vectors);
  const MatrixXd x = factor.solve(Mv);
  const MatrixXd stiffness = x.transpose() * Mv, gram = x.transpose() * symmetric_product(M, x);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(
      (stiffness + stiffness.transpose()) / 2, (gram + gram.transpose()) / 2);
  pairs.vectors = x * ritz.eigenvectors();
  pairs.values = sigma + ritz.eigenvalues().array();
}

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
  const VectorXd start = shift_invert.random_in_range(1, settings.seed);
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
  pairs.vectors = shift_invert.shapes(solver.eigenvectors());
  if (pairs.vectors.cols() > 0) purify(pairs, pruned, factor, sigma);
  return pairs;
}

} // namespace plica
