// The state around which a run was made, in words, tables and JSON.
#pragma once

#include "io/files/json_text.hpp"
#include "run/results/results.hpp"

#include <string>
#include <vector>

namespace plica {

Json state_json(const StateResult& state);

// What acts, where it led, and whether a linear state would have been good enough.
std::vector<std::string> state_sentences(const StateResult& state);

// "2.31 times these loads, 93 % across the axis"
std::vector<std::string> buckling_sentences(const StateResult& state);

} // namespace plica
