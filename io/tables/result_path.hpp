// Numbers of results.json by a path: "modes[0].frequency", "responses[base=y].peaks[0].amplitude":
// an index from 0, or the first entry of which a key has that text.
#pragma once

#include "io/files/json_text.hpp"

#include <optional>
#include <string>

namespace plica {

// What is wrong with a path; empty = it is one.
std::string bad_result_path(const std::string& path);

// None where there is no number; true is 1, false 0.
std::optional<double> number_in(const Json& results, const std::string& path);

} // namespace plica
