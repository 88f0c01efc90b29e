#include "run/study/life_intervals.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

// How far the life goes from that of the range, as a logarithm, down and up.
double decades(const CurveLife& nominal, const CurveLife& other) {
  const double d = std::log10(other.cycles / nominal.cycles);
  return std::isfinite(d) ? d : 0;
}

} // namespace

void add_life_intervals(const Case& data, Results& results) {
  if (!data.analyses.life || !results.life) return;
  const Life& asked = *data.analyses.life;
  for (DutyResult& duty : results.life->duties) {
    if (!duty.life || !std::isfinite(duty.life->cycles) || !(duty.life->cycles > 0)) continue;
    CurveLife shortest = *duty.life, longest = *duty.life;
    bool known = asked.deviation.has_value();
    for (const ErrorBar& bar : results.error_bars.bars)
      if (bar.key == "life_" + duty.name && bar.interval) {
        const auto at = [&](double range) {
          return life(asked.curve, {duty.range * range / bar.value, duty.mean * range / bar.value});
        };
        shortest = at((*bar.interval)[1]);
        longest = at((*bar.interval)[0]);
        results.life->with_tolerances = known = true;
      }
    if (!known) continue;
    const double scatter = 1.6448536269514722 * asked.deviation.value_or(0);
    const double down = std::hypot(decades(*duty.life, shortest), scatter);
    const double up = std::hypot(decades(*duty.life, longest), scatter);
    if (scatter > 0) {
      shortest.cycles = duty.life->cycles * std::pow(10, -down);
      if (std::isfinite(longest.cycles)) longest.cycles = duty.life->cycles * std::pow(10, up);
    }
    duty.between = {shortest, longest};
  }
}

} // namespace plica
