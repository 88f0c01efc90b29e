#include "solve/oscillator.hpp"

#include <cmath>
#include <stdexcept>

namespace plica {

Oscillator::Oscillator(double omega, double zeta, double dt)
    : c_{.stiff = omega * omega,
         .damp = 2 * zeta * omega,
         .qq = 0,
         .qv = 0,
         .vq = 0,
         .vv = 0,
         .q0 = 0,
         .q1 = 0,
         .v0 = 0,
         .v1 = 0} {
  if (!(dt > 0) || !(omega > 0) || !(zeta >= 0) || !(zeta < 1))
    throw std::invalid_argument("oscillator: omega and the step must be above zero and zeta in "
                                "[0, 1)");
  const double beta = zeta * omega, ringing = omega * std::sqrt(1 - zeta * zeta);
  const double decay = std::exp(-beta * dt);
  const double c = decay * std::cos(ringing * dt), s = decay * std::sin(ringing * dt) / ringing;
  // Free motion from q = a, q' = b: q = a (c + beta s) + b s.
  c_.qq = c + beta * s;
  c_.qv = s;
  c_.vq = -c_.stiff * s;
  c_.vv = c - beta * s;
  // The line round which it rings, for f = f_0 + slope t: (f_0 + slope t) / omega^2 - lag slope.
  const double flexibility = 1 / c_.stiff, lag = c_.damp * flexibility * flexibility;
  const double load_q = flexibility * (1 - c_.qq), load_v = -flexibility * c_.vq;
  const double slope_q = flexibility * (dt - c_.qv) - lag * (1 - c_.qq);
  const double slope_v = flexibility * (1 - c_.vv) + lag * c_.vq;
  c_.q1 = slope_q / dt;
  c_.q0 = load_q - c_.q1;
  c_.v1 = slope_v / dt;
  c_.v0 = load_v - c_.v1;
}

} // namespace plica
