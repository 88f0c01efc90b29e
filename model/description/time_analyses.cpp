#include "model/description/time_analyses.hpp"

#include <algorithm>

namespace plica {

std::array<double, 2> speeds(const RunUp& run_up) {
  if (run_up.table.empty()) return run_up.speed;
  std::array<double, 2> range{run_up.table[0][1], run_up.table[0][1]};
  for (const auto& [time, speed] : run_up.table) {
    range[0] = std::min(range[0], speed);
    range[1] = std::max(range[1], speed);
  }
  return range;
}

double table_at(const std::vector<std::array<double, 2>>& table, double x) {
  if (x <= table.front()[0]) return table.front()[1];
  if (x >= table.back()[0]) return table.back()[1];
  const auto above =
      std::find_if(table.begin(), table.end(), [&](const auto& row) { return row[0] > x; });
  const auto& [x0, y0] = *(above - 1);
  const auto& [x1, y1] = *above;
  return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
}

} // namespace plica
