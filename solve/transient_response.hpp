// Motion of a modal model in time under one sampled load.
//
//   q_j'' + 2 zeta_j omega_j q_j' + omega_j^2 q_j = (Phi' F)_j f(t),   channel = output q''
//
// from rest; f is straight between its samples and every mode steps without error of integration
// (oscillator.hpp). A loss factor eta acts as the viscous damping eta / 2 that has the same loss at
// resonance. Columns faster than half of the sampling rate follow the load statically: the samples
// say nothing of how they ring.
#pragma once

#include "solve/frequency_response.hpp"

namespace plica {

// Accelerations of the channels over that of the samples' unit load: samples x channels, summed
// over the loads (columns of model.input) with the samples of each in a column of `load`. Throws
// std::invalid_argument for fewer than two samples, a step that is not above zero and a mode
// without stiffness.
Eigen::MatrixXd transient_acceleration(const ModalModel& model, const Eigen::MatrixXd& load,
                                       double dt);

// The coordinates q of its columns in place of accelerations of channels: samples x columns.
Eigen::MatrixXd transient_coordinates(const ModalModel& model, const Eigen::MatrixXd& load,
                                      double dt);

} // namespace plica
