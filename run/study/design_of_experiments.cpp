#include "run/study/design_of_experiments.hpp"

#include <boost/random/sobol.hpp>

#include <numeric>
#include <random>

namespace plica {
namespace {

// Even in [0, 1) from the upper 53 bits, the same with every library.
double share_of(std::uint64_t bits) {
  return double(bits >> 11) * 0x1p-53;
}

} // namespace

Eigen::MatrixXd latin_hypercube(int count, int sides, unsigned seed) {
  std::mt19937_64 random(seed);
  Eigen::MatrixXd points(count, sides);
  std::vector<int> order(static_cast<std::size_t>(count));
  for (int side = 0; side < sides; ++side) {
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i > 1; --i) // Fisher-Yates
      std::swap(order[i - 1], order[std::size_t(share_of(random()) * double(i))]);
    for (int i = 0; i < count; ++i)
      points(i, side) = (order[std::size_t(i)] + share_of(random())) / count;
  }
  return points;
}

Eigen::MatrixXd sobol_points(int count, int sides) {
  boost::random::sobol sequence(static_cast<std::size_t>(sides)); // begins at the second point
  Eigen::MatrixXd points(count, sides);
  for (int i = 0; i < count; ++i)
    for (int side = 0; side < sides; ++side) points(i, side) = share_of(sequence());
  return points;
}

std::vector<std::vector<int>> combinations(const std::vector<int>& counts) {
  std::vector<std::vector<int>> rows;
  std::vector<int> row(counts.size(), 0);
  while (true) {
    rows.push_back(row);
    std::size_t side = counts.size();
    while (side > 0 && ++row[side - 1] == counts[side - 1]) row[--side] = 0;
    if (side == 0) return rows;
  }
}

} // namespace plica
