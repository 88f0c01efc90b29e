// Orders of an engine: the steady response at every speed.
//
// Order o at the speed n (revolutions per second) is a sine of the frequency o n. Inputs of one
// order act together, with their phases; different orders add by their squares. A sweep that is
// faster than 0.9 (2 zeta f)^2 Hz per second (ISO 7626-2, 54 (f/Q)^2 per minute) does not reach the
// steady peak: its `haste` is then above one.
#pragma once

#include "run/analyses/sensor_model.hpp"

namespace plica {

// Throws InputError for an order on what is no excitation of the response.
RunUpResult run_up(const RunUp& asked, const std::string& key, const SensorModel& model,
                   const DampedModes& modes, const Excitations& excited,
                   std::vector<std::string>& warnings);

} // namespace plica
