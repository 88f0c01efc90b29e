// Responses at several levels with the friction of the joints.
#pragma once

#include "run/analyses/jointed_model.hpp"
#include "run/results/level_results.hpp"

namespace plica {

// Of the balance that the levels ask for.
HarmonicSettings harmonic_settings(const Levels& levels, JointMethod method);

// One responses per excitation. `stage` is told which level runs.
std::vector<LevelResponses> level_responses(const JointedModel& model, const Levels& levels,
                                            const StageListener& stage);

} // namespace plica
