// Beams that are tightened to a force on the way into a state.
#pragma once

#include "model/description/operating_state.hpp"
#include "model/shape/built_case.hpp"
#include "run/results/state_results.hpp"

namespace plica {

// The element in the middle of each of these beams bears the force of its bolt, whatever its
// length; the rest of the beam is elastic. `built`: at rest.
void tighten_bolts(const std::vector<BoltForce>& bolts, BuiltCase& built);

// At the state: that element is elastic again, shorter by what tightened it.
void settle_bolts(const std::vector<BoltForce>& bolts, BuiltCase& built, StateResult& result);

} // namespace plica
