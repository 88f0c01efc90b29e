// Responses of a run beside a direct solution of the whole mesh at some frequencies.
#pragma once

#include "run/analyses/direct_solution.hpp"

namespace plica {

// Adds DirectCheck to every response, in the order of `excited.list`: at flanks of the highest
// peaks, where the damping decides, and evenly over the band. Throws std::runtime_error where the
// direct solution fails.
void hold_against_direct_solution(const Response& asked, const SensorModel& model,
                                  const DirectProblem& problem, const DirectSolver& solver,
                                  std::vector<ResponseResult>& responses);

} // namespace plica
