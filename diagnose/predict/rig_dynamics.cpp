#include "diagnose/predict/rig_dynamics.hpp"

#include "diagnose/predict/rig_stiffness.hpp"
#include "diagnose/predict/state_model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// sum_j 2 zeta_j omega_j (M q_j)(M q_j)' of the modes with the ends held.
MatrixXd viscous(const StateModel& state, const std::vector<int>& inside, const MatrixXd& K,
                 const MatrixXd& M) {
  const VectorXd& ratios = state.nominal->viscous;
  if (ratios.isZero(0)) return {};
  const MatrixXd M_ii = M(inside, inside);
  const auto modes = reduced_modes(K(inside, inside), M_ii, {}, Index(inside.size()));
  if (!modes) return {};
  const MatrixXd momentum = M_ii * modes->q;
  const MatrixXd likeness = state.whole.nominal(inside, Eigen::all).transpose() * momentum;
  const VectorXd zeta = damping_by_likeness(likeness, ratios);
  const VectorXd c = 2 * zeta.cwiseProduct(modes->lambda.cwiseSqrt());
  return momentum * c.asDiagonal() * momentum.transpose();
}

} // namespace

RigDynamics::RigDynamics(const StateModel& state, const std::vector<std::string>& ends,
                         const VectorXd& coefficients, double damping,
                         const std::optional<SlipGroup>& group)
    : state_(state), damping_(damping) {
  K_ = state.whole.stiffness(coefficients);
  M_ = state.whole.mass_matrix(coefficients);
  ends_ = cap_coordinates(*state.nominal, ends);
  for (int i = 0; i < int(K_.rows()); ++i)
    if (std::find(ends_.begin(), ends_.end(), i) == ends_.end()) others_.push_back(i);
  constexpr double share = 0.5; // of the last mode of the basis
  if (const VectorXd& lambda = state.nominal->model->lambda(); lambda.size() > 0)
    highest_ = share * std::sqrt(lambda[lambda.size() - 1]);
  if (ends_.empty()) return;
  if (group) {
    group_ = state.whole.stiffness_of(group->change, coefficients);
    group_stiffness_ = group->stiffness;
  }
  C_ = viscous(state, others_, K_, M_);
}

MatrixXcd RigDynamics::matrix_at(double omega, Complex softer) const {
  MatrixXcd D = (K_ - omega * omega * M_).cast<Complex>();
  if (group_.size() > 0 && softer != 0.) D -= softer * group_;
  for (std::size_t k = 0; k < state_.losses.size(); ++k)
    D += Complex(0, damping_ * state_.nominal->losses[k].loss(omega)) * state_.losses[k];
  if (C_.size() > 0) D(others_, others_) += Complex(0, damping_ * omega) * C_;
  return D;
}

std::optional<Complex1212> RigDynamics::at(double hertz, Complex softer) const {
  const double omega = 2 * std::numbers::pi * hertz;
  if (ends_.empty() || omega > highest_) return std::nullopt;
  const MatrixXcd D = matrix_at(omega, softer);
  Complex1212 Z = D(ends_, ends_);
  if (others_.empty()) return Z;
  const MatrixXcd coupling = D(others_, ends_);
  Z -= coupling.transpose() * MatrixXcd(D(others_, others_)).partialPivLu().solve(coupling);
  return Z;
}

double RigDynamics::stretch(int coordinate, double softer) const {
  if (group_.size() == 0 || ends_.empty()) return 0;
  const MatrixXd K = K_ - softer * group_;
  VectorXd v = VectorXd::Zero(K.rows());
  v[ends_[std::size_t(coordinate)]] = 1;
  if (!others_.empty())
    v(others_) = -MatrixXd(K(others_, others_)).ldlt().solve(VectorXd((K * v)(others_)));
  return std::sqrt(std::max(0., v.dot(group_ * v)) / group_stiffness_);
}

} // namespace plica
