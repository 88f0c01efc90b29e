// Transients and shocks of a run: the response of the sensors to one input over time.
#pragma once

#include "run/analyses/sensor_model.hpp"

namespace plica {

// Throws InputError for an input that is no excitation of the response or that moves ends with
// phases, and for more samples than fit. A warning where damping that couples modes is taken mode
// by mode, since what rings is too long for it.
TransientResult transient(const Transient& asked, const std::string& key, const SensorModel& model,
                          const DampedModes& modes, const Excitations& excited,
                          std::vector<std::string>& warnings);

} // namespace plica
