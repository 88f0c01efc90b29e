// What a diagnosis took for granted, in words with its numbers.
#pragma once

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/judge/judge.hpp"

namespace plica {

// `without`: guards that were left out.
std::vector<std::string> assumptions_of(const GapProblem& problem, const Standards& standards,
                                        const Guards& without);

} // namespace plica
