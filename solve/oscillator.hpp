// An oscillator under a sampled load that runs straight from sample to sample, without error of
// integration (Nigam & Jennings, Bull. Seismol. Soc. Am. 59 (1969) 909-922).
//
//   q'' + 2 zeta omega q' + omega^2 q = f(t),   f = f_0 + (f_1 - f_0) t / dt  within a step
//
// Within a step q is a straight line and a decaying oscillation round it, so that q and q' after it
// are linear in q, q', f_0 and f_1. Where omega dt is small, rounding is about 1e-16 / (omega dt)^3
// of a step.
#pragma once

namespace plica {

class Oscillator {
public:
  // q, v after a step of q, v, f0, f1; q'' = f - damp v - stiff q.
  struct Coefficients {
    double stiff, damp; // omega^2, 2 zeta omega
    double qq, qv, vq, vv, q0, q1, v0, v1;
  };

  // omega > 0 in rad/s, 0 <= zeta < 1, dt > 0 in s; at rest. Throws std::invalid_argument
  // otherwise.
  Oscillator(double omega, double zeta, double dt);

  // In place of rest.
  void begin(double q, double velocity) {
    q_ = q;
    v_ = velocity;
  }
  // f0 and f1: the load at the ends of the step.
  void step(double f0, double f1) {
    const double q = q_, v = v_;
    q_ = c_.qq * q + c_.qv * v + c_.q0 * f0 + c_.q1 * f1;
    v_ = c_.vq * q + c_.vv * v + c_.v0 * f0 + c_.v1 * f1;
  }

  double q() const { return q_; }
  double velocity() const { return v_; }
  double acceleration(double f) const {
    return f - c_.damp * v_ - c_.stiff * q_;
  } // under the load f
  const Coefficients& coefficients() const { return c_; }

private:
  Coefficients c_;
  double q_ = 0, v_ = 0;
};

} // namespace plica
