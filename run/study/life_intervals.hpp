// Intervals of lives from the error bars of a run.
#pragma once

#include "model/description/case.hpp"
#include "run/results/results.hpp"

namespace plica {

// 5 and 95 % of the life of every duty of one stress range, by the interval that the tolerances
// leave its range; of the damage of every other duty and of all at the worst spot, by the interval
// that they leave the damage; and of both by the deviation of a mean curve, 1.645 of it. As
// logarithms, root of the sum of their squares. None of either: no interval. A damage that is "at
// most" has an interval of that bound.
void add_life_intervals(const Case& data, Results& results);

} // namespace plica
