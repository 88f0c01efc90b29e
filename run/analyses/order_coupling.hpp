// What damping that couples modes, and stiffness over frequency, add to an order while its speed
// runs, beside each mode by itself (solve/swept_sine.hpp): the difference of the two steady
// responses, by Fourier transforms of the sine that runs. Before it begins, the first speed is held
// until all that rings has died out.
#pragma once

#include "run/analyses/sensor_model.hpp"
#include "solve/swept_sine.hpp"

namespace plica {

// Adds it to Z, every `stride`th sample x channels. `columns`: of the loads in the model;
// `by_mode`: these columns alone, each mode with its own damping. False: the transform would be too
// long, and nothing is added.
bool add_order_coupling(Eigen::MatrixXcd& Z, const SensorModel& model, const DampedModes& modes,
                        const ModalModel& by_mode, const std::vector<int>& columns,
                        const Eigen::VectorXcd& factors, const SweptLoad& load,
                        Eigen::Index stride);

} // namespace plica
