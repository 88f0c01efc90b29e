// Modes of shape `other` are paired with a model's in their order; what lies between two that are
// paired may have been passed over.
#pragma once

#include "diagnose/predict/nominal.hpp"

#include <string>
#include <vector>

namespace plica {

// Whether a mode would have been seen along an axis: it moves along no other (-1: along any).
bool may_move(const ModeLabel& label, int axis);

// What the test passes over in the nominal case and does not say it has not, a sentence each.
std::vector<std::string> words_of_passed_over(const Nominal& nominal, const TestReadings& test);

} // namespace plica
