#include "solve/oscillator.hpp"

#include <cmath>
#include <stdexcept>

namespace plica {

Oscillator::Oscillator(double omega, double zeta, double dt)
    : stiff_(omega * omega), damp_(2 * zeta * omega) {
  if (!(dt > 0) || !(omega > 0) || !(zeta >= 0) || !(zeta < 1))
    throw std::invalid_argument("oscillator: omega and the step must be above zero and zeta in "
                                "[0, 1)");
  const double beta = zeta * omega, ringing = omega * std::sqrt(1 - zeta * zeta);
  const double decay = std::exp(-beta * dt);
  const double c = decay * std::cos(ringing * dt), s = decay * std::sin(ringing * dt) / ringing;
  // Free motion from q = a, q' = b: q = a (c + beta s) + b s.
  qq_ = c + beta * s;
  qv_ = s;
  vq_ = -stiff_ * s;
  vv_ = c - beta * s;
  // The line round which it rings, for f = f_0 + slope t: (f_0 + slope t) / omega^2 - lag slope.
  const double flexibility = 1 / stiff_, lag = damp_ * flexibility * flexibility;
  const double load_q = flexibility * (1 - qq_), load_v = -flexibility * vq_;
  const double slope_q = flexibility * (dt - qv_) - lag * (1 - qq_);
  const double slope_v = flexibility * (1 - vv_) + lag * vq_;
  q1_ = slope_q / dt;
  q0_ = load_q - q1_;
  v1_ = slope_v / dt;
  v0_ = load_v - v1_;
}

} // namespace plica
