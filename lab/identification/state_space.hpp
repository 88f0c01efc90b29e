// Modes of linear systems x_{k+1} = A x_k, y_k = C x_k of rising order from what their outputs
// span.
//
//   O = [C; C A; C A^2; ..],   A = O_up^+ O_down,   C = the first block of O
//   A psi = mu psi,   lambda = ln(mu) rate,   shape = C psi
//
// O_up is O without its last block of rows, O_down without its first. O is any basis of the space
// that the outputs span: Juang and Pappa, J. Guidance 8 (1985) 620-627; Peeters and De Roeck,
// Mech. Syst. Signal Process. 13 (1999) 855-878.
#pragma once

#include "lab/identification/lscf.hpp"

namespace plica {

// A of a basis: rows are blocks of one row a channel.
Eigen::MatrixXd transition(const Eigen::MatrixXd& O, Eigen::Index channels);

// Oscillating, stable modes with damping below 50 %, by frequency; `participation` is the shape at
// the channels, of unit length.
std::vector<Pole> poles_of_states(const Eigen::MatrixXd& O, Eigen::Index channels, double rate);

// Those of the leading 2, 4, .. columns of a basis whose columns come in the order of what they
// explain; `order` counts pairs of poles.
std::vector<PolesOfOrder> poles_of_rising_order(const Eigen::MatrixXd& O, Eigen::Index channels,
                                                double rate);

} // namespace plica
