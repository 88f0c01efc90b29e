// What the loads of decks do, in the report.
#pragma once

#include "run/results/results.hpp"

namespace plica {

std::string deck_loads_html(const Results& results);

} // namespace plica
