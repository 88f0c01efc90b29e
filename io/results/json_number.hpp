// Numbers in JSON files: what does not exist, or is not finite, is null.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace plica {

using Json = nlohmann::ordered_json;

inline Json json_number(const std::optional<double>& x) {
  return x && std::isfinite(*x) ? Json(*x) : Json(nullptr);
}

} // namespace plica
