#include "diagnose/weigh/level_errors.hpp"

#include "diagnose/weigh/weighted_line.hpp"

#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// What each reading shifts by where the levels of its run are a standard deviation off: the slope
// of its series over the logarithm of the level, as the test has it.
VectorXd shift_by_level(const TestReadings& test, const std::vector<int>& series) {
  const auto level = [&](const Reading& r) {
    return r.run < 0 ? 0. : test.runs[std::size_t(r.run)].level;
  };
  std::map<int, WeightedLine> lines;
  for (std::size_t i = 0; i < series.size(); ++i)
    if (const Reading& r = test.readings[i]; level(r) > 0)
      lines[series[i]].add(std::log(level(r)), r.log_value, r.sigma);
  VectorXd shift = VectorXd::Zero(Index(series.size()));
  for (std::size_t i = 0; i < series.size(); ++i)
    if (const auto line = lines.find(series[i]); line != lines.end() && level(test.readings[i]) > 0)
      if (const auto slope = line->second.slope())
        shift[Index(i)] = test.level_sigma * slope->value;
  return shift;
}

} // namespace

void add_error_of_levels(const TestReadings& test, const std::vector<int>& series,
                         Eigen::MatrixXd& S) {
  if (test.level_sigma == 0) return;
  const VectorXd shift = shift_by_level(test, series);
  for (Index i = 0; i < S.rows(); ++i)
    for (Index j = 0; j < S.cols(); ++j)
      if (test.readings[std::size_t(i)].run == test.readings[std::size_t(j)].run)
        S(i, j) += shift[i] * shift[j];
}

} // namespace plica
