#include "diagnose/predict/peak_choice.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<Index> paired(const std::vector<double>& measured, const std::vector<double>& model,
                          bool first, const std::vector<double>& handicaps) {
  const std::size_t m = measured.size(), n = model.size();
  std::vector<Index> pairs(m, 0);
  if (n == 0) return std::vector<Index>(m, -1);
  if (n <= m || first) {
    for (std::size_t i = 0; i < m; ++i) pairs[i] = Index(std::min(i, n - 1));
    return pairs;
  }
  std::vector<std::vector<double>> cost(m + 1, std::vector<double>(n + 1, 0));
  constexpr double far = 1e9;
  for (std::size_t i = 1; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      cost[i][j] = far;
      if (j < i) continue;
      const double pair = cost[i - 1][j - 1] + std::abs(std::log(measured[i - 1] / model[j - 1])) +
                          (handicaps.empty() ? 0 : handicaps[j - 1]);
      cost[i][j] = std::min(pair, j > i ? cost[i][j - 1] : far);
    }
  std::size_t j = n;
  for (std::size_t i = m; i > 0; --i) {
    while (j > i && cost[i][j] == cost[i][j - 1]) --j;
    pairs[i - 1] = Index(--j);
  }
  return pairs;
}

std::vector<Index> strong_peaks(const VectorXd& hertz, const VectorXd& zeta, const VectorXd& height,
                                const std::array<double, 2>& band, std::size_t wanted,
                                double share) {
  constexpr double beyond = 0.2; // of an end of the band: a model may be that far off
  const auto within = [&](Index i) {
    return !(band[1] > band[0]) ||
           (hertz[i] > (1 - beyond) * band[0] && hertz[i] < (1 + beyond) * band[1]);
  };
  std::vector<Index> order;
  for (Index i = 0; i < height.size(); ++i)
    if (within(i) && height[i] > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return height[a] > height[b]; });
  std::vector<Index> peaks;
  for (Index i : order) {
    if (height[i] < share * height[order.front()] && peaks.size() >= wanted) break;
    // Two modes within their widths show one peak.
    if (std::none_of(peaks.begin(), peaks.end(), [&](Index other) {
          return std::abs(hertz[i] - hertz[other]) <
                 0.5 * (zeta[i] + zeta[other]) * std::min(hertz[i], hertz[other]);
        }))
      peaks.push_back(i);
  }
  std::sort(peaks.begin(), peaks.end());
  return peaks;
}

std::vector<double> handicaps(const VectorXd& height, const std::vector<Index>& modes,
                              double share) {
  constexpr double of_weakness = 0.1;
  double highest = 0;
  for (Index i : modes) highest = std::max(highest, height[i]);
  std::vector<double> all;
  for (Index i : modes)
    all.push_back(of_weakness * std::max(0., std::log(share * highest / height[i])));
  return all;
}

} // namespace plica
