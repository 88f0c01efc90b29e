// The strong resonances of one measured response: where, how high, how wide.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

struct FittedPeak {
  double frequency = 0, amplitude = 0, damping = 0; // Hz, of |H|, fraction of critical
  double noise = 0;                                 // relative, of a line: what the fit leaves
  double natural = 0;                               // Hz, of the mode
  int first = 0, lines = 0;                         // those that were fitted
};

// Peaks that reach `share` of the highest, by frequency. Each is fitted over a few of its
// bandwidths by one mode and a straight line,
//   H(w) (lambda - w^2 + i w c) = a + b w^2,
// linear least squares, weighted by the last denominator (Sanathanan and Koerner, IEEE Trans.
// Autom. Control 8 (1963) 56). Of a response that depends on its amplitude this is the resonance
// that has its height and width.
std::vector<FittedPeak> response_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXcd& H,
                                       double share);

// The damping that such a fit gives over its lines about a peak, which is no mode's own where
// another one shows beside it: two modes of 1 % that lie within their widths look like one of 2 %.
double apparent_damping(const Eigen::VectorXd& hertz, const Eigen::VectorXcd& H, double frequency,
                        double guess);
// Lines that lie so many times the damping off the peak are fitted.
inline constexpr double fitted_reach = 5;

// Height of another response at the same resonance: the mode of the peak with two numbers of its
// own, a and b, over the lines of the peak. Lines that lie a bandwidth apart miss the top by a
// quarter. Where the mode is not as high as the highest line there, that line.
double height_at(const FittedPeak& peak, const Eigen::VectorXd& hertz, const Eigen::VectorXcd& H);

} // namespace plica
