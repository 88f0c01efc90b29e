// Effects that bring the specimen into a state (model/description/operating_state.hpp): what it is
// measured in, and the case does not say.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// Changes of the case that put it into states. A state is solved for each, which takes seconds, and
// in a laboratory there is none: the effects are tried where they are asked_for().
std::vector<std::function<void(Case&)>>
into_states(const std::vector<std::function<void(OperatingState&)>>& states);

} // namespace plica
