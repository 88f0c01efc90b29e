// Measured numbers beside the computed ones of a run.
#pragma once

#include "diagnose/measured.hpp"
#include "model/results.hpp"

namespace plica {

// Mass, static stiffnesses and modes that both sides have. A measured mode is paired with the first
// computed mode of its shape (and direction, where the measurement states one).
std::vector<MeasuredComparison> compare(const Results& results, const Measured& measured);

// In words: measured modes that answer in a direction in which the model's response to that base
// motion has no peak at all.
std::vector<std::string> unanswered(const Results& results, const Measured& measured);

} // namespace plica
