#include "diagnose/predict/affine_modes.hpp"

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
constexpr Index near_modes = 20; // of those, what a small change of a group mixes

} // namespace

double AffineModes::hertz(Index i) const {
  return omega(i) / (2 * std::numbers::pi);
}

int AffineModes::nominal(Index i) const {
  Index most = 0;
  likeness.col(i).cwiseAbs().maxCoeff(&most);
  return int(most);
}

VectorXd damping_by_likeness(const MatrixXd& likeness, const VectorXd& zeta) {
  const double otherwise = zeta.mean();
  VectorXd own(likeness.cols());
  for (Index i = 0; i < own.size(); ++i) {
    const VectorXd share = likeness.col(i).array().square();
    const double known = share.sum();
    own[i] = (share.dot(zeta) + std::max(0., 1 - known) * otherwise) / std::max(1., known);
  }
  return own;
}

FreeAffineModel::FreeAffineModel(const AffineModel& f, const std::vector<int>& free,
                                 const VectorXd& zeta)
    : K_(f.K(free, free)), M_(f.M(free, free)), load_(f.load(free, Eigen::all)),
      marked_(f.marked(Eigen::all, free)), nominal_(M_ * f.nominal(free, Eigen::all)),
      suspension_(f.suspension), products_(f.products), zeta_(zeta) {
  suspension_.rigid = f.suspension.rigid(free, Eigen::all);
  const auto kept = [&](const MatrixXd& whole) {
    return whole.isZero(0) ? MatrixXd() : MatrixXd(whole(free, free));
  };
  for (std::size_t k = 0; k < f.dK.size(); ++k) {
    dK_.push_back(kept(f.dK[k]));
    dM_.push_back(kept(f.dM[k]));
    d_load_.emplace_back(f.d_load[k](free, Eigen::all));
  }
}

std::optional<AffineModes> FreeAffineModel::modes(const VectorXd& of_changes, int group) const {
  const VectorXd c = with_products(of_changes, products_);
  auto found = reduced_modes(summed(K_, dK_, c), summed(M_, dM_, c), suspension_, most_modes);
  if (!found) return std::nullopt;
  const MatrixXd& q = found->q;
  AffineModes m;
  m.lambda = std::move(found->lambda);
  m.gamma = q.transpose() * summed(load_, d_load_, c);
  m.marked = marked_ * q;
  m.likeness = nominal_.transpose() * q;
  if (group >= 0) m.group = q.transpose() * group_stiffness(of_changes, group) * q;
  m.zeta = damping_by_likeness(m.likeness, zeta_);
  return m;
}

MatrixXd FreeAffineModel::group_stiffness(const VectorXd& of_changes, int group) const {
  MatrixXd K = dK_[std::size_t(group)];
  if (K.size() == 0) K = MatrixXd::Zero(K_.rows(), K_.cols());
  for (std::size_t k = 0; k < products_.size(); ++k) {
    const auto& [a, b] = products_[k];
    const MatrixXd& together = dK_[std::size_t(of_changes.size()) + k];
    if (together.size() == 0) continue;
    if (a == group) K += of_changes[b] * together;
    if (b == group) K += of_changes[a] * together;
  }
  return K;
}

AffineModes FreeAffineModel::changed(const AffineModes& modes, double more) const {
  const Index n = std::min(near_modes, modes.lambda.size());
  MatrixXd K = more * modes.group.topLeftCorner(n, n);
  K.diagonal() += modes.lambda.head(n);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pairs(K);
  const MatrixXd& q = pairs.eigenvectors();
  AffineModes m;
  m.lambda = pairs.eigenvalues().cwiseMax(1e-12 * modes.lambda[0]);
  m.gamma = q.transpose() * modes.gamma.topRows(n);
  m.marked = modes.marked.leftCols(n) * q;
  m.likeness = modes.likeness.leftCols(n) * q;
  m.zeta = damping_by_likeness(m.likeness, zeta_);
  return m;
}

} // namespace plica
