#include "diagnose/weigh/spread_point.hpp"

#include <array>

namespace plica {

Eigen::VectorXd spread_point(int index, Eigen::Index dimensions, double reach) {
  constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19};
  Eigen::VectorXd z(dimensions);
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const int base = primes[std::size_t(d) % primes.size()];
    double share = 1, value = 0;
    for (int i = index + 1; i > 0; i /= base) {
      share /= base;
      value += share * (i % base);
    }
    z[d] = reach * (2 * value - 1);
  }
  return z;
}

} // namespace plica
