// The strong resonances of one measured response: where, how high, how wide.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

struct FittedPeak {
  double frequency = 0, amplitude = 0, damping = 0; // Hz, of |H|, fraction of critical
  double noise = 0;                                 // relative, of a line: what the fit leaves
  int lines = 0;                                    // that were fitted
};

// Peaks that reach `share` of the highest, by frequency. Each is fitted over a few of its
// bandwidths by one mode and a straight line,
//   H(w) (lambda - w^2 + i w c) = a + b w^2,
// linear least squares, weighted by the last denominator (Sanathanan and Koerner, IEEE Trans.
// Autom. Control 8 (1963) 56). Of a response that depends on its amplitude this is the resonance
// that has its height and width.
std::vector<FittedPeak> response_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXcd& H,
                                       double share);

} // namespace plica
