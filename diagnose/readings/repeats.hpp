// What a test says of its own scatter by measuring one thing more than once.
#pragma once

#include "diagnose/readings/reading.hpp"

namespace plica {

// Frequencies and damping ratios of one peak, base, direction, level and state that were measured
// several times, in one entry or another: where these differ by more than was assumed, all readings
// of their kind whose standard deviation is an assumption get the pooled one, and a warning says
// so. What the test states is left.
void widen_by_repeats(TestReadings& test);

} // namespace plica
