// Resonances of one curve: peaks and half-power damping.
//
// Of a receptance with viscous damping the half-power formula errs by a known amount,
//
//   (f2 - f1) / (2 f_peak)     +0.02 % at 1 %, +0.50 % at 5 %, +2.1 % at 10 %, +9.1 % at 20 %
//
// of the damping, and by more where a neighbour is near or fewer than five lines lie within the
// bandwidth.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

struct PickedPeak {
  double frequency = 0, amplitude = 0;
  double damping = 0; // (f2 - f1) / (2 f_peak); NaN where a flank is covered
  int lines = 0;      // measured lines between f1 and f2; below five the damping is a guess
};

// Peaks that stand out of the valleys on both sides by `prominence` (ratio above 1) and are higher
// than `floor` times the highest, by frequency.
std::vector<PickedPeak> pick_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXd& magnitude,
                                   double prominence = 1.4, double floor = 0.01);

} // namespace plica
