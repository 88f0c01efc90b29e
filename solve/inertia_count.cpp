#include "solve/inertia_count.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// DOFs where the vectors are large and independent of each other: `rounds` rounds of pivoted QR,
// each on the DOFs the earlier ones left.
std::vector<int> pivot_dofs(const SparseMatrix& M, const MatrixXd& vectors, int rounds) {
  const VectorXd weight = VectorXd(M.diagonal()).cwiseMax(0).cwiseSqrt();
  MatrixXd rows = (weight.asDiagonal() * vectors).transpose();
  std::vector<int> chosen;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows);
    for (Eigen::Index i = 0; i < qr.nonzeroPivots(); ++i) {
      const int dof = qr.colsPermutation().indices()[i];
      chosen.push_back(dof);
      rows.col(dof).setZero();
    }
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

struct Partition {
  SparseMatrix rest; // A with the rows and columns p replaced by those of the identity
  MatrixXd pp, rp;   // rp has zeros in the rows p
};

Partition partition(const SparseMatrix& A, const std::vector<int>& p) {
  const auto k = static_cast<Eigen::Index>(p.size());
  std::vector<int> number(A.rows(), -1);
  for (Eigen::Index i = 0; i < k; ++i) number[p[i]] = static_cast<int>(i);
  Partition part{A, MatrixXd::Zero(k, k), MatrixXd::Zero(A.rows(), k)};
  for (int j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(part.rest, j); it; ++it) {
      const int i = static_cast<int>(it.row()), a = number[i], b = number[j];
      if (a < 0 && b < 0) continue;
      if (a >= 0 && b >= 0) part.pp(a, b) = part.pp(b, a) = it.value();
      if (a >= 0 && b < 0) part.rp(j, a) = it.value();
      if (a < 0 && b >= 0) part.rp(i, b) = it.value();
      it.valueRef() = i == j ? 1 : 0;
    }
  return part;
}

InertiaCount count_schur(const Partition& part, const SparseFactor& factor) {
  const MatrixXd S = part.pp - part.rp.transpose() * factor.solve(part.rp);
  const VectorXd scale = S.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scale.asDiagonal() * S * scale.asDiagonal());
  const VectorXd size = eigen.eigenvalues().cwiseAbs();
  InertiaCount count;
  count.below = static_cast<int>((eigen.eigenvalues().array() < 0).count());
  count.margin = size.minCoeff() / size.maxCoeff();
  count.removed = static_cast<int>(S.rows());
  return count;
}

} // namespace

SparseMatrix shifted(const SparseMatrix& K, const SparseMatrix& M, double sigma) {
  SparseMatrix A = K;
  const double* m = M.valuePtr();
  double* a = A.valuePtr();
  for (Eigen::Index i = 0; i < A.nonZeros(); ++i) a[i] -= sigma * m[i];
  return A;
}

InertiaCount count_below(const SparseMatrix& K, const SparseMatrix& M, double sigma,
                         const MatrixXd& vectors, SparseFactor& factor) {
  const SparseMatrix A = shifted(K, M, sigma);
  constexpr int first_rounds = 2, attempts = 8;
  std::vector<int> p = pivot_dofs(M, vectors, first_rounds);
  for (int attempt = 1; attempt <= attempts; ++attempt) {
    const Partition part = partition(A, p);
    const FactorStatus status = factor.factorise(part.rest);
    if (status.ok) return count_schur(part, factor);
    // More of the vectors' DOFs, and the one at which Cholesky stopped.
    for (int dof : pivot_dofs(M, vectors, first_rounds + attempt)) p.push_back(dof);
    if (status.failed_column >= 0) p.push_back(status.failed_column);
    std::sort(p.begin(), p.end());
    p.erase(std::unique(p.begin(), p.end()), p.end());
  }
  InertiaCount none;
  none.removed = static_cast<int>(p.size());
  none.reason = "K - sigma M without " + std::to_string(p.size()) +
                " degrees of freedom is still indefinite: more modes lie below sigma than the "
                "vectors span";
  return none;
}

InertiaCount count_below_ldlt(const SparseMatrix& K, const SparseMatrix& M, double sigma) {
  SparseFactor factor(K, Factorisation::ldlt);
  const SparseMatrix A = shifted(K, M, sigma);
  const FactorStatus status = factor.factorise(A);
  InertiaCount count;
  if (!status.ok) {
    count.reason = status.reason;
    return count;
  }
  VectorXd x = VectorXd::LinSpaced(A.rows(), -1, 1);
  const VectorXd b = symmetric_product(A, x);
  const VectorXd residual = symmetric_product(A, factor.solve(b)) - b;
  count.margin = residual.norm() / b.norm(); // backward error of the unpivoted factor
  if (count.margin > 1e-6)
    count.reason = "the unpivoted LDL' factor is inaccurate: sigma is too near an eigenvalue";
  else
    count.below = factor.negative_pivots();
  return count;
}

} // namespace plica
