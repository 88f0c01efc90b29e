#include "solve/shock_spectrum.hpp"

#include "solve/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Extremes {
  double highest = 0, lowest = 0;
};

// Of one oscillator. Relative motion z'' + 2 zeta omega z' + omega^2 z = -a; its absolute
// acceleration is z'' + a.
Extremes extremes(const VectorXd& a, double dt, double hertz, double zeta) {
  const int parts = std::max(1, int(std::ceil(steps_per_period * hertz * dt)));
  Oscillator oscillator(2 * std::numbers::pi * hertz, zeta, dt / parts);
  Extremes found;
  const auto go = [&](double from, double to) {
    oscillator.step(-from, -to);
    const double absolute = oscillator.acceleration(-to) + to;
    found.highest = std::max(found.highest, absolute);
    found.lowest = std::min(found.lowest, absolute);
  };
  for (Index i = 1; i < a.size(); ++i) {
    const double slope = (a[i] - a[i - 1]) / parts;
    for (int k = 0; k < parts; ++k) go(a[i - 1] + k * slope, a[i - 1] + (k + 1) * slope);
  }
  const double period = std::ceil(parts / (hertz * dt)); // in steps
  for (int k = 0; k < period; ++k) go(0, 0);
  return found;
}

} // namespace

ShockSpectrum shock_spectrum(const VectorXd& acceleration, double dt, const VectorXd& hertz,
                             double zeta) {
  if (acceleration.size() < 2 || !acceleration.allFinite() || !(hertz.array() > 0).all() ||
      !(dt > 0) || !(zeta >= 0) || !(zeta < 1))
    throw std::invalid_argument(
        "shock spectrum: at least two samples, a step and frequencies above "
        "zero, and a damping in [0, 1)");
  ShockSpectrum s{
      .hertz = hertz, .positive = VectorXd(hertz.size()), .negative = VectorXd(hertz.size())};
#pragma omp parallel for schedule(dynamic)
  for (Index i = 0; i < hertz.size(); ++i) {
    const Extremes e = extremes(acceleration, dt, hertz[i], zeta);
    s.positive[i] = e.highest;
    s.negative[i] = e.lowest;
  }
  return s;
}

} // namespace plica
