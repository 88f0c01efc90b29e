#include "life/curves.hpp"

#include "words/units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plica {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double MPa = 1e6;

class CurveChecks {
public:
  std::vector<InputProblem> found;

  void add(const std::string& key, const std::string& wrong, const std::string& allowed) {
    found.push_back({.file = "", .line = 0, .key = key, .wrong = wrong, .allowed = allowed});
  }
  void positive(const char* key, double value) {
    if (!(value > 0) || !std::isfinite(value))
      add(key, "is " + short_number(value), "a finite number above 0");
  }
  void negative(const char* key, double value) {
    if (!(value < 0) || !std::isfinite(value))
      add(key, "is " + short_number(value), "a finite number below 0");
  }

  void operator()(const BellowsCurve& curve) {
    if (!(curve.Kg >= 1 && curve.Kg <= 4))
      add("Kg", "is " + short_number(curve.Kg), "from 1 (smooth) to 4 (fillet welds)");
    positive("E_ratio", curve.E_ratio);
  }
  void operator()(const StressLifeCurve& curve) {
    positive("knee_amplitude", curve.knee_amplitude);
    positive("knee_cycles", curve.knee_cycles);
    positive("slope", curve.slope);
    if (curve.second_slope) positive("second_slope", *curve.second_slope);
    if (!curve.fewest) return;
    positive("fewest", *curve.fewest);
    if (*curve.fewest >= curve.knee_cycles)
      add("fewest", "is not below the knee", "fewer cycles than knee_cycles");
  }
  void operator()(const StrainLifeCurve& curve) {
    positive("E", curve.E);
    positive("sf", curve.sf);
    positive("ef", curve.ef);
    negative("b", curve.b);
    negative("c", curve.c);
  }
  void operator()(const PublishedCurve& curve) { positive("E", curve.E); }
  void operator()(const TableCurve& curve) {
    if (curve.points.size() < 2) add("points", "are fewer than two", "two or more");
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const std::string key = "points[" + std::to_string(i) + "]";
      const auto& [N, Sa] = curve.points[i];
      if (!(N > 0 && Sa > 0) || !std::isfinite(N) || !std::isfinite(Sa))
        add(key, "has a number that is not above 0 and finite", "[cycles, amplitude]");
      else if (i > 0 && !(N > curve.points[i - 1][0] && Sa < curve.points[i - 1][1]))
        add(key, "does not lie right of and below the point before",
            "more cycles, less amplitude from point to point");
    }
  }
};

CurveLife life_of(const BellowsCurve& curve, double range) {
  const double S = curve.Kg * curve.E_ratio * range / MPa;
  if (S <= 257.2) return {BellowsCurve::most, Bound::at_least};
  const double root = S >= 448 ? 35850 / (S - 264) : 46200 / (S - 211);
  if (root < 1) return {1, Bound::at_most};
  return {root * root, Bound::exact};
}

CurveLife life_of(const StressLifeCurve& curve, double amplitude) {
  if (amplitude == 0) return {infinite, Bound::exact};
  const double share = curve.knee_amplitude / amplitude;
  if (share <= 1) {
    const double N = curve.knee_cycles * std::pow(share, curve.slope);
    if (curve.fewest && N < *curve.fewest) return {*curve.fewest, Bound::at_most};
    return {N, Bound::exact};
  }
  if (!curve.second_slope) return {infinite, Bound::exact};
  return {curve.knee_cycles * std::pow(share, *curve.second_slope), Bound::exact};
}

// Straight lines between points in a log-log plot; beyond them a bound.
CurveLife between_points(const std::vector<std::array<double, 2>>& points, double amplitude) {
  if (amplitude < points.back()[1]) return {points.back()[0], Bound::at_least};
  if (amplitude > points.front()[1]) return {points.front()[0], Bound::at_most};
  std::size_t i = 1;
  while (i + 1 < points.size() && amplitude < points[i][1]) ++i;
  const auto& [N1, S1] = points[i - 1];
  const auto& [N2, S2] = points[i];
  const double share = std::log(S1 / amplitude) / std::log(S1 / S2);
  return {N1 * std::pow(N2 / N1, share), Bound::exact};
}

CurveLife life_of(const TableCurve& curve, double amplitude) {
  return between_points(curve.points, amplitude);
}

CurveLife life_of(const PublishedCurve& curve, double amplitude) {
  const PublishedTests& tests = tests_of(curve.of);
  if (tests.is_design()) return between_points(tests.points, 100 * amplitude / curve.E);
  const double above = 100 * tests.scale * amplitude / curve.E - tests.limit; // percent
  if (above <= 0) return {tests.most, Bound::at_least};
  const double N = tests.factor * std::pow(above, -tests.exponent);
  if (N > tests.most) return {tests.most, Bound::at_least};
  if (N < tests.fewest) return {tests.fewest, Bound::at_most};
  return {N, Bound::exact};
}

// The right side falls with N: log N by bisection.
CurveLife life_of(const StrainLifeCurve& c, const StressCycle& cycle) {
  const double ea = cycle.range / (2 * c.E);
  const double product = (cycle.mean + cyclic_stress(c, ea)) * ea;
  if (product <= 0) return {infinite, Bound::exact};
  const auto of = [&](double log_reversals) {
    return c.sf * c.sf / c.E * std::exp(2 * c.b * log_reversals) +
           c.sf * c.ef * std::exp((c.b + c.c) * log_reversals);
  };
  double low = std::log(2.), high = 700;
  if (of(low) <= product) return {1, Bound::at_most};
  if (of(high) >= product) return {infinite, Bound::exact};
  for (int i = 0; i < 200 && high - low > 1e-13; ++i)
    (of((low + high) / 2) > product ? low : high) = (low + high) / 2;
  return {std::exp((low + high) / 2) / 2, Bound::exact};
}

} // namespace

std::vector<InputProblem> check(const FatigueCurve& curve) {
  CurveChecks checks;
  std::visit(checks, curve.law);
  checks.positive("temperature_factor", curve.temperature_factor);
  const bool by_amplitude =
      std::holds_alternative<StressLifeCurve>(curve.law) ||
      std::holds_alternative<TableCurve>(curve.law) ||
      (std::holds_alternative<PublishedCurve>(curve.law) && !is_design(curve));
  if (curve.mean_stress != MeanStress::none && !by_amplitude)
    checks.add("mean_stress", "is chosen for a curve that has its own",
               "none, or a stress-life curve, a table or a published mean curve");
  if (curve.mean_stress == MeanStress::goodman) checks.positive("ultimate", curve.ultimate);
  return checks.found;
}

double cyclic_stress(const StrainLifeCurve& c, double strain) {
  const double n = c.b / c.c, K = c.sf / std::pow(c.ef, n);
  double low = 0, high = c.E * strain; // the strain grows with the stress
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double s = (low + high) / 2;
    (s / c.E + std::pow(s / K, 1 / n) < strain ? low : high) = s;
  }
  return (low + high) / 2;
}

double equivalent_amplitude(const FatigueCurve& curve, const StressCycle& cycle) {
  const double Sa = cycle.range / 2;
  if (curve.mean_stress == MeanStress::none || Sa == 0) return Sa;
  if (curve.mean_stress == MeanStress::smith_watson_topper)
    return std::sqrt(Sa * std::max(0., cycle.mean + Sa));
  if (cycle.mean <= 0) return Sa;
  return cycle.mean >= curve.ultimate ? infinite : Sa / (1 - cycle.mean / curve.ultimate);
}

CurveLife life(const FatigueCurve& curve, const StressCycle& cycle) {
  if (!(cycle.range >= 0) || !std::isfinite(cycle.range) || !std::isfinite(cycle.mean))
    throw std::invalid_argument("a cycle of range " + short_number(cycle.range) + " Pa and mean " +
                                short_number(cycle.mean) + " Pa has no life");
  const StressCycle at_room{cycle.range / curve.temperature_factor,
                            cycle.mean / curve.temperature_factor};
  if (const auto* bellows = std::get_if<BellowsCurve>(&curve.law))
    return life_of(*bellows, at_room.range);
  if (const auto* strain = std::get_if<StrainLifeCurve>(&curve.law))
    return life_of(*strain, at_room);
  const double amplitude = equivalent_amplitude(curve, at_room);
  if (std::isinf(amplitude)) return {0, Bound::exact};
  if (const auto* stress = std::get_if<StressLifeCurve>(&curve.law))
    return life_of(*stress, amplitude);
  if (const auto* published = std::get_if<PublishedCurve>(&curve.law))
    return life_of(*published, amplitude);
  return life_of(std::get<TableCurve>(curve.law), amplitude);
}

bool is_design(const FatigueCurve& curve) {
  const auto* published = std::get_if<PublishedCurve>(&curve.law);
  return published ? tests_of(published->of).is_design()
                   : std::holds_alternative<BellowsCurve>(curve.law);
}

std::optional<double> deviation_of(const FatigueCurve& curve) {
  const auto* published = std::get_if<PublishedCurve>(&curve.law);
  if (!published || is_design(curve)) return std::nullopt;
  return tests_of(published->of).deviation;
}

std::string what_is_inside(const FatigueCurve& curve) {
  std::string text = curve.name;
  if (!curve.source.empty()) text += " (" + curve.source + ")";
  if (const auto* b = std::get_if<BellowsCurve>(&curve.law))
    return text + ": factors of " + short_number(BellowsCurve::factor_on_cycles) +
           " on cycles and " + short_number(BellowsCurve::factor_on_stress) +
           " on stress are inside; Kg " + short_number(b->Kg) + ", E0/Eb " +
           short_number(b->E_ratio);
  if (const auto* published = std::get_if<PublishedCurve>(&curve.law)) {
    const PublishedTests& tests = tests_of(published->of);
    return text + ": " +
           (tests.is_design() ? tests.inside
                              : "no factors are inside, it is the median of the tests");
  }
  return text + ": no factors but those of its numbers are inside";
}

std::string text_of(const CurveLife& life) {
  if (std::isinf(life.cycles)) return "unlimited";
  const std::string number = std::to_string(static_cast<long long>(std::min(life.cycles, 9e18)));
  return life.bound == Bound::at_least  ? "at least " + number
         : life.bound == Bound::at_most ? "at most " + number
                                        : number;
}

} // namespace plica
