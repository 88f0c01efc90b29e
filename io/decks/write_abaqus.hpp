// The whole unreduced model of a case as an Abaqus deck, to be checked in another solver: nodes, S4
// shells, B31 beams, couplings, masses, springs, what is held, the frequency step, and a
// base-motion step per direction. CalculiX reads it too, but for beams.
//
// Couplings are written as *EQUATION, term by term as Plica solves them. The rotations of a node
// that no shell or beam holds (a cap's reference node) are translations 1 to 3 of a second node in
// the same place, so that no program needs rotations where it has none; a rotary inertia is three
// masses there, one per principal axis. A wall of slipping plies is a section with the same
// membrane and bending stiffness and mass: t sqrt(f), E / sqrt(f), rho / sqrt(f), f the bending
// factor. Units: SI.
#pragma once

#include "model/shape/build.hpp"
#include "solve/acting_loads.hpp"

#include <string>

namespace plica {

// Numbers have 13 digits and an exponent: a field of Abaqus and CalculiX holds 20 characters, what
// is longer is cut, exponent first, and CalculiX takes a stiffness without a point for none.
// Throws std::runtime_error naming what the deck cannot hold.
std::string abaqus_model(const Case& data, const BuiltCase& built);

// In the state of the case: a static step with its loads, and the modes around it
// (abaqus_state.hpp). `built`: as state_loads() (run/routes/state_loads.hpp) leaves it. Throws
// InputError, too.
std::string abaqus_model_in_state(const Case& data, const BuiltCase& built,
                                  const StateLoads& loads);

} // namespace plica
