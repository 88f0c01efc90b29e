// Colours of the pictures as "#rrggbb".
#pragma once

#include <string>

namespace plica {

// The viridis map at 0..1: lightness grows evenly from dark to light, so that it reads the same in
// grey and with any colour vision (Nathaniel Smith and Stefan van der Walt, public domain);
// between nine of its colours linearly. `shade` 1 leaves it, smaller is darker.
std::string viridis(double value, double shade = 1);

std::string steel(double shade); // the colour of the undeformed part

} // namespace plica
