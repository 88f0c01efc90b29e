// What the loads of decks do, as tables and for results.json.
#pragma once

#include "run/results/results.hpp"

#include <nlohmann/json_fwd.hpp>

namespace plica {

// One row per load case and node of the deck: place, displacement, reaction where it is held.
std::string deck_loads_csv(const Results& results);

nlohmann::ordered_json deck_loads_json(const Results& results);

} // namespace plica
