// Damped sinusoids in free decays by least squares.
//
//   y_od(t) = sum_r Re(R_rod e^{l_r t}) + c_od,    t = 0 at the first sample
//
// o the channel, d the decay: all have the same poles. Of noise that is white, or nearly, this is
// the maximum-likelihood estimate; its covariance is that of pole_search.hpp. Limits: linear and
// free, so no force and no frequency that falls with the amplitude.
#pragma once

#include "lab/identification/modal_fit.hpp"
#include "lab/identification/pole_search.hpp"

namespace plica {

// Decays of one length, each time x channels.
using Decays = std::vector<Eigen::MatrixXd>;

// `residue` of the modes is R, channels x decays; `lower` is c, `upper` zero, `H` empty. With no
// iterations the poles are held. Throws std::invalid_argument when the samples are too few for the
// poles.
ModalFit fit_decays(const Decays& decays, double rate, const Poles& poles, int iterations = 50);

// What a fit says the decays are.
Decays synthesised_decays(const ModalFit& fit, double rate, Eigen::Index samples);

} // namespace plica
