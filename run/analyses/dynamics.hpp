// The dynamics of a run: modes with their proof, responses, transients, run-ups, dynamic stress.
#pragma once

#include "run/results/results.hpp"
#include "run/routes/route.hpp"

namespace plica {

// What case.analyses asks for beside its modes goes into the results. Throws InputError for what
// cannot be answered.
void run_dynamics(const Case& data, const BuiltCase& built, Route& route,
                  const StageListener& stage, Results& results);

} // namespace plica
