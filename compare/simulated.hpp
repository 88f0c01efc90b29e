// A run in the form of measured data, so that simulation and test can change places.
#pragma once

#include "lab/measured/measured.hpp"
#include "run/results/results.hpp"

namespace plica {

// Sensors, mass, static stiffnesses, elastic modes with their shapes at the sensors (in sensor
// axes), and one frf entry per motion of the base: file response_<base>.csv.
Measured as_measured(const Results& results);

// The responses themselves: one set per direction of the base, transmissibilities.
std::vector<FrfSet> responses_to_base(const Results& results);
// One set per force in N, accelerances; the reference is named after it: "tap.y".
std::vector<FrfSet> responses_to_forces(const Results& results);

} // namespace plica
