// Responses measured, and as the models have them.
#pragma once

#include "diagnose/account/gap_problem.hpp"

#include <vector>

namespace plica {

// The first four; `second` may be null.
std::vector<OverlaidResponse> overlays_of(GapProblem& problem, const HypothesisFit& best,
                                          const HypothesisFit* second);

} // namespace plica
