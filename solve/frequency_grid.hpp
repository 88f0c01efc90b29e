// Frequencies at which a response is computed, and what is read off the curve.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

// `points` equal steps over [low, high] Hz, every eigenfrequency in the band, and around each a
// cluster f +- zeta f sinh(0.08 i): twelve points within the half-power bandwidth, then each 8 %
// farther off than the last until the even steps are as fine. Increasing, no repeats.
Eigen::VectorXd frequency_grid(double low, double high, int points, const Eigen::VectorXd& hertz,
                               const Eigen::VectorXd& zeta);

// A local maximum of a curve. Frequency and height from the parabola through three points.
struct Peak {
  double frequency = 0, height = 0;
  double damping = 0; // half power: (f2 - f1) / (2 f); NaN where a neighbour covers a flank or one
                      // is three times as wide as the other: no resonance of its own
  double f1 = 0, f2 = 0; // where the curve has fallen to the root of half, Hz; NaN if it does not
};

// Peaks higher than `floor` times the highest.
std::vector<Peak> find_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXd& magnitude,
                             double floor = 0.01);

} // namespace plica
