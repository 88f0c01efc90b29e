#include "diagnose/predict/family_modes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index most_modes = 40;
constexpr double small = 0.01;   // shift, in terms of the lowest mode
constexpr Index near_modes = 20; // of those, what a small change of a group mixes

} // namespace

double FamilyModes::hertz(Index i) const {
  return omega(i) / (2 * std::numbers::pi);
}

MatrixXd summed(const MatrixXd& A, const std::vector<MatrixXd>& dA, const VectorXd& coefficients) {
  MatrixXd sum = A;
  for (std::size_t k = 0; k < dA.size(); ++k)
    if (coefficients[Index(k)] != 0) sum += coefficients[Index(k)] * dA[k];
  return sum;
}

FreeFamily::FreeFamily(const ReducedFamily& f, const std::vector<int>& free, const VectorXd& zeta)
    : K_(f.K(free, free)), M_(f.M(free, free)), load_(f.load(free, Eigen::all)),
      marked_(f.marked(Eigen::all, free)), nominal_(M_ * f.nominal(free, Eigen::all)),
      suspended_(f.suspended), shift_(f.suspended ? small * f.lambda[0] : 0),
      rigid_(f.rigid(free, Eigen::all)), rigid_mass_(f.rigid_mass), zeta_(zeta) {
  for (std::size_t k = 0; k < f.dK.size(); ++k) {
    dK_.emplace_back(f.dK[k](free, free));
    dM_.emplace_back(f.dM[k](free, free));
    d_load_.emplace_back(f.d_load[k](free, Eigen::all));
  }
}

std::optional<FamilyModes> FreeFamily::modes(const VectorXd& c, int group) const {
  const MatrixXd M = summed(M_, dM_, c);
  MatrixXd K = summed(K_, dK_, c);
  if (suspended_) K += shift_ * M;
  if (Eigen::LLT<MatrixXd>(K).info() != Eigen::Success) return std::nullopt;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(M, K);
  if (pairs.info() != Eigen::Success) return std::nullopt;
  const VectorXd& theta = pairs.eigenvalues(); // 1 / (lambda + shift), increasing
  const Index n = theta.size();
  Index count = 0;
  while (count < std::min(n, most_modes) && theta[n - 1 - count] > 1e-12 * theta[n - 1]) ++count;
  if (count == 0) return std::nullopt;
  FamilyModes m;
  m.lambda = theta.tail(count).reverse().cwiseInverse();
  MatrixXd q =
      pairs.eigenvectors().rightCols(count).rowwise().reverse() * m.lambda.cwiseSqrt().asDiagonal();
  if (suspended_) leave_out_rigid(m.lambda, q);
  if (q.cols() == 0) return std::nullopt;
  m.gamma = q.transpose() * summed(load_, d_load_, c);
  m.marked = marked_ * q;
  m.likeness = nominal_.transpose() * q;
  if (group >= 0) m.group = q.transpose() * dK_[std::size_t(group)] * q;
  damp(m);
  return m;
}

void FreeFamily::leave_out_rigid(VectorXd& lambda, MatrixXd& q) const {
  const MatrixXd moved = rigid_.transpose() * q;
  const VectorXd shares =
      moved.cwiseProduct(MatrixXd(rigid_mass_.ldlt().solve(moved))).colwise().sum();
  constexpr double is_rigid = 0.5;
  std::vector<Index> kept;
  for (Index i = 0; i < q.cols(); ++i)
    if (shares[i] < is_rigid) kept.push_back(i);
  q = q(Eigen::all, kept).eval();
  lambda = (lambda(kept).array() - shift_).matrix().eval();
}

FamilyModes FreeFamily::changed(const FamilyModes& modes, double more) const {
  const Index n = std::min(near_modes, modes.lambda.size());
  MatrixXd K = more * modes.group.topLeftCorner(n, n);
  K.diagonal() += modes.lambda.head(n);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pairs(K);
  const MatrixXd& q = pairs.eigenvectors();
  FamilyModes m;
  m.lambda = pairs.eigenvalues().cwiseMax(1e-12 * modes.lambda[0]);
  m.gamma = q.transpose() * modes.gamma.topRows(n);
  m.marked = modes.marked.leftCols(n) * q;
  m.likeness = modes.likeness.leftCols(n) * q;
  damp(m);
  return m;
}

void FreeFamily::damp(FamilyModes& m) const {
  const double otherwise = zeta_.mean();
  m.zeta.resize(m.lambda.size());
  for (Index i = 0; i < m.zeta.size(); ++i) {
    const VectorXd share = m.likeness.col(i).array().square();
    const double known = share.sum();
    m.zeta[i] = (share.dot(zeta_) + std::max(0., 1 - known) * otherwise) / std::max(1., known);
  }
}

} // namespace plica
