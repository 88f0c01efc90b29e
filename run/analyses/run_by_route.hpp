// The analyses of a case on a route that the caller makes, for solvers of their own.
#pragma once

#include "run/analyses/direct_solution.hpp"
#include "run/analyses/seen_enough.hpp"
#include "run/results/results.hpp"
#include "run/routes/route.hpp"

namespace plica {

// As choose_route() does: built, `seen` (none: all nodes are) and timing outlive the route.
using RouteChoice = std::function<std::unique_ptr<Route>(
    const BuiltCase& built, const SeenCase* seen, const Analyses& analyses,
    const StageListener& stage, Timing& timing)>;

struct Solvers {
  RouteChoice route; // asked for once, and again for joints that slip
  DirectSolver direct = solve_directly;
};

// As run() of run/analyses/run.hpp, which takes choose_route().
Results run_by_route(const Case& data, const StageListener& stage, const Solvers& solvers,
                     Shapes shapes = Shapes::kept);

} // namespace plica
