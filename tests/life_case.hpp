// Cases with a life: a curve that is a power law, so that damage goes with the power of the stress,
// and duties by name.
#pragma once

#include "tests/bellows_case.hpp"

#include <stdexcept>

namespace plica::test::life_case {

constexpr double knee = 200e6, knee_cycles = 1e6, slope = 4;

inline FatigueCurve power_law() {
  return {.name = "power law",
          .source = "this test",
          .law = StressLifeCurve{.knee_amplitude = knee,
                                 .knee_cycles = knee_cycles,
                                 .slope = slope,
                                 .second_slope = slope}};
}

// Bellows A, without modes where none are asked for.
inline Case coarse_bellows(const MeshDensity& mesh, int modes = 0) {
  Case data = verification_case("bellows_a", mesh, modes);
  if (modes == 0) data.analyses.modes.reset();
  data.analyses.life.emplace();
  data.analyses.life->curve = power_law();
  return data;
}

inline const DutyResult& duty(const Results& results, const std::string& name) {
  for (const DutyResult& d : results.life->duties)
    if (d.name == name) return d;
  throw std::runtime_error("no duty " + name);
}

} // namespace plica::test::life_case
