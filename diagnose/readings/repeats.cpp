#include "diagnose/readings/repeats.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <tuple>

namespace plica {
namespace {

// What readings of one thing share: state, input, axis and level; of a peak its number; of a mode
// known by its kind, with the run that drives it, shape and order; of a weighing its state alone.
using Thing = std::tuple<std::string, Input, int, double, int, int>;

bool known_by_kind(const TestReadings& test, const Reading& r) {
  return r.run >= 0 && r.mode < 0 && !test.runs[std::size_t(r.run)].input.any();
}

bool may_be_of_a_pair(const Reading& r) {
  return r.axis < 0 && r.shape == MeasuredShape::transverse;
}

// That several readings of one thing make a mean.
bool is_pooled(const TestReadings& test, const Reading& r) {
  if (r.kind == ReadingKind::mass) return true;
  return known_by_kind(test, r) && !may_be_of_a_pair(r) && r.kind != ReadingKind::component;
}

Thing thing_of(const TestReadings& test, const Reading& r) {
  if (r.kind == ReadingKind::mass) return {r.state, {}, -1, 0, -1, 0};
  if (known_by_kind(test, r))
    return {r.state, {}, r.axis, double(r.run), static_cast<int>(r.shape), r.order};
  const TestRun& run = test.runs[std::size_t(r.run)];
  return {r.state, run.input, run.axis, run.level, -1, r.peak};
}

} // namespace

void widen_by_repeats(TestReadings& test) {
  for (const auto& [kind, name] :
       {std::pair{ReadingKind::frequency, "frequency"}, std::pair{ReadingKind::damping, "damping"},
        std::pair{ReadingKind::mass, "mass"}}) {
    std::map<Thing, std::vector<double>> groups;
    for (const Reading& r : test.readings)
      if (r.kind == kind && (r.run >= 0 || kind == ReadingKind::mass) && !may_be_of_a_pair(r))
        groups[thing_of(test, r)].push_back(r.log_value);
    double sum = 0;
    std::size_t freedom = 0;
    for (const auto& [of, values] : groups) {
      double mean = 0;
      for (double v : values) mean += v / double(values.size());
      for (double v : values) sum += (v - mean) * (v - mean);
      freedom += values.size() - 1;
    }
    if (freedom == 0) continue;
    const double sigma = std::sqrt(sum / double(freedom));
    double assumed = 0;
    for (Reading& r : test.readings)
      if (r.kind == kind && r.assumed && r.sigma < sigma) {
        assumed = r.sigma;
        r.sigma = sigma;
      }
    if (assumed == 0) continue;
    test.warnings.push_back(fmt::format(
        "repeated measurements of a {} scatter by {:.2g} % (standard deviation) where {:.2g} "
        "% was assumed: taken for all that state none",
        name, 100 * sigma, 100 * assumed));
  }
}

void pool_repeats(TestReadings& test) {
  std::map<std::tuple<ReadingKind, bool, Thing>, std::size_t> first;
  std::vector<Reading> kept;
  std::vector<double> weight; // of what is kept: the sum of 1 / sigma^2
  std::vector<int> count;
  for (const Reading& r : test.readings) {
    std::size_t k = kept.size();
    if (is_pooled(test, r))
      k = first.try_emplace({r.kind, r.held_out, thing_of(test, r)}, k).first->second;
    const double own = 1 / (r.sigma * r.sigma);
    if (k == kept.size()) {
      kept.push_back(r);
      weight.push_back(own);
      count.push_back(1);
      continue;
    }
    Reading& mean = kept[k];
    weight[k] += own;
    mean.log_value += own / weight[k] * (r.log_value - mean.log_value);
    mean.value = std::exp(mean.log_value);
    mean.sigma = 1 / std::sqrt(weight[k]);
    ++count[k];
  }
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (count[k] > 1) kept[k].name += fmt::format(", mean of {}", count[k]);
  test.readings = std::move(kept);
}

} // namespace plica
