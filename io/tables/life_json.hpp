// Stress by place and fatigue life for results.json.
#pragma once

#include "run/results/results.hpp"

#include <nlohmann/json_fwd.hpp>

namespace plica {

nlohmann::ordered_json stress_places_json(const Results& results);
nlohmann::ordered_json life_json(const Results& results); // null without a life

} // namespace plica
