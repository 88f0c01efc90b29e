#include "run/study/life_intervals.hpp"

#include "run/results/normal_distribution.hpp"
#include "run/results/number_keys.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

// How far a life or a damage goes from the nominal one, as a logarithm.
double decades(double nominal, double other) {
  const double d = std::log10(other / nominal);
  return std::isfinite(d) ? d : 0;
}

const ErrorBar* interval_of(const ErrorBars& errors, const std::string& key) {
  for (const ErrorBar& bar : errors.bars)
    if (bar.key == key && bar.interval) return &bar;
  return nullptr;
}

// Of a duty with one range: that of its stress, through the curve.
void add_by_range(const FatigueCurve& curve, const ErrorBar* bar, double scatter,
                  DutyResult& duty) {
  CurveLife shortest = *duty.life, longest = *duty.life;
  if (bar) {
    const auto at = [&](double range) {
      return life(curve, {duty.range * range / bar->value, duty.mean * range / bar->value});
    };
    shortest = at((*bar->interval)[1]);
    longest = at((*bar->interval)[0]);
  }
  if (scatter > 0) {
    const double down = std::hypot(decades(duty.life->cycles, shortest.cycles), scatter);
    const double up = std::hypot(decades(duty.life->cycles, longest.cycles), scatter);
    shortest.cycles = duty.life->cycles * std::pow(10, -down);
    if (std::isfinite(longest.cycles)) longest.cycles = duty.life->cycles * std::pow(10, up);
  }
  duty.between = {shortest, longest};
  duty.damage_between = {duty.count / longest.cycles, duty.count / shortest.cycles};
}

// Of many ranges: that of the damage itself, which every run with another number counted anew.
std::optional<std::array<double, 2>> of_damage(double damage, const ErrorBar* bar, double scatter) {
  const double down = bar ? decades(bar->value, (*bar->interval)[0]) : 0;
  const double up = bar ? decades(bar->value, (*bar->interval)[1]) : 0;
  return std::array{damage * std::pow(10, -std::hypot(down, scatter)),
                    damage * std::pow(10, std::hypot(up, scatter))};
}

bool has_one_range(const DutyResult& duty) {
  return duty.life && std::isfinite(duty.life->cycles) && duty.life->cycles > 0;
}

} // namespace

void add_life_intervals(const Case& data, Results& results) {
  if (!data.analyses.life || !results.life) return;
  const Life& asked = *data.analyses.life;
  LifeResult& found = *results.life;
  const std::optional<double> deviation =
      asked.deviation ? asked.deviation : deviation_of(asked.curve);
  constexpr double upper = 0.95; // end of the 90 % interval
  const double scatter = normal_quantile(upper) * deviation.value_or(0);
  const bool scatters = deviation.has_value();
  for (DutyResult& duty : found.duties) {
    const bool one = has_one_range(duty);
    if (!one && (duty.life || !(duty.damage > 0))) continue;
    const ErrorBar* bar =
        interval_of(results.error_bars,
                    number_key::of(one ? NumberKind::stress_range : NumberKind::damage, duty.name));
    if (!bar && !scatters) continue;
    found.with_tolerances = found.with_tolerances || bar;
    if (one)
      add_by_range(asked.curve, bar, scatter, duty);
    else
      duty.damage_between = of_damage(duty.damage, bar, scatter);
  }
  const ErrorBar* all = interval_of(results.error_bars, number_key::damage);
  if (!found.spots.empty() && found.spots[0].damage > 0 && (all || scatters))
    found.damage_between = of_damage(found.spots[0].damage, all, scatter);
}

} // namespace plica
