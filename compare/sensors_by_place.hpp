// Sensors of two sides by where they stand.
#pragma once

#include "lab/measured/measured.hpp"

namespace plica {

// The test with its sensors called as those of the simulation within `reach` (m), nearest first and
// each once, their channels turned into the axes of these. Sensors that have the name of one
// already stay. Says how many were found in a caveat.
Measured named_by_place(Measured test, const Measured& simulated, double reach = 5e-3);

} // namespace plica
