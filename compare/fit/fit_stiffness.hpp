// Dynamic stiffness that a rig measured, in a fit: what a table holds of one direction, quantity
// and amplitude is a target, over its frequencies.
//
// Residuals are (computed - measured) / (sigma |k|), of a loss angle over sigma alone: a standard
// deviation of the complex stiffness over its magnitude. |k| is that of the test; where it has the
// loss alone, that of the model at the start.
#pragma once

#include "lab/measured/measured.hpp"
#include "model/description/case.hpp"

#include <Eigen/Core>

namespace plica {

struct FitStiffness {
  std::string name, entry;                // "y storage at 0.1 mm", "stiffness[0]"
  std::vector<std::string> ends;          // as in the table
  std::vector<MeasuredStiffness> numbers; // over the frequency
  Eigen::VectorXd size;                   // of each: |k|; of an angle 1
  double sigma = 0;
  bool held_out = false;
};

// Of the entries that the case as drawn answers (lab/measured/states.hpp). `size` is NaN where the
// test does not give it; `sigma` zero where the table states none.
std::vector<FitStiffness> stiffness_targets(const Measured& measured);

// Computed values of each target, in their order; NaN where harmonic balance finds no motion.
// Throws InputError as part_stiffness() does.
std::vector<Eigen::VectorXd> computed_stiffness(const Case& design,
                                                const std::vector<FitStiffness>& targets);

// Sizes that the test leaves open become those of this case.
void complete_sizes(const Case& start, std::vector<FitStiffness>& targets);

// (computed - measured) / size.
Eigen::VectorXd deviations_of(const FitStiffness& target, const Eigen::VectorXd& computed);

} // namespace plica
