// Section of the report on responses at several levels.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string levels_html(const Results& results);

} // namespace plica
