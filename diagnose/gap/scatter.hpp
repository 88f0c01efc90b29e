// What varies between admissible specimens and tests: the scatter that no effect has to explain.
//
// Young's modulus 1 %, density 0.5 %, wall thickness 1 % where the drawing gives no tolerance, a
// smooth field of the wall's stiffness 2 %, masses 1 %, joints and interlocks 5 %, all damping 8 %
// and that of each mode 12 %, gain of a sensor 1 %, its axes 1 degree and its place 1 mm, motion of
// the table along other axes 0.5 %; and the tolerances of the case itself. One standard deviation
// each.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

std::vector<Hypothesis> scatter(const Structure& s);

constexpr double scatter_of_mode_damping = 0.12; // relative, each mode on its own

} // namespace plica
