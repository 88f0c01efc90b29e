// Responses at several levels for results.json.
#pragma once

#include "run/results/results.hpp"

#include <nlohmann/json_fwd.hpp>

namespace plica {

nlohmann::ordered_json levels_json(const Results& results);
nlohmann::ordered_json slipping_json(const SlippingLimit& slipping);

} // namespace plica
