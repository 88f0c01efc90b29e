// Steady response of a structure with joints by integration in time: the referee of the harmonic
// balance. Average acceleration (Newmark, beta = 1/4) over the modes with Newton's method over the
// joints; sliders carry their own state. Loss factors have no meaning in time, nor has a table over
// frequency: they act as viscous damping with the same energy at the excitation frequency, a damped
// spring as the spring and dashpot that it is there.
#pragma once

#include "solve/harmonic_balance.hpp"

namespace plica {

struct TimeSettings {
  int steps = 1000;       // of a period
  int most_periods = 400; // until it repeats
  double settled = 1e-5;  // change of the first harmonics over ten periods, relative
};

struct SteadyMotion {
  bool settled = false;
  int periods = 0;
  double change = 0;
  Eigen::MatrixXcd joints; // harmonics 0, 1, 2 .. x joints
  Eigen::MatrixXcd modes;  // harmonics x modes
};

// From the motion of `start` (its modes empty = from rest), harmonics up to `harmonics`.
SteadyMotion integrate(const JointedStructure& structure, double omega, double level, int harmonics,
                       const TimeSettings& settings, const std::vector<int>& orders = {},
                       const PeriodicPoint& start = {});

} // namespace plica
