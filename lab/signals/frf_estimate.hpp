// Frequency responses from measured spectra, y = H x.
//
//   H1 = S_xy / S_xx                 unbiased when only the response is noisy; any number of inputs
//   H2 = S_yy / S_yx                 unbiased when only the input is noisy; one input
//   Hv                               total least squares: the largest eigenvector u of
//                                    [S_xx S_xy; S_yx S_yy] gives H = u_y / u_x
//   gamma^2 = S_yx S_xx^-1 S_xy / S_yy     (multiple) coherence; one input: H1 / H2
//
// H1 <= Hv <= H2 in magnitude. Hv assumes noise of equal density in both channels in the units they
// come in. Bendat and Piersol, Random Data, ch. 6, 7 and 9.
#pragma once

#include "lab/signals/spectrum.hpp"

namespace plica {

enum class FrfEstimator { H1, H2, Hv };

struct FrfEstimate {
  Eigen::VectorXd hertz;
  std::vector<Eigen::MatrixXcd> H; // per input: frequencies x responses
  Eigen::MatrixXd coherence;       // frequencies x responses
  double averages = 0;
};

// Throws std::invalid_argument for H2 or Hv with several inputs. Lines whose input density is
// singular (two inputs that move alike) give zeros and coherence zero.
FrfEstimate estimate_frf(const Spectra& spectra, FrfEstimator estimator);

// Standard deviation of |H1| relative to it, and of its phase in rad:
// sqrt(1 - gamma^2) / (gamma sqrt(2 n)).
double frf_random_error(double coherence, double averages);

} // namespace plica
