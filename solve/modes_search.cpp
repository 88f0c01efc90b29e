#include "solve/modes_search.hpp"

#include "words/sample_ranks.hpp"

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
  return ratios.empty() ? 0 : median(std::move(ratios));
}

} // namespace plica
