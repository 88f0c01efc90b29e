// Effects that are of another size in every changed state: damage that grows.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// States in which something was measured that are neither a baseline nor a known change, in the
// order of the test.
std::vector<std::string> changed_states(const Measured& measured);

// The hypothesis with a size of its own in every one of the states, one effect at one place all the
// same. Elsewhere it is as in the last. What slips has one law in all of them.
Hypothesis grown(Hypothesis h, const std::vector<std::string>& states);

} // namespace plica
