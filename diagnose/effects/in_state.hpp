// Effects that bring the specimen into a state (model/description/operating_state.hpp): what it is
// measured in, and the case does not say.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// The case names the effect, among its effects or its priors. A state is solved for every sample of
// it, which takes seconds, and in a laboratory there is none.
bool asked_for(const Structure& s, const std::string& effect);

// Changes of the case that put it into states.
std::vector<std::function<void(Case&)>>
into_states(const std::vector<std::function<void(OperatingState&)>>& states);

} // namespace plica
