// What of a run lies farthest from the test.
#pragma once

#include "run/results/results.hpp"

#include <optional>

namespace plica {

// Of the numbers that the model computes the one that is farthest off: by the share of the measured
// number, one measure for all of them, whether the test states an error or not. What the case was
// given is none of them: the mass, the damping of modes, which a response gives back, and the
// height of a peak, which follows from it.
struct FarthestOff {
  const MeasuredComparison* row = nullptr; // null: nothing computed is compared
  // Within two standard deviations; within 2 % where the test states none.
  int computed = 0, within = 0;
};
FarthestOff farthest_off(const Results& results);

// "3 of 5 computed numbers lie within 2 sigma (2 % where the test states none)"
std::string within_words(const FarthestOff& found, const std::string& sigma);

// The mode that shows a number: itself, of a peak the nearest by frequency, of a stiffness the
// first that moves the part that way. None without modes, and for a bending stiffness.
std::optional<std::size_t> mode_that_shows(const Results& results, const MeasuredComparison& row);

} // namespace plica
