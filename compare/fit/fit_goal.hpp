// What a target of a fit may ask for besides what was measured: a computed quantity, or a number of
// the case, that is to meet a value, or to be as small or as large as the constraints let it be.
//
//   k_axial = 50 kN/m      least mass      most f_axial
//
// And limits of them, as constraints say them: f_axial >= 250 Hz, mass <= 1.75 kg, damage <= 1.
#pragma once

#include "model/description/case.hpp"

namespace plica {

enum class GoalAim { value, least, most };

struct FitGoal {
  std::string quantity; // of computed_numbers() (run/results/computed_numbers.hpp), or a path
  GoalAim aim = GoalAim::value;
  double value = 0; // SI
};

struct FitLimit {
  std::string quantity;
  bool least = false; // the value is a lower limit
  double value = 0;
};

template <class T> struct Parsed {
  T value;
  std::string wrong, allowed; // empty = good
};

// Whether a target is one of these, and not the name of something measured.
bool is_goal(const std::string& words);
std::string quantity_of_goal(const std::string& words); // of such a one
Parsed<FitGoal> goal_of(const std::string& words, const Case& data);
Parsed<FitLimit> limit_of(const std::string& words, const Case& data);

// A computed quantity, or a number of the case; none where the model does not show it.
std::optional<double> number_of(const std::string& quantity,
                                const std::map<std::string, double>& computed, const Case& data);
// In SI; empty for a pure number.
std::string unit_of_goal(const std::string& quantity, const Case& data);

} // namespace plica
