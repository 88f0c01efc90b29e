// Steady response of a modal model; of the whole model without modes: direct_response.hpp.
//
//   (lambda_j (1 + i eta_j) - omega^2 + 2 i zeta_j sqrt(lambda_j) omega) q_j = Phi_j' F
//   u = sum Phi_j q_j
//
// Base motion: the held DOFs move as a rigid body with unit acceleration, the rest is u_rel + r.
// Then F = -M r over the free DOFs, r holding the held ones too. Absolute acceleration: r - omega^2
// u_rel (run/analyses/sensor_model.hpp); on a rigid part it equals that of the base.
#pragma once

#include "solve/static_correction.hpp"

#include <complex>

namespace plica {

struct ModalModel {
  Eigen::VectorXd lambda;
  Eigen::VectorXd zeta;   // viscous, fraction of critical
  Eigen::VectorXd eta;    // structural loss factor
  Eigen::MatrixXd output; // channels x modes: displacement of a channel per modal coordinate
  Eigen::MatrixXd input;  // modes x loads: Phi' F
};

// Displacements, frequencies x channels, under one load. In parallel over the frequencies.
// omega in rad/s.
Eigen::MatrixXcd frequency_response(const ModalModel& model, int load,
                                    const Eigen::VectorXd& omega);

} // namespace plica
