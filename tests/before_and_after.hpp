// A beam that is hit before and after a change, its frequencies given for either plane of bending.
#pragma once

#include "tests/changed_beam.hpp"

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace plica::changed_beam {

// Of one plane of bending, Hz.
using InPlane = std::function<std::vector<double>(Axis)>;

// Modes in z and x before and after a change. Each is so far off what `first` and `second` say,
// both times, and a thousandth off itself as mounted anew; of more than seven the next as the
// first.
inline Measured before_and_after(const InPlane& first, const InPlane& second,
                                 const std::array<double, 7>& off) {
  constexpr std::array anew{0.001, -0.0015, 0.0005, 0.0015, -0.001, 0.0007, -0.0006};
  Measured m;
  m.specimen = "beam";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  std::size_t k = 0;
  for (Axis axis : {Axis::z, Axis::x}) {
    const std::vector<double> before = first(axis), after = second(axis);
    for (std::size_t i = 0; i < before.size(); ++i, ++k) {
      m.modes.push_back(bending(axis, int(i) + 1, "before", before[i] * (1 + off[k % off.size()])));
      m.modes.push_back(
          bending(axis, int(i) + 1, "after",
                  after[i] * (1 + off[k % off.size()]) * (1 + anew[k % anew.size()])));
    }
  }
  return m;
}

// Weighed in both states.
inline void weigh(Measured& m, double before, double after) {
  for (const auto& [state, mass] : {std::pair{"before", before}, {"after", after}}) {
    m.weighings.emplace_back().value = mass;
    m.weighings.back().state = state;
  }
}

// A percent off, whichever mode.
inline constexpr std::array a_percent_off{0.011, -0.006, 0.008, -0.012, 0.004, 0.007, -0.009};

} // namespace plica::changed_beam
