#include "diagnose/weigh/cross_scatter.hpp"

#include "diagnose/readings/reading.hpp"
#include "run/results/normal_distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace plica {
namespace {

struct Moments {
  double mean = 0, variance = 0;
};

// Of ln(|own + sigma n| + floor), n standard normal: over steps of equal probability.
Moments moments(double own, double sigma) {
  constexpr int steps = 40;
  static const std::array<double, steps> normal = [] {
    std::array<double, steps> n{};
    for (int i = 0; i < steps; ++i) n[std::size_t(i)] = normal_quantile((i + 0.5) / steps);
    return n;
  }();
  double sum = 0, squares = 0;
  for (double n : normal) {
    const double y = std::log(std::abs(own + sigma * n) + cross_floor);
    sum += y;
    squares += y * y;
  }
  const double mean = sum / steps;
  return {mean, std::max(0., squares / steps - mean * mean)};
}

} // namespace

CrossLaw::CrossLaw(double power, double nominal, double expected) {
  const double own = cross_value(nominal);
  sigma_ = std::sqrt(std::max(power, std::pow(cross_value(expected), 2) - own * own));
  const Moments at_nominal = moments(own, sigma_);
  shift_ = expected - at_nominal.mean;
  variance_ = at_nominal.variance;
}

// Not less than at the nominal structure, as much of what scatters is of the specimen.
double CrossLaw::deviation(double times) const {
  constexpr double most = 1e4;
  return sigma_ * std::sqrt(times > 1 ? std::min(times, most) : 1);
}

double CrossLaw::mean(double own, double times) const {
  return moments(cross_value(own), deviation(times)).mean + shift_;
}

double CrossLaw::further_deviation(double own, double times) const {
  if (!std::isfinite(own)) return 0;
  const double variance = moments(cross_value(own), deviation(times)).variance;
  return std::sqrt(std::max(0., variance - variance_));
}

} // namespace plica
