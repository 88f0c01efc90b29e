// Values of a sample by their rank: the nearest one, without interpolation.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace plica {

// Of 0 .. count - 1, count at least 1; share 0 to 1.
inline std::size_t nearest_rank(std::size_t count, double share) {
  return std::size_t(std::lround(share * double(count - 1)));
}

// `values`: at least one, in any order.
inline double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + std::ptrdiff_t(nearest_rank(values.size(), share));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Of an even number of values the upper one of the two in the middle.
inline double median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

} // namespace plica
