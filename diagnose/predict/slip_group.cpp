#include "diagnose/predict/slip_group.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::VectorXd;

constexpr double softest = 1e-3, ratio = 1.15; // of the points
constexpr std::size_t most_tables = 16;

} // namespace

// A slider for all between two distances has their stiffness and their slip force.
Sliders::Sliders(const Softening& s) {
  constexpr int count = 14;
  constexpr double step = 0.65; // from one distance to the next
  const double p = s.exponent;
  for (int i = 0; i < count; ++i) {
    const double high = std::pow(step, i), low = i + 1 < count ? high * step : 0;
    const double stiffness = std::pow(high, p) - std::pow(low, p);
    const double force = p / (p + 1) * (std::pow(high, p + 1) - std::pow(low, p + 1));
    law_.sliders.push_back({.stiffness = stiffness, .slip_force = s.distance * force});
  }
}

std::complex<double> Sliders::kept(double amplitude) const {
  return describing_function(law_, amplitude, 1).gain;
}

SlipTable::SlipTable(const FreeAffineModel& model, const VectorXd& coefficients,
                     const SlipGroup& group)
    : free_(model), coefficients_(coefficients), group_(group) {}

int SlipTable::point_at(double stiffness) {
  return int(std::lround(std::log(std::max(stiffness, softest) / softest) / std::log(ratio)));
}
double SlipTable::stiffness_of(int point) {
  return softest * std::pow(ratio, point);
}

const AffineModes* SlipTable::modes_at(int point) {
  const std::lock_guard lock(mutex_);
  auto known = points_.find(point);
  if (known == points_.end()) {
    VectorXd c = coefficients_;
    c[group_.change] = stiffness_of(point) - group_.present;
    known = points_.emplace(point, free_.modes(c, group_.change)).first;
  }
  return known->second ? &*known->second : nullptr;
}

std::optional<AffineModes> SlipTable::modes(double stiffness) {
  const int point = point_at(stiffness);
  const AffineModes* near = modes_at(point);
  if (!near) return std::nullopt;
  return free_.changed(*near, std::max(stiffness, softest) - stiffness_of(point));
}

std::shared_ptr<SlipTable> SlipTables::of(const FreeAffineModel& model, VectorXd coefficients,
                                          const SlipGroup& group) {
  coefficients[group.change] = 0; // whatever it is
  const std::lock_guard lock(mutex_);
  const auto at = std::find_if(known_.begin(), known_.end(),
                               [&](const auto& known) { return known.first == coefficients; });
  if (at != known_.end()) {
    std::rotate(at, at + 1, known_.end());
    return known_.back().second;
  }
  if (known_.size() == most_tables) known_.erase(known_.begin());
  known_.emplace_back(coefficients, std::make_shared<SlipTable>(model, coefficients, group));
  return known_.back().second;
}

} // namespace plica
