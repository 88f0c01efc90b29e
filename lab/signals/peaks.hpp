// Local maxima of a sampled curve.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

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

// The higher of the lowest values on both sides of the maximum at `top`, each sought until the
// curve is higher than it or ends.
double higher_valley(const Eigen::VectorXd& magnitude, Eigen::Index top);

} // namespace plica
