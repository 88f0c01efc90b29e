// Section of the report on the state around which everything was computed.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string state_html(const Results& results); // empty: the part at rest

} // namespace plica
