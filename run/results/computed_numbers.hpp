// Numbers of a run by name, as goals and limits of a fit ask for them.
#pragma once

#include "run/results/results.hpp"
#include "words/field_types.hpp"

namespace plica {

struct ComputedNumber {
  const char* name;
  Dimension unit;
};
const std::vector<ComputedNumber>& computed_numbers();
std::optional<Dimension> unit_of_computed(const std::string& name);

// SI unit by the name of such a number, or by the path of a result: "life_road",
// "modes[0].frequency", "static.k_bending.x"; empty for a plain number and for what is not known.
std::string unit_of_result(const std::string& path);

// The headline with the stress ranges of the duties of a life ("life_NAME"), the static stiffness
// in all directions, of the two across the pipe the smaller one, and "damage" by Miner's sum at the
// worst place.
std::map<std::string, double> computed_numbers_of(const Results& results);

} // namespace plica
