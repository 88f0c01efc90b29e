// Joints of a case in its state. On the way there they bear the forces of their first loading;
// around it they stick, or slip from where they are.
#pragma once

#include "model/shape/built_case.hpp"
#include "run/results/state_results.hpp"

namespace plica {

// Springs for what the joints bear in the state beyond small motion at rest. `built`: with its
// joints stuck, at rest.
void load_joints(BuiltCase& built);

// At the state: what moved each joint is its offset; its springs have the stiffness of small motion
// from there (every slider sticks after a reversal) and bear what the state makes them.
void settle_joints(BuiltCase& built, StateResult& result);

// The same state with joints that slip: the model has the slope of their nonlinear springs there,
// and their laws what is beside it, as build_slipping() has them at rest.
BuiltCase slipping_in_state(BuiltCase settled);

} // namespace plica
