// Dynamic stiffness as tables and words.
#pragma once

#include "compare/compare_stiffness.hpp"

namespace plica {

// "0.1 mm", "0.1 mm, 0.05 deg", "small motion".
std::string level_name(const MotionLevel& level);

// A row per state, level and frequency, storage, loss and loss angle of every term that is not zero
// throughout: force or moment on an end coordinate by the motion of one.
std::string stiffness_csv(const EndDynamicStiffness& s);

// What a rig measures by ISO 10846, a row per state, level, frequency and direction: driving-point
// stiffness of both ends, and the blocked transfer stiffness with its level (dB, 1 N/m or
// 1 Nm/rad).
std::string transfer_stiffness_csv(const EndDynamicStiffness& s);

std::string stiffness_comparison_csv(const std::vector<StiffnessComparison>& rows);

// A few lines for the terminal: transfer stiffness and loss angle of each direction at the lowest,
// the middle and the highest frequency.
std::string stiffness_text(const EndDynamicStiffness& s,
                           const std::vector<StiffnessComparison>& compared);

// Terms of the 12 x 12 that are above rounding somewhere, row by row.
std::vector<std::array<int, 2>> terms_of(const EndDynamicStiffness& s);

// Of a quantity of a test.
struct ShownDeviation {
  std::string name, unit;
  int count = 0;
  double mean = 0, root_mean_square = 0, largest = 0; // of computed / measured - 1; angles: rad
};
std::vector<ShownDeviation> deviations(const std::vector<StiffnessComparison>& rows);

} // namespace plica
