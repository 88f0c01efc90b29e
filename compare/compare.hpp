// Measured numbers beside the computed ones of a run.
#pragma once

#include "lab/measured/measured.hpp"
#include "lab/measured/test_data.hpp"
#include "run/results/results.hpp"

namespace plica {

// Mass, static stiffnesses, modes and peaks that both sides have. Measured modes of one shape (and
// direction, where stated) are paired with the computed ones of it from the lowest up; as peaks,
// with the largest peaks of the response to their base motion in their direction, by frequency.
// Of a test of several states, what the case as drawn answers (lab/measured/states.hpp).
std::vector<MeasuredComparison> compare(const Results& results, const Measured& measured);

// In words: measured modes that answer across their base motion where, within the band, the model
// does not (below a thousandth of its largest channel).
std::vector<std::string> unanswered(const Results& results, const Measured& measured);

// Puts measured transmissibilities beside the responses to motion of the base: of each response
// those of the level nearest to its own.
void add_test_curves(Results& results, const TestData& test);

} // namespace plica
