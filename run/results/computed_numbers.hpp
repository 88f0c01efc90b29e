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

// The headline with the stress ranges of the duties of a life ("life_NAME"), the static stiffness
// in all directions, of the two across the pipe the smaller one, and "damage" by Miner's sum at the
// worst place.
std::map<std::string, double> computed_numbers_of(const Results& results);

} // namespace plica
