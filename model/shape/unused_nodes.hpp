// Nodes that nothing uses and DOFs that nothing reaches, in a model read from elsewhere.
#pragma once

#include "solve/model.hpp"

namespace plica {

// Leaves away the nodes that no element and no constraint uses: numbers, sets and constraints
// follow. Gives the number of each node afterwards, -1 of those that are gone.
std::vector<int> drop_unused_nodes(Model& model);

// Holds the DOFs that no element and no constraint reaches: neither with stiffness nor with mass,
// or, `by_stiffness_alone`, whatever mass they have.
void hold_what_nothing_reaches(Model& model, bool by_stiffness_alone);

} // namespace plica
