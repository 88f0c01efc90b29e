#include "io/tables/farthest.hpp"

#include "io/tables/text.hpp"
#include "words/directions.hpp"
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

// Whether a mode moves as the end does in a static test; across, where the mode says which way.
bool moves_as(const ModeResult& mode, std::size_t static_test) {
  constexpr int along_pipe = 1;
  const int dof = dof_of_static_test.at(static_test);
  if (mode.shape == mode_kind::torsion) return dof == 3 + along_pipe;
  if (mode.shape == mode_kind::axial) return dof == along_pipe;
  return mode.shape == mode_kind::transverse && (dof == 0 || dof == 2) &&
         (mode.direction.empty() || mode.direction == axis_word(dof));
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
      if (row.static_test >= 0 && moves_as(mode, std::size_t(row.static_test))) return m;
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
