// Covariance-driven stochastic subspace identification and its first-order uncertainty.
//
//   R_i = 1/(N - i) sum_t y_{t+i} y_t^ref',   H = [R_{i+j+1}], i = 0 .. p, j = 0 .. p-1
//   H = U S V',   O = the leading columns of U   (state_space.hpp)
//
// Peeters and De Roeck, Mech. Syst. Signal Process. 13 (1999) 855-878. The record is cut into
// blocks; the scatter of their correlations R_i^k about R_i is that of H, and each function of H
// scatters by its derivative in the directions H^k - H:
//
//   var x = 1/b^2 sum_k sum_l w_{l-k} dx_k dx_l,    dx_k = <dx/dH, H^k - H>
//
// with Bartlett's weights over as many neighbours as the mode remembers (Newey and West 1987): the
// blocks are shorter than lightly damped modes ring. dx/dH goes through the singular vectors, all
// of them, and the eigenvectors of A: Reynders, Pintelon and De Roeck, Mech. Syst. Signal Process.
// 22 (2008) 948-969; one derivative a mode, not one a block, as Doehler and Mevel, ibid. 38 (2013)
// 346-366, order the products. Singular vectors move within their space without moving the modes:
// only what leaves it counts.
//
// Limits: first order, so for deviations small against the damping; stationary white excitation;
// a bias of short records (fewer than about a hundred decay times) is not in the uncertainty.
#pragma once

#include "lab/identification/lscf.hpp"

namespace plica {

struct Correlations {
  std::vector<Eigen::MatrixXd> R;                   // lags 1 .. 2p: channels x references
  std::vector<std::vector<Eigen::MatrixXd>> blocks; // the same of each block, whose mean is R
  Eigen::Index block = 0;                           // samples of a block
};

// `samples` time x channels, without their means; `references` are columns of them; `lags` = 2p.
// Blocks hold twice the lags or more, 200 of them at most. Throws std::invalid_argument where
// fewer than 20 fit.
Correlations correlations(const Eigen::MatrixXd& samples,
                          const std::vector<Eigen::Index>& references, Eigen::Index lags);

struct Subspace {
  Eigen::MatrixXd U, V; // all columns
  Eigen::VectorXd S;
  Eigen::Index channels = 0, references = 0;
};
Subspace subspace(const Correlations& correlations);

// A mode at one order with what it is uncertain by; the shape has its largest component 1.
struct StochasticMode {
  std::complex<double> lambda;
  double sigma_frequency = 0, sigma_damping = 0; // Hz, fraction of critical
  Eigen::VectorXcd shape;
  Eigen::VectorXd sigma_shape; // of real and imaginary part each
};

// The mode next to `pole` of the model with 2 * order states; `scale`: by which the shape is
// multiplied, per channel, before it is brought to 1; empty: no shape.
StochasticMode stochastic_mode(const Subspace& subspace, const Correlations& correlations,
                               const Pole& pole, int order, double rate,
                               const Eigen::VectorXd& scale);

} // namespace plica
