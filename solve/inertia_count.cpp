#include "solve/inertia_count.hpp"

#include "solve/signed_cholesky.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// DOFs within `steps` steps of the graph of K around the given ones.
std::vector<int> neighbourhood(const SparseMatrix& K, std::vector<int> front, int steps,
                               std::vector<bool>& seen) {
  std::vector<int> patch;
  for (int step = 0; step <= steps; ++step) {
    std::vector<int> next;
    for (int dof : front) {
      if (!seen[dof]) patch.push_back(dof);
      seen[dof] = true;
    }
    if (step == steps) break;
    for (int dof : front)
      for (SparseMatrix::InnerIterator it(K, dof); it; ++it)
        if (!seen[it.row()]) next.push_back(static_cast<int>(it.row()));
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    front = std::move(next);
  }
  return patch;
}

// DOFs where the vectors are large and independent of each other: `rounds` rounds of pivoted QR.
// After each round a patch round the chosen DOFs is left out, so that the next ones lie elsewhere:
// to hold a shell at one more point of the same place would not make it stiffer.
std::vector<int> pivot_dofs(const SparseMatrix& K, const VectorXd& weight, const MatrixXd& vectors,
                            int rounds, int steps) {
  const SparseMatrix full = K.selfadjointView<Eigen::Lower>();
  MatrixXd rows = (weight.asDiagonal() * vectors).transpose();
  std::vector<int> chosen;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows);
    std::vector<int> now;
    for (Eigen::Index i = 0; i < qr.nonzeroPivots(); ++i)
      now.push_back(qr.colsPermutation().indices()[i]);
    chosen.insert(chosen.end(), now.begin(), now.end());
    std::vector<bool> seen(full.rows(), false);
    for (int dof : neighbourhood(full, now, steps, seen)) rows.col(dof).setZero();
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

// Union of two increasing lists.
std::vector<int> with(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

struct Partition {
  SparseMatrix rest; // A with the rows and columns p replaced by those of the identity
  MatrixXd pp;
  SparseMatrix rp; // empty in the rows p
};

Partition partition(const SparseMatrix& A, const std::vector<int>& p) {
  const auto k = static_cast<Eigen::Index>(p.size()), n = A.rows();
  std::vector<int> number(n, -1);
  for (Eigen::Index i = 0; i < k; ++i) number[p[i]] = static_cast<int>(i);
  Partition part{A, MatrixXd::Zero(k, k), SparseMatrix(n, k)};
  std::vector<Eigen::Triplet<double>> rp;
  for (int j = 0; j < n; ++j)
    for (SparseMatrix::InnerIterator it(part.rest, j); it; ++it) {
      const int i = static_cast<int>(it.row()), a = number[i], b = number[j];
      if (a < 0 && b < 0) continue;
      if (a >= 0 && b >= 0) part.pp(a, b) = part.pp(b, a) = it.value();
      if (a >= 0 && b < 0) rp.emplace_back(j, a, it.value());
      if (a < 0 && b >= 0) rp.emplace_back(i, b, it.value());
      it.valueRef() = i == j ? 1 : 0;
    }
  part.rp.setFromTriplets(rp.begin(), rp.end());
  return part;
}

InertiaCount count_schur(const Partition& part, const SparseFactor& factor) {
  const MatrixXd S = part.pp - factor.quadratic_form(part.rp);
  const VectorXd scale = S.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      MatrixXd(scale.asDiagonal() * S * scale.asDiagonal()));
  const VectorXd size = eigen.eigenvalues().cwiseAbs();
  InertiaCount count;
  count.below = static_cast<int>((eigen.eigenvalues().array() < 0).count());
  count.margin = size.minCoeff() / size.maxCoeff();
  count.removed = static_cast<int>(S.rows());
  return count;
}

// That the errors of the factor, of the size eps sqrt(squares_i squares_j), do not move what lies
// on one side of sigma to the other.
bool is_exact_enough(const SignedCholesky& factor, const SparseMatrix& K, const SparseMatrix& M,
                     double sigma, const MatrixXd& vectors) {
  constexpr double safety = 10, eps = std::numeric_limits<double>::epsilon();
  constexpr Eigen::Index stripe = 32;
  const VectorXd root = factor.squares().cwiseSqrt();
  for (Eigen::Index first = 0; first < vectors.cols(); first += stripe) {
    const MatrixXd X = vectors.middleCols(first, std::min(stripe, vectors.cols() - first));
    const auto form = [&](const SparseMatrix& A) {
      return VectorXd(X.cwiseProduct(symmetric_product(A, X)).colwise().sum());
    };
    const VectorXd error =
        safety * eps * (root.asDiagonal() * X).colwise().squaredNorm().transpose();
    const VectorXd distance = (form(K) - sigma * form(M).cwiseAbs()).cwiseAbs();
    if (!(error.array() < distance.array()).all()) return false;
  }
  return true;
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
  const SignedCholesky signs(shifted(K, M, sigma), factor.order());
  constexpr Eigen::Index many = 200; // vectors: to choose DOFs by them would take longer than LDL'
  if (!signs.keeps_digits(K) || !is_exact_enough(signs, K, M, sigma, vectors))
    return vectors.cols() < many ? count_below_by_schur(K, M, sigma, vectors, factor)
                                 : count_below_ldlt(K, M, sigma);
  InertiaCount count;
  count.below = signs.negative_pivots();
  return count;
}

InertiaCount count_below_by_schur(const SparseMatrix& K, const SparseMatrix& M, double sigma,
                                  const MatrixXd& vectors, SparseFactor& factor) {
  const VectorXd weight = VectorXd(M.diagonal()).cwiseMax(0).cwiseSqrt();
  constexpr int first_rounds = 7, more_rounds = 4, attempts = 5;
  int steps = std::max(2, static_cast<int>(std::sqrt(double(K.rows()) / 900)));
  std::vector<int> p;
  for (int attempt = 0; attempt < attempts; ++attempt, steps /= 2) {
    p = with(p, pivot_dofs(K, weight, vectors, first_rounds + more_rounds * attempt, steps));
    const Partition part = partition(shifted(K, M, sigma), p);
    const FactorStatus status = factor.factorise(part.rest);
    if (status.ok) return count_schur(part, factor);
    if (status.failed_column >= 0) p = with(p, {status.failed_column});
  }
  return count_below_ldlt(K, M, sigma);
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
