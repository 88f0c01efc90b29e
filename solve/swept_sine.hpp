// Motion of a modal model under sines of one phase that runs faster or slower: an order of an
// engine while it runs up.
//
//   q_j'' + 2 zeta_j omega_j q_j' + omega_j^2 q_j = e^{i phi(t)} sum_k (Phi' F)_jk a_k(t)
//
// The model is linear, so the answer to the complex load is the cosine's answer in its real part
// and the sine's in its imaginary one, and Z(t) = q'' e^{-i phi(t)} is amplitude and phase of that
// order at that moment, with no filter. Every mode steps as in transient_response.hpp; it begins as
// it would run steadily at the first speed. A straight line between samples loses sinc^2 of the
// sine, which is given back. Loss factors act as the viscous damping of the same loss at resonance.
#pragma once

#include "solve/frequency_response.hpp"

namespace plica {

struct SweptLoad {
  double dt = 0;             // s, between samples
  Eigen::VectorXd phase;     // rad, per sample
  Eigen::VectorXd rate;      // its derivative, rad/s, > 0
  Eigen::MatrixXd amplitude; // samples x loads (columns of model.input)
};

// Z of the channels at every `stride`th sample, these x channels: accelerations against what
// carries them. `factors`: of the loads. Throws std::invalid_argument for fewer than three samples,
// a step that is not above zero, sizes that do not fit and a mode without stiffness.
Eigen::MatrixXcd swept_acceleration(const ModalModel& model, const Eigen::VectorXcd& factors,
                                    const SweptLoad& load, Eigen::Index stride);

} // namespace plica
