// The dynamics of a run: modes with their proof, responses, transients, run-ups, dynamic stress.
#pragma once

#include "run/analyses/direct_solution.hpp"
#include "run/analyses/life.hpp"
#include "run/results/results.hpp"
#include "run/routes/route.hpp"

namespace plica {

// What case.analyses asks for beside its modes goes into the results, and into `life` where there
// is one. `built`: what the route gives fields of; shapes are kept where the results have its mesh.
// Throws InputError for what cannot be answered.
void run_dynamics(const Case& data, const BuiltCase& built, Route& route,
                  const StageListener& stage, LifeCount* life, Results& results,
                  const DirectSolver& direct = solve_directly);

} // namespace plica
