// The analyses of a case on a route that the caller makes, for solvers of their own.
#pragma once

#include "run/results/results.hpp"
#include "run/routes/route.hpp"

namespace plica {

// As choose_route() does: built and timing outlive the route.
using RouteChoice = std::function<std::unique_ptr<Route>(
    const BuiltCase& built, const Analyses& analyses, const StageListener& stage, Timing& timing)>;

// As run() of run/analyses/run.hpp, which takes choose_route(). Asked for once, and again for
// joints that slip.
Results run_by_route(const Case& data, const StageListener& stage, const RouteChoice& choose);

} // namespace plica
