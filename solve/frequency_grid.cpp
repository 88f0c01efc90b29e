#include "solve/frequency_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

constexpr double fineness = 0.08; // of a half bandwidth at the resonance, of the distance far off

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

} // namespace

Eigen::VectorXd frequency_grid(double low, double high, int points, const Eigen::VectorXd& hertz,
                               const Eigen::VectorXd& zeta) {
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(points));
  const double step = (high - low) / std::max(1, points - 1);
  for (int i = 0; i < points; ++i) all.push_back(low + step * i);
  for (Eigen::Index j = 0; j < hertz.size(); ++j) {
    if (hertz[j] < low || hertz[j] > high) continue;
    const bool again = j > 0 && hertz[j] - hertz[j - 1] < 1e-6 * hertz[j] && zeta[j] == zeta[j - 1];
    if (again) continue; // the other mode of a pair
    const double width = std::max(zeta[j], 1e-9) * hertz[j];
    all.push_back(hertz[j]);
    // Up to where a step of the even grid is as fine as the cluster.
    for (double i = 1, away = 0; away < step / fineness && away < high - low; ++i) {
      away = width * std::sinh(fineness * i);
      for (double f : {hertz[j] - away, hertz[j] + away})
        if (f >= low && f <= high) all.push_back(f);
    }
  }
  std::sort(all.begin(), all.end());
  const auto same = [](double a, double b) { return b - a <= 1e-12 * b; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return Eigen::Map<Eigen::VectorXd>(all.data(), Eigen::Index(all.size()));
}

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

} // namespace plica
