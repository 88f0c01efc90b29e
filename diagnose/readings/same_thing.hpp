// Which readings are of one and the same thing.
#pragma once

#include "diagnose/readings/reading.hpp"

#include <functional>
#include <vector>

namespace plica {

// Whether two readings are of one thing, whatever state and level: the lab's names decide.
bool same_thing(const TestReadings& test, const Reading& a, const Reading& b);
// Of each reading a number that it shares with those of which `alike` says so, or which are alike
// to those: what these share is a covariance.
std::vector<int> numbered(const TestReadings& test,
                          const std::function<bool(const Reading&, const Reading&)>& alike);

} // namespace plica
