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

FreeAffineModel::FreeAffineModel(const AffineModel& model, const std::vector<int>& free,
                                 const VectorXd& zeta)
    : free_(model.restricted_to(free)), momentum_(free_.M * free_.nominal), zeta_(zeta) {}

std::optional<AffineModes> FreeAffineModel::modes(const VectorXd& c, int group) const {
  auto found =
      reduced_modes(free_.stiffness(c), free_.mass_matrix(c), free_.suspension, most_modes);
  if (!found) return std::nullopt;
  const MatrixXd& q = found->q;
  AffineModes m;
  m.lambda = std::move(found->lambda);
  m.gamma = q.transpose() * free_.loads(c);
  m.marked = free_.marked * q;
  m.likeness = momentum_.transpose() * q;
  if (group >= 0) m.group = q.transpose() * free_.stiffness_of(group, c) * q;
  m.zeta = damping_by_likeness(m.likeness, zeta_);
  return m;
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
