#include "diagnose/predict/peak_choice.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// What it costs to pass over modes of the model between two that are paired one behind the other.
class CostBetween {
public:
  explicit CostBetween(const Between& between) : between_(between), until_{0} {
    for (const bool counts : between.counts) until_.push_back(until_.back() + int(counts));
  }

  bool is_zero() const { return between_.counts.empty(); }

  // From mode `a` to a later one, which measured mode i takes.
  double operator()(std::size_t i, std::size_t a, std::size_t b) const {
    if (is_zero()) return 0;
    const int missed = between_.missed.empty() ? 0 : between_.missed[i];
    return passed_over * std::max(0, until_[b] - until_[a + 1] - missed);
  }

private:
  const Between& between_;
  std::vector<int> until_; // how many of the modes before each count
};

} // namespace

std::vector<Index> paired(const std::vector<double>& measured, const std::vector<double>& model,
                          bool first, const std::vector<double>& handicaps,
                          const Between& between) {
  const std::size_t m = measured.size(), n = model.size();
  std::vector<Index> pairs(m, 0);
  if (n == 0) return std::vector<Index>(m, -1);
  if (m == 0 || n <= m || first) {
    for (std::size_t i = 0; i < m; ++i) pairs[i] = Index(std::min(i, n - 1));
    return pairs;
  }
  constexpr double far = 1e9;
  const CostBetween cost_between(between);
  // Of the measured modes up to i, the last of which takes j; and which the one before it takes.
  std::vector<std::vector<double>> cost(m, std::vector<double>(n, far));
  std::vector<std::vector<std::size_t>> before(m, std::vector<std::size_t>(n, 0));
  for (std::size_t i = 0; i < m; ++i) {
    double least = i == 0 ? 0 : far;
    std::size_t nearest = 0;
    for (std::size_t j = i; j < n; ++j) {
      // Where nothing between costs, what was least for the last j stays so but for the new j - 1.
      std::size_t k = i == 0 ? j : j - 1;
      if (i > 0 && !cost_between.is_zero()) {
        k = i - 1;
        least = far;
        nearest = 0;
      }
      for (; k < j; ++k)
        if (const double all = cost[i - 1][k] + cost_between(i, k, j); all < least) {
          least = all;
          nearest = k;
        }
      before[i][j] = nearest;
      cost[i][j] = least + std::abs(std::log(measured[i] / model[j])) +
                   (handicaps.empty() ? 0 : handicaps[j]);
    }
  }
  auto j =
      std::size_t(std::min_element(cost[m - 1].begin(), cost[m - 1].end()) - cost[m - 1].begin());
  for (std::size_t i = m; i-- > 0;) {
    pairs[i] = Index(j);
    j = before[i][j];
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
