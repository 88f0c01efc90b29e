// The state of a case (model/description/operating_state.hpp) on its model.
#pragma once

#include "model/shape/build.hpp"
#include "run/results/state_results.hpp"
#include "run/stages.hpp"

#include <map>

namespace plica {

// The case built with its joints stuck, moved into its state: everything computed from it is around
// that state, also with joints that slip (state_joints.hpp). Throws
// InputError where the case holds nothing; StateError (solve/base_state.hpp) where there is no
// equilibrium.
StateResult move_into_state(const Case& data, BuiltCase& built, const StageListener& stage,
                            std::map<std::string, double>& timing);

// Throws InputError when the case has a state: `what` knows parts at rest alone.
void require_rest(const Case& data, const std::string& what);

} // namespace plica
