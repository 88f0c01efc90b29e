// Transients and run-ups for results.json.
#pragma once

#include "run/results/results.hpp"

#include <nlohmann/json_fwd.hpp>

namespace plica {

nlohmann::ordered_json transients_json(const Results& results);
nlohmann::ordered_json run_ups_json(const Results& results);

} // namespace plica
