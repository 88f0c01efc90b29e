// Measured numbers beside the computed ones of a run.
#pragma once

#include "diagnose/measured.hpp"
#include "model/results.hpp"

namespace plica {

// Mass, static stiffnesses and modes that both sides have. A measured mode is paired with the first
// computed mode of its shape (and direction, where the measurement states one).
std::vector<MeasuredComparison> compare(const Results& results, const Measured& measured);

} // namespace plica
