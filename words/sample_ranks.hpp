// Where a share of a sorted sample stands: the nearest of its ranks, without interpolation.
#pragma once

#include <cmath>
#include <cstddef>

namespace plica {

// Of 0 .. count - 1, count at least 1; share 0 to 1.
inline std::size_t nearest_rank(std::size_t count, double share) {
  return std::size_t(std::lround(share * double(count - 1)));
}

} // namespace plica
