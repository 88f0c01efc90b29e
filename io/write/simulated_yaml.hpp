// A run as a measured.yaml, so that `plica compare` takes simulation and test alike.
#pragma once

#include "lab/measured/measured.hpp"

#include <string>

namespace plica {

// Specimen, source, sensors, mass, static stiffnesses, modes and responses; reads back with
// read_measured() without loss. Peaks, signals and caveats, which no run has, are not written.
std::string simulated_yaml(const Measured& measured);

} // namespace plica
