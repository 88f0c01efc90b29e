// What to measure to tell apart what a test does not.
#pragma once

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/predict/menu.hpp"

namespace plica {

inline constexpr std::size_t most_told_apart = 8; // sets that are looked at

// Says it of each row of the ledger that stands for several effects. Of the menu it is what puts
// the sets that hold one of them farthest from those that hold another, for its cost and at their
// best numbers; where nothing on it puts them three standard deviations apart, what the effects say
// of their look-alikes. `told`: the sets that the rows are of, the best first. Returns a warning
// where there is such a row and not all of them were looked at, else nothing.
std::string say_what_tells_apart(const GapProblem& problem, const OfferedReadings& menu,
                                 const std::vector<HypothesisFit>& told, Ledger& ledger);

} // namespace plica
