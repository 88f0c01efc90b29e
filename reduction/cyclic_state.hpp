// States that keep the rotational symmetry: solved in the one harmonic they live in.
#pragma once

#include "reduction/cyclic_model.hpp"
#include "solve/base_state.hpp"

namespace plica {

// Stretch along the axis, pressure, temperatures that are the same all round: every node moves in
// its own plane through the axis. False for anything else.
bool is_axisymmetric(const Model& at_rest, const StateLoads& loads);

// The stiffness of the harmonic n = 0 alone, and the forces of one sector in place of all.
// Stability against other harmonics is not seen here: the modes around the state show it. Throws
// StateError when the model has lost its symmetry.
StateSolver cyclic_state_solver(const Model& at_rest, std::vector<int> holds);

} // namespace plica
