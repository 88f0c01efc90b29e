// Sets whose members change the model: while sets are searched these changes are added up, which is
// off where two of them act on the same elements. Those that may count are fitted anew with what
// members do to each other, but no more than so many.
#pragma once

#include "diagnose/judge/judged_fit.hpp"

namespace plica {

inline constexpr double may_count = 8; // nats behind the best
inline constexpr std::size_t most_solved_anew = 8;

// Whether two or more change stiffness or mass.
bool change_together(const std::vector<const Hypothesis*>& members);

// Of sets sorted by evidence, at least one: of those that explain the test, else of all.
const JudgedFit& best_of(const std::vector<JudgedFit>& sets);

// A warning where of sets that may count some were not fitted anew (JudgedFit::added_up); else
// nothing.
std::string warning_of_added_up(const std::vector<JudgedFit>& sets);

} // namespace plica
