// Sines of machines among the responses of a structure.
//
// The kurtosis E x^4 / (E x^2)^2 of a signal, passed through a narrow band, is 3 for the response
// of a mode to noise and 1.5 for a sine. Brincker, Andersen and Moller, IMAC 18 (2000).
#pragma once

#include <Eigen/Core>

namespace plica {

struct BandKurtosis {
  double value = 3;
  double lines = 0; // that hold the power of the band: (sum P)^2 / sum P^2
  double sigma = 0; // of Gaussian noise: sqrt(24 / n), n = 2 lines
};

// Of a sine: below 2.25, and that by three standard deviations below 3, as of one whose frequency
// wanders, or in fewer than four lines. A mode that rings as long as the record looks like the
// latter.
bool is_sine(const BandKurtosis& kurtosis);

BandKurtosis band_kurtosis(const Eigen::VectorXd& x, double rate, double low, double high);

} // namespace plica
