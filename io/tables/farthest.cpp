#include "io/tables/farthest.hpp"

#include "io/tables/text.hpp"
#include "words/mode_kinds.hpp"

#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

// Masses are drawn, and damping is assumed: heights of peaks follow from it.
bool is_given(const MeasuredComparison& row) {
  return row.kind != ComparedKind::frequency && row.kind != ComparedKind::stiffness;
}

double farness(const MeasuredComparison& row) {
  const double off = relative_deviation(row);
  return std::isfinite(off) ? std::abs(off) : 0;
}

bool is_within(const MeasuredComparison& row) {
  return row.sigma > 0 ? std::abs(sigma_deviation(row)) <= 2 : farness(row) <= 0.02;
}

// "transverse stiffness x": a mode across in x, where the mode says so.
bool moves_that_way(const ModeResult& mode, const std::string& stiffness) {
  if (mode.shape == mode_kind::torsion) return stiffness.starts_with("torsional");
  if (mode.shape != mode_kind::axial && mode.shape != mode_kind::transverse) return false;
  return stiffness.starts_with(mode.shape + " ") &&
         (mode.shape == mode_kind::axial || mode.direction.empty() ||
          stiffness.find(" stiffness " + mode.direction) != std::string::npos);
}

} // namespace

FarthestOff farthest_off(const Results& results) {
  FarthestOff found;
  for (const MeasuredComparison& row : results.comparison) {
    if (is_given(row)) continue;
    ++found.computed;
    found.within += is_within(row) ? 1 : 0;
    if (!found.row || farness(row) > farness(*found.row)) found.row = &row;
  }
  return found;
}

std::string within_words(const FarthestOff& found, const std::string& sigma) {
  return fmt::format("{} of {} computed numbers lie within 2 {} (2 % where the test states none)",
                     found.within, found.computed, sigma);
}

std::optional<std::size_t> mode_that_shows(const Results& results, const MeasuredComparison& row) {
  std::optional<std::size_t> found;
  double nearest = 0;
  for (std::size_t m = 0; m < results.modes.size(); ++m) {
    const ModeResult& mode = results.modes[m];
    if (row.kind == ComparedKind::stiffness) {
      if (moves_that_way(mode, row.quantity)) return m;
      continue;
    }
    const double off = std::abs(mode.frequency - row.computed);
    if (found && off >= nearest) continue;
    found = m;
    nearest = off;
  }
  return found;
}

} // namespace plica
