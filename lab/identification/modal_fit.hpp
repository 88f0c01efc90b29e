// Modal parameters of a band by least squares on the responses themselves.
//
//   H_oi(w) = (i w)^d [ sum_r R_roi / (i w - l_r) + conj(R_roi) / (i w - conj l_r)
//                       + L_oi / (i w)^2 + U_oi ],   d = derivatives(quantity)
//
// L and U stand for what lies below and above the band. Given the poles all else is linear and is
// eliminated (variable projection, Golub and Pereyra 1973; Kaufman's Jacobian); the poles follow by
// Levenberg-Marquardt. With responses weighted by their own noise this is the maximum-likelihood
// estimate; its covariance is that of the linearised problem for the residual that is there, not
// for white noise.
#pragma once

#include "lab/identification/lscf.hpp"
#include "lab/identification/pole_search.hpp"

namespace plica {

struct FittedMode {
  std::complex<double> lambda; // 1/s
  double sigma_real = 0, sigma_imaginary = 0;
  Eigen::MatrixXcd residue;      // responses x references, of the displacement per reference
  Eigen::MatrixXd sigma_residue; // of real and imaginary part each, poles held
  double frequency() const;
  double damping() const;
  double sigma_frequency() const; // Hz
  double sigma_damping() const;
};

struct ModalFit {
  std::vector<FittedMode> modes;   // by frequency
  Eigen::MatrixXd lower, upper;    // L and U, responses x references
  std::vector<Eigen::MatrixXcd> H; // synthesised on the lines of the set
  Eigen::MatrixXd noise;           // RMS of the residual, responses x references
  int iterations = 0;
  bool converged = false;
};

// What a search has found, without `H`. Its data: responses x references, as columns; behind the
// rows of the poles in C that of `lower`, then that of `upper`, zero where there is none.
ModalFit fit_of(const PoleSearch& found, Eigen::Index responses, Eigen::Index references);

// Throws std::invalid_argument when the lines are too few for the poles.
ModalFit fit_modes(const FrfSet& set, const std::vector<std::complex<double>>& poles);

// The model at other frequencies.
std::vector<Eigen::MatrixXcd> synthesise(const ModalFit& fit, FrfQuantity quantity,
                                         const Eigen::VectorXd& hertz);

} // namespace plica
