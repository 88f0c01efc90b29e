// Responses of a run beside a direct solution of the whole mesh at some frequencies: neither modes,
// nor symmetry, nor superelements stand between it and the stiffness.
#pragma once

#include "run/analyses/sensor_model.hpp"

namespace plica {

// Adds DirectCheck to every response, in the order of `excited.list`: at flanks of the highest
// peaks, where the damping decides, and evenly over the band. Throws std::runtime_error where the
// direct solution fails.
void hold_against_direct_solution(const Response& asked, const BuiltCase& built,
                                  const Damping& damping, const SensorModel& model,
                                  const DampedModes& modes, const Excitations& excited,
                                  std::vector<ResponseResult>& responses);

} // namespace plica
