// Transients and shocks of a run: the response of the sensors to one input over time.
#pragma once

#include "run/analyses/sensor_model.hpp"

namespace plica {

// Throws InputError for an input that is no excitation of the response or that moves ends with
// phases, and for more samples than fit.
TransientResult transient(const Transient& asked, const std::string& key, const SensorModel& model,
                          const DampedModes& modes, const Excitations& excited);

} // namespace plica
