#include "diagnose/weigh/level_errors.hpp"

#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// What each reading shifts by where the levels of its run are a standard deviation off: the slope
// of its series over the logarithm of the level, as the test has it.
VectorXd shift_by_level(const TestReadings& test, const std::vector<int>& series) {
  struct Line {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  };
  const auto level = [&](const Reading& r) {
    return r.run < 0 ? 0. : test.runs[std::size_t(r.run)].level;
  };
  std::map<int, Line> lines;
  for (std::size_t i = 0; i < series.size(); ++i)
    if (const Reading& r = test.readings[i]; level(r) > 0) {
      const double x = std::log(level(r)), weight = 1 / (r.sigma * r.sigma);
      Line& line = lines[series[i]];
      line.n += weight;
      line.x += weight * x;
      line.y += weight * r.log_value;
      line.xx += weight * x * x;
      line.xy += weight * x * r.log_value;
    }
  VectorXd shift = VectorXd::Zero(Index(series.size()));
  for (std::size_t i = 0; i < series.size(); ++i)
    if (const Reading& r = test.readings[i]; level(r) > 0) {
      const Line& line = lines[series[i]];
      const double spread = line.n * line.xx - line.x * line.x;
      if (spread > 1e-9 * line.n * line.xx)
        shift[Index(i)] = test.level_sigma * (line.n * line.xy - line.x * line.y) / spread;
    }
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
