#include "io/tables/farthest.hpp"

#include "io/tables/text.hpp"

#include <cmath>

namespace plica {
namespace {

bool is_given(const MeasuredComparison& row) {
  return row.quantity == "mass" || row.quantity.starts_with("half-power damping");
}

double farness(const MeasuredComparison& row) {
  const double off = row.sigma > 0 ? sigma_deviation(row) : 100 * relative_deviation(row);
  return std::isfinite(off) ? std::abs(off) : 0;
}

} // namespace

FarthestOff farthest_off(const Results& results) {
  FarthestOff found;
  for (const MeasuredComparison& row : results.comparison) {
    if (is_given(row)) continue;
    ++found.computed;
    found.within += farness(row) <= 2 ? 1 : 0;
    if (!found.row || farness(row) > farness(*found.row)) found.row = &row;
  }
  return found;
}

} // namespace plica
