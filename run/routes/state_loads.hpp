// What the state of a case puts on its model: sections with temperature and pressure, ground that
// moves, forces.
#pragma once

#include "model/shape/build.hpp"
#include "run/results/state_results.hpp"
#include "solve/base_state.hpp"

namespace plica {

// Changes the model; says in the result what acts. Throws InputError where heat has no way.
StateLoads state_loads(const Case& data, BuiltCase& built, StateResult& result);

} // namespace plica
