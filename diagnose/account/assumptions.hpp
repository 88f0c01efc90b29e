// What a diagnosis took for granted, in words with its numbers.
#pragma once

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/judge/judge.hpp"

#include <set>

namespace plica {

// `without`: guards that were left out.
std::vector<std::string> assumptions_of(const GapProblem& problem, const Standards& standards,
                                        const std::set<std::string>& without);

} // namespace plica
