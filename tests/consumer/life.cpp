// The history that ASTM E1049 counts as its example, with Miner's sum of a straight curve.
#include "expect.hpp"
#include "plica/life/miner.hpp"

#include <map>

int main() {
  using namespace plica;
  std::map<double, double> counts; // by the range
  const std::vector<RainflowCycle> cycles = rainflow({-2, 1, -3, 5, -1, 3, -4, 4, -2});
  for (const RainflowCycle& cycle : cycles) counts[cycle.range] += cycle.count;
  const std::map<double, double> of_the_standard{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1}, {9, 0.5}};
  expect(counts == of_the_standard, "cycles as in figure 6 of ASTM E1049");

  // N = 10^6 / (range / 2)^3, so that D = sum n range^3 / (8 10^6).
  FatigueCurve curve{.name = "straight", .source = "made up"};
  curve.law = StressLifeCurve{.knee_amplitude = 1, .knee_cycles = 1e6, .slope = 3};
  expect(check(curve).empty(), "the curve is one");
  expect_near(miner(curve, cycles).damage, 1094 / 8e6, "Miner's sum");
  return differs;
}
