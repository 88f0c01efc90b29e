// Models of a diagnosis around the state in which the part works.
#pragma once

#include "model/description/case.hpp"
#include "model/shape/built_case.hpp"

#include <functional>

namespace plica {

// The model of a case, which stands on its table (build_on_table), in the state of the case; at
// rest where nothing acts. Throws StateError where there is no equilibrium.
Model model_in_state(const Case& data, BuiltCase built);

// A change of a model as one around a state. The part stays where the state has brought it: beams
// and springs that become stiffer or softer bear what they bore, further springs bear nothing,
// walls keep their strain. At rest it is the change itself.
std::function<void(Model&)> around_state(std::function<void(Model&)> change);

} // namespace plica
