// The response analyses of a run: motion of the mount and forces, each on its own and together.
#pragma once

#include "run/analyses/sensor_model.hpp"

namespace plica {

// Frequencies of the response: the band of the case, refined around its modes, with the corners of
// the random inputs and both sides of their ends.
Eigen::VectorXd response_grid(const Response& asked, const DampedModes& modes);

// One response per excitation. Throws InputError for a mode of the band without any damping and for
// a cross density of a channel that is not there.
std::vector<ResponseResult> responses(const Response& asked, const SensorModel& model,
                                      const DampedModes& modes, const Excitations& excited);

} // namespace plica
