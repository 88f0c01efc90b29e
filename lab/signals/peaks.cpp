#include "lab/signals/peaks.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

// Frequency where the curve falls to `level`, walking from the peak by `step`; NaN if it rises
// again first or the curve ends.
double flank(const Eigen::VectorXd& hertz, const Eigen::VectorXd& magnitude, Eigen::Index peak,
             int step, double level) {
  for (Eigen::Index i = peak + step; i >= 0 && i < hertz.size(); i += step) {
    const double here = magnitude[i], before = magnitude[i - step];
    if (here > before) break;
    if (here <= level) {
      const double share = (before - level) / (before - here);
      return hertz[i - step] + share * (hertz[i] - hertz[i - step]);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double valley(const Eigen::VectorXd& magnitude, Eigen::Index top, int step) {
  double lowest = magnitude[top];
  for (Eigen::Index i = top + step; i >= 0 && i < magnitude.size(); i += step) {
    if (magnitude[i] > magnitude[top]) break;
    lowest = std::min(lowest, magnitude[i]);
  }
  return lowest;
}

} // namespace

std::vector<Peak> find_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXd& magnitude,
                             double floor) {
  std::vector<Peak> peaks;
  if (hertz.size() < 3) return peaks;
  const double highest = magnitude.maxCoeff();
  for (Eigen::Index i = 1; i + 1 < hertz.size(); ++i) {
    const double a = magnitude[i - 1], b = magnitude[i], c = magnitude[i + 1];
    if (!(b > a && b >= c && b > floor * highest)) continue;
    // Newton's form of the parabola, steps of different size.
    const double da = (b - a) / (hertz[i] - hertz[i - 1]);
    const double dc = (c - b) / (hertz[i + 1] - hertz[i]);
    const double curvature = (dc - da) / (hertz[i + 1] - hertz[i - 1]);
    const double slope = da + curvature * (hertz[i] - hertz[i - 1]); // at the middle point
    const double shift = curvature < 0 ? -slope / (2 * curvature) : 0;
    Peak p{.frequency = hertz[i] + shift, .height = b + slope * shift / 2};
    const double level = p.height / std::numbers::sqrt2;
    p.f1 = flank(hertz, magnitude, i, -1, level);
    p.f2 = flank(hertz, magnitude, i, 1, level);
    const double up = p.f2 - p.frequency, down = p.frequency - p.f1;
    p.damping = std::max(up, down) < 3 * std::min(up, down)
                    ? (up + down) / (2 * p.frequency)
                    : std::numeric_limits<double>::quiet_NaN();
    peaks.push_back(p);
  }
  return peaks;
}

double higher_valley(const Eigen::VectorXd& magnitude, Eigen::Index top) {
  return std::max(valley(magnitude, top, -1), valley(magnitude, top, 1));
}

} // namespace plica
