#include "lab/identification/peak_picking.hpp"

#include "lab/signals/peaks.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
std::vector<PickedPeak> pick_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXd& magnitude,
                                   double prominence, double floor) {
  std::vector<PickedPeak> picked;
  for (const Peak& p : find_peaks(hertz, magnitude, floor)) {
    Eigen::Index at = 0;
    (hertz.array() - p.frequency).abs().minCoeff(&at);
    while (at > 0 && magnitude[at - 1] > magnitude[at]) --at;
    while (at + 1 < hertz.size() && magnitude[at + 1] > magnitude[at]) ++at;
    if (magnitude[at] < prominence * higher_valley(magnitude, at)) continue;
    PickedPeak q{.frequency = p.frequency, .amplitude = p.height, .damping = p.damping};
    q.lines = static_cast<int>((hertz.array() >= p.f1 && hertz.array() <= p.f2).count());
    picked.push_back(q);
  }
  return picked;
}

double half_power_bias(double z, HalfPowerFormula formula) {
  // |H|^2 = 1 / ((1 - r^2)^2 + (2 z r)^2) is half its largest at r^2 = 1 - 2 z^2 -+ 2 z
  // sqrt(1-z^2).
  const double middle = 1 - 2 * z * z, half = 2 * z * std::sqrt(1 - z * z);
  const double r1 = std::sqrt(middle - half), r2 = std::sqrt(middle + half);
  if (formula == HalfPowerFormula::by_squares) return (r2 * r2 - r1 * r1) / 4 / z - 1;
  const double by = formula == HalfPowerFormula::by_peak ? std::sqrt(middle) : 1;
  return (r2 - r1) / (2 * by) / z - 1;
}

} // namespace plica
