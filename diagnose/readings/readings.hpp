// The readings of a test.
#pragma once

#include "diagnose/readings/reading.hpp"

namespace plica {

// Standard deviations where none are stated: mass 0.2 %, stiffness 1.5 %, frequency 0.25 %, of
// modes of more than 1 % of damping by its root more, damping 6 %, amplitude 5 %. Without entries
// to hold out: the highest level where there are three or more, else none.
TestReadings readings_of(const TestData& test);

} // namespace plica
