// Stiffness between two caps as results list it.
#pragma once

#include "run/results/results.hpp"
#include "run/routes/route.hpp"

namespace plica {

// `at_state`: bending may be below zero.
StaticStiffness static_stiffness(const Matrix1212& K, bool at_state);

} // namespace plica
