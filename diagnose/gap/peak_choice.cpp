#include "diagnose/gap/peak_choice.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<Index> paired(const std::vector<double>& measured, const std::vector<double>& model,
                          bool first) {
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
      const double pair = cost[i - 1][j - 1] + std::abs(std::log(measured[i - 1] / model[j - 1]));
      cost[i][j] = std::min(pair, j > i ? cost[i][j - 1] : far);
    }
  std::size_t j = n;
  for (std::size_t i = m; i > 0; --i) {
    while (j > i && cost[i][j] == cost[i][j - 1]) --j;
    pairs[i - 1] = Index(--j);
  }
  return pairs;
}

std::vector<Index> strong_peaks(const VectorXd& hertz, const VectorXd& zeta,
                                const VectorXd& height) {
  constexpr double strong = 0.12; // below, it does not count as strong in a measurement either
  const double least = strong * height.maxCoeff();
  std::vector<Index> peaks;
  for (Index i = 0; i < height.size(); ++i) {
    if (!(height[i] >= least)) continue;
    // Two modes within their widths show one peak.
    if (!peaks.empty() &&
        hertz[i] / hertz[peaks.back()] - 1 < 0.5 * (zeta[i] + zeta[peaks.back()])) {
      if (height[i] > height[peaks.back()]) peaks.back() = i;
      continue;
    }
    peaks.push_back(i);
  }
  return peaks;
}

} // namespace plica
