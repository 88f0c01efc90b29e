#include "solve/frequency_grid.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

constexpr double fineness = 0.08; // of a half bandwidth at the resonance, of the distance far off

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

} // namespace plica
