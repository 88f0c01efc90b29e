// Readings of response curves: their strong peaks, and what shows at other sensors and along other
// axes.
#pragma once

#include "diagnose/readings/reading_list.hpp"

namespace plica {

void add_response_readings(const TestData& test, ReadingList& list);

} // namespace plica
