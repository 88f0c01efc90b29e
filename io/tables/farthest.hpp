// What of a run lies farthest from the test.
#pragma once

#include "run/results/results.hpp"

namespace plica {

// Of the numbers that the model computes the one that is farthest off: in standard deviations where
// the test states one, else in percents. What the case was given is none of them: the mass, and the
// damping of modes, which a linear response gives back.
struct FarthestOff {
  const MeasuredComparison* row = nullptr; // null: nothing computed is compared
  int computed = 0, within = 0;            // within two standard deviations, or 2 %
};
FarthestOff farthest_off(const Results& results);

} // namespace plica
