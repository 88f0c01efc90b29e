// What a test says of its own scatter by measuring one thing more than once.
#pragma once

#include "diagnose/readings/reading.hpp"

namespace plica {

// Frequencies and damping ratios of one peak, base, direction, level and state, and the mass of one
// state, that were measured several times, in one entry or another: where these differ by more than
// was assumed, all readings of their kind whose standard deviation is an assumption get the pooled
// one, and a warning says so. What the test states is left.
void widen_by_repeats(TestReadings& test);

// A mode known by its kind that was measured several times in one state, driven alike, or a mass
// weighed several times in one state, is one reading: the mean of the logarithms, weighed by what
// is stated of them, and known so much better. How the specimen was mounted, and what an effect
// does otherwise than a hypothesis says, is the same in all of them; as readings of their own they
// would count it down. Transverse modes without a direction stay apart: they may be the two of a
// pair.
void pool_repeats(TestReadings& test);

} // namespace plica
