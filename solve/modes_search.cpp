#include "solve/modes_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace plica {

double eigenvalue(double hertz) {
  return std::pow(2 * std::numbers::pi * hertz, 2);
}

double median_ratio(const Eigen::VectorXd& k, const Eigen::VectorXd& m) {
  std::vector<double> ratios;
  for (Eigen::Index i = 0; i < k.size(); ++i)
    if (m[i] > 0) ratios.push_back(k[i] / m[i]);
  if (ratios.empty()) return 0;
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

} // namespace plica
