#include "elements/joint_law.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// Force and slope of the piecewise-linear curve.
std::array<double, 2> on_curve(const std::vector<std::array<double, 2>>& curve, double x) {
  std::size_t i = 1;
  while (i + 1 < curve.size() && curve[i][0] < x) ++i;
  const double slope = (curve[i][1] - curve[i - 1][1]) / (curve[i][0] - curve[i - 1][0]);
  return {curve[i - 1][1] + slope * (x - curve[i - 1][0]), slope};
}

// Elastic force and slope.
std::array<double, 2> elastic(const JointLaw& law, double x) {
  std::array<double, 2> f{law.stiffness * x + law.cubic * x * x * x,
                          law.stiffness + 3 * law.cubic * x * x};
  if (law.curve.empty()) return f;
  const auto [force, slope] = on_curve(law.curve, x);
  return {f[0] + force, f[1] + slope};
}

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

} // namespace

double JointLaw::stuck_stiffness() const {
  double k = elastic(*this, 0)[1];
  for (const JenkinsSlider& s : sliders) k += s.stiffness;
  return k;
}

double SegalmanIwan::pm() const {
  return F_S * (1 + beta) / (K_T * (beta + (chi + 1) / (chi + 2)));
}
double SegalmanIwan::R() const {
  return F_S * (chi + 1) / (std::pow(pm(), chi + 2) * (beta + (chi + 1) / (chi + 2)));
}
double SegalmanIwan::S() const {
  return F_S * beta / (pm() * (beta + (chi + 1) / (chi + 2)));
}

std::vector<JenkinsSlider> sliders_of(const SegalmanIwan& iwan, int count) {
  require(iwan.K_T > 0, "K_T of an Iwan model must be above zero");
  require(iwan.F_S > 0, "F_S of an Iwan model must be above zero");
  require(iwan.chi > -1 && iwan.chi <= 0, "chi of an Iwan model must lie in (-1, 0]");
  require(iwan.beta >= 0, "beta of an Iwan model must not be negative");
  require(count > 0, "an Iwan model needs a slider");
  // Sliders by slip displacement phi, density R phi^chi up to pm: a step between a and b has their
  // stiffness and their slip force, so that stiffness at rest and slip force are exact.
  const double pm = iwan.pm(), R = iwan.R(), chi = iwan.chi;
  constexpr double smallest = 1e-4; // of pm: below, one step
  std::vector<JenkinsSlider> sliders;
  double a = 0;
  for (int i = 0; i < count; ++i) {
    const double b =
        count == 1 ? pm : pm * std::pow(smallest, 1 - double(i) / double(count - 1));
    sliders.push_back({R / (chi + 1) * (std::pow(b, chi + 1) - std::pow(a, chi + 1)),
                       R / (chi + 2) * (std::pow(b, chi + 2) - std::pow(a, chi + 2))});
    a = b;
  }
  if (iwan.beta > 0) sliders.push_back({iwan.S(), iwan.S() * pm});
  return sliders;
}

double first_loading(const JointLaw& law, double displacement) {
  double force = elastic(law, displacement)[0];
  for (const JenkinsSlider& s : law.sliders)
    force += std::clamp(s.stiffness * displacement, -s.slip_force, s.slip_force);
  return force;
}

PeriodForces period_forces(const JointLaw& law, const VectorXd& x, const MatrixXd& dx) {
  const Index steps = x.size(), parameters = dx.cols();
  PeriodForces out{VectorXd(steps), MatrixXd(steps, parameters)};
  for (Index k = 0; k < steps; ++k) {
    const auto [force, slope] = elastic(law, x[k]);
    out.force[k] = force;
    out.derivative.row(k) = slope * dx.row(k);
  }
  // From rest through one period to the cycle that repeats (Masing), then the period that counts.
  RowVectorXd slider_derivative(parameters);
  for (const JenkinsSlider& s : law.sliders) {
    double f = std::clamp(s.stiffness * x[0], -s.slip_force, s.slip_force);
    bool stuck = std::abs(s.stiffness * x[0]) < s.slip_force;
    slider_derivative = stuck ? RowVectorXd(s.stiffness * dx.row(0)) : RowVectorXd::Zero(parameters);
    for (Index k = 1; k < 2 * steps; ++k) {
      const Index now = k % steps, before = (k - 1) % steps;
      const double trial = f + s.stiffness * (x[now] - x[before]);
      f = std::clamp(trial, -s.slip_force, s.slip_force);
      if (f == trial)
        slider_derivative += s.stiffness * (dx.row(now) - dx.row(before));
      else
        slider_derivative.setZero();
      if (k < steps) continue;
      out.force[now] += f;
      out.derivative.row(now) += slider_derivative;
    }
    // k = 2 steps is the first again: its value in the cycle that repeats.
  }
  return out;
}

double loop_energy(const JointLaw& law, double amplitude) {
  double energy = 0;
  for (const JenkinsSlider& s : law.sliders) {
    const double slip = s.slip_force / s.stiffness;
    if (amplitude > slip) energy += 4 * s.slip_force * (amplitude - slip);
  }
  return energy;
}

} // namespace plica
