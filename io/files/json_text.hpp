// JSON files as all of them are written: numbers that do not exist, or are not finite, are null;
// bytes that are no UTF-8 (names from a lab in another code page) become U+FFFD.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace plica {

using Json = nlohmann::ordered_json;

inline Json json_number(const std::optional<double>& x) {
  return x && std::isfinite(*x) ? Json(*x) : Json(nullptr);
}

// One line of ASCII, to stand in a page.
inline std::string json_in_page(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

inline std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace plica
