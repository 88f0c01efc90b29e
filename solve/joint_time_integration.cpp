#include "solve/joint_time_integration.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

class Integrator {
public:
  Integrator(const JointedStructure& s, double omega, double level, int harmonics,
             const TimeSettings& settings)
      : s_(s), settings_(settings), omega_(omega), level_(level), harmonics_(harmonics),
        h_(2 * pi / omega / settings.steps),
        damping_(2 * s.zeta.cwiseProduct(s.lambda.cwiseSqrt()) +
                 s.eta.cwiseProduct(s.lambda) / omega),
        compliance_((s.lambda + 2 / h_ * damping_).array() + 4 / (h_ * h_)), q_(zero()), v_(zero()),
        a_(zero()) {
    compliance_ = compliance_.cwiseInverse().eval();
    add_dampers();
    flexibility_ = s.joints.transpose() * compliant(s.joints);
    at_offset_ = VectorXd::Zero(s.joints.cols());
    for (std::size_t j = 0; j < s.laws.size(); ++j) {
      forces_.emplace_back();
      for (const JenkinsSlider& slider : s.laws[j].sliders) {
        forces_.back().push_back(force_at_offset(s.laws[j], slider));
        at_offset_[Index(j)] += forces_.back().back();
      }
    }
    x_ = VectorXd::Zero(s.joints.cols());
  }

  void start(const PeriodicPoint& point, const std::vector<int>& orders) {
    for (std::size_t k = 0; k < orders.size(); ++k) {
      const auto n = double(orders[k]) * omega_;
      q_ += point.modes.row(Index(k)).real().transpose();
      v_ -= n * point.modes.row(Index(k)).imag().transpose();
      a_ -= n * n * point.modes.row(Index(k)).real().transpose();
    }
    // The sliders as a period of that motion leaves them.
    const HarmonicBasis basis(orders, std::max(2048, 8 * (orders.back() + 1)));
    for (Index j = 0; j < x_.size(); ++j) {
      const VectorXd motion = basis.to_time * unknowns(basis, point.joints.col(j));
      auto& held = forces_[std::size_t(j)];
      for (Index k = 0; k < 2 * motion.size() + 1; ++k) {
        const double now = motion[k % motion.size()];
        for (std::size_t i = 0; i < held.size(); ++i)
          held[i] = slid(s_.laws[std::size_t(j)].sliders[i], held[i], now - x_[j]);
        x_[j] = now;
      }
    }
  }

  SteadyMotion run() {
    SteadyMotion out;
    MatrixXcd ten_ago;
    for (out.periods = 1; out.periods <= settings_.most_periods; ++out.periods) {
      period(out);
      if (out.periods % 10 != 0) continue;
      if (ten_ago.size() > 0) {
        out.change = (out.modes.row(1) - ten_ago).norm() / out.modes.row(1).norm();
        if ((out.settled = out.change < settings_.settled)) break;
      }
      ten_ago = out.modes.row(1);
    }
    return out;
  }

private:
  VectorXd zero() const { return VectorXd::Zero(s_.lambda.size()); }

  static double slid(const JenkinsSlider& s, double held, double dx) {
    return std::clamp(held + s.stiffness * dx, -s.slip_force, s.slip_force);
  }

  void add_dampers() {
    if (s_.added.empty()) return;
    const Eigen::VectorXcd added = added_at(s_, 1, omega_);
    spring_ = added.real();
    dashpot_ = added.imag() / omega_;
    const VectorXd G = spring_ + 2 / h_ * dashpot_;
    of_springs_ = compliance_.asDiagonal() * s_.dampers;
    MatrixXd A = G.asDiagonal() * (s_.dampers.transpose() * of_springs_);
    A.diagonal().array() += 1;
    between_ = A.partialPivLu().solve(MatrixXd(G.asDiagonal()));
  }

  // Motion at the end of a step under a force there.
  MatrixXd compliant(const MatrixXd& force) const {
    MatrixXd motion = compliance_.asDiagonal() * force;
    if (!s_.added.empty()) motion -= of_springs_ * (between_ * (s_.dampers.transpose() * motion));
    return motion;
  }

  // Forces of the joints at x, their tangents; v follows x within the step.
  void joint_forces(const VectorXd& x, const VectorXd& rate, VectorXd& F, VectorXd& K) const {
    for (Index j = 0; j < x.size(); ++j) {
      const JointLaw& law = s_.laws[std::size_t(j)];
      const ElasticForce f = elastic_force(law, x[j], rate[j]);
      F[j] = f.force - at_offset_[j];
      K[j] = f.by_motion + f.by_velocity * 2 / h_;
      for (std::size_t i = 0; i < law.sliders.size(); ++i) {
        const JenkinsSlider& s = law.sliders[i];
        const double trial = forces_[std::size_t(j)][i] + s.stiffness * (x[j] - x_[j]);
        F[j] += std::clamp(trial, -s.slip_force, s.slip_force);
        if (std::abs(trial) < s.slip_force) K[j] += s.stiffness;
      }
    }
  }

  void step(double t) {
    const VectorXd load = level_ * std::cos(omega_ * t) * s_.input;
    const VectorXd before = (2 / h_) * q_ + v_;
    VectorXd history =
        load + (4 / (h_ * h_)) * q_ + (4 / h_) * v_ + a_ + damping_.cwiseProduct(before);
    if (!s_.added.empty())
      history += s_.dampers * dashpot_.cwiseProduct(s_.dampers.transpose() * before);
    const VectorXd free = compliant(history);
    const VectorXd target = s_.joints.transpose() * free;
    const VectorXd rate_before = s_.joints.transpose() * v_;
    VectorXd x = x_ + h_ * rate_before, F(x.size()), K(x.size());
    for (int k = 0; k < 50; ++k) {
      joint_forces(x, 2 / h_ * (x - x_) - rate_before, F, K);
      const VectorXd r = x - target + flexibility_ * F;
      if (r.norm() <= 1e-12 * (x.norm() + target.norm())) break;
      MatrixXd A = flexibility_ * K.asDiagonal();
      A.diagonal().array() += 1;
      x -= A.partialPivLu().solve(r);
    }
    const VectorXd q = free - compliant(s_.joints * F);
    const VectorXd v = 2 / h_ * (q - q_) - v_;
    a_ = 4 / (h_ * h_) * (q - q_) - 4 / h_ * v_ - a_;
    q_ = q;
    v_ = v;
    for (Index j = 0; j < x.size(); ++j)
      for (std::size_t i = 0; i < forces_[std::size_t(j)].size(); ++i) {
        double& held = forces_[std::size_t(j)][i];
        held = slid(s_.laws[std::size_t(j)].sliders[i], held, x[j] - x_[j]);
      }
    x_ = x;
  }

  void period(SteadyMotion& out) {
    out.joints = MatrixXcd::Zero(harmonics_ + 1, x_.size());
    out.modes = MatrixXcd::Zero(harmonics_ + 1, q_.size());
    for (int k = 1; k <= settings_.steps; ++k) {
      step(k * h_);
      for (int n = 0; n <= harmonics_; ++n) {
        const Complex turn = (n == 0 ? 1. : 2.) / settings_.steps *
                             std::polar(1., -2 * pi * n * k / settings_.steps);
        out.joints.row(n) += turn * x_.transpose();
        out.modes.row(n) += turn * q_.transpose();
      }
    }
  }

  const JointedStructure& s_;
  const TimeSettings& settings_;
  double omega_, level_;
  int harmonics_;
  double h_;
  VectorXd damping_, compliance_;
  VectorXd spring_, dashpot_; // of the damped springs at the excitation frequency
  MatrixXd of_springs_, between_;
  MatrixXd flexibility_; // of the joints within a step
  VectorXd q_, v_, a_, x_;
  std::vector<std::vector<double>> forces_; // of the sliders
  VectorXd at_offset_; // what those of a joint bear where its motion counts from
};

} // namespace

SteadyMotion integrate(const JointedStructure& structure, double omega, double level, int harmonics,
                       const TimeSettings& settings, const std::vector<int>& orders,
                       const PeriodicPoint& start) {
  Integrator integrator(structure, omega, level, harmonics, settings);
  if (start.modes.size() > 0) integrator.start(start, orders);
  return integrator.run();
}

} // namespace plica
