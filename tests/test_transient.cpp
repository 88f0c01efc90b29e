// Oscillators in time, shock response spectra and transients of modal models, against closed forms.
#include "solve/oscillator.hpp"
#include "solve/shock_spectrum.hpp"
#include "solve/transient_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double pi = std::numbers::pi;

// q'' + 2 zeta omega q' + omega^2 q = t from rest (Duhamel's integral of a ramp).
double ramp_response(double omega, double zeta, double t) {
  const double d = omega * std::sqrt(1 - zeta * zeta), w2 = omega * omega;
  const double lag = 2 * zeta / omega;
  const double C = lag / w2, D = (zeta * omega * C - 1 / w2) / d;
  return (t - lag) / w2 + std::exp(-zeta * omega * t) * (C * std::cos(d * t) + D * std::sin(d * t));
}

TEST(Oscillator, steps_of_any_length_are_on_the_answer_to_a_ramp) {
  for (const double omega : {0.3, 7., 250.})
    for (const double zeta : {0., 0.02, 0.7})
      for (const double dt : {1e-3, 0.01, 0.4}) {
        Oscillator o(omega, zeta, dt);
        for (int i = 0; i < 200; ++i) o.step(i * dt, (i + 1) * dt);
        const double exact = ramp_response(omega, zeta, 200 * dt);
        EXPECT_NEAR(o.q(), exact, 1e-9 * std::abs(exact) + 1e-12)
            << omega << " " << zeta << " " << dt;
      }
}

TEST(Oscillator, a_step_or_a_damping_that_cannot_be_is_refused) {
  EXPECT_THROW(Oscillator(1, 0.1, 0), std::invalid_argument);
  EXPECT_THROW(Oscillator(0, 0.1, 1), std::invalid_argument);
  EXPECT_THROW(Oscillator(1, 1, 1), std::invalid_argument);
  EXPECT_THROW(Oscillator(1, std::nan(""), 1), std::invalid_argument);
}

// Half sine of amplitude 1 and duration T on an undamped oscillator of period P (Harris' Shock and
// Vibration Handbook, chapter 8): while it lasts sin(pi t/T) - (P/2T) sin(2 pi t/P) over
// 1 - (P/2T)^2, afterwards an amplitude of (P/T) cos(pi T/P) over (P/2T)^2 - 1.
double half_sine_maximax(double hertz, double T) {
  const double r = 1 / (2 * hertz * T); // P / 2T
  const double residual = std::abs(2 * r * std::cos(pi / (2 * r)) / (1 - r * r));
  double primary = 0;
  for (int i = 0; i <= 200000; ++i) {
    const double t = T * i / 200000;
    primary = std::max(primary, std::abs(std::sin(pi * t / T) - r * std::sin(2 * pi * hertz * t)) /
                                    std::abs(1 - r * r));
  }
  return std::max(primary, residual);
}

TEST(ShockSpectrum, half_sine_on_undamped_oscillators) {
  constexpr double T = 0.011;
  constexpr int steps = 2000;
  VectorXd shock(steps + 1);
  for (Index i = 0; i <= steps; ++i) shock[i] = std::sin(pi * double(i) / steps);
  VectorXd hertz(7);
  hertz << 5, 20, 46, 74, 120, 400, 1500;
  const ShockSpectrum s = shock_spectrum(shock, T / steps, hertz, 0);
  const VectorXd maximax = s.maximax();
  for (Index i = 0; i < hertz.size(); ++i) {
    const double exact = half_sine_maximax(hertz[i], T);
    // 1 - cos(pi / 24) of the amplitude of the ringing may fall between samples.
    EXPECT_LE(maximax[i], exact * (1 + 1e-5)) << hertz[i];
    EXPECT_GE(maximax[i], exact * (1 - 0.0086)) << hertz[i];
  }
  // The handbook's highest value, 1.77 at T/P = 0.8.
  VectorXd top(1);
  top << 0.8 / T;
  EXPECT_NEAR(shock_spectrum(shock, T / steps, top, 0).maximax()[0], 1.77, 0.01);
}

TEST(ShockSpectrum, what_is_no_shock_is_refused) {
  const VectorXd one = VectorXd::Ones(1), two = VectorXd::Ones(2);
  EXPECT_THROW(shock_spectrum(one, 0.1, one, 0.05), std::invalid_argument);
  EXPECT_THROW(shock_spectrum(two, 0.1, -one, 0.05), std::invalid_argument);
  EXPECT_THROW(shock_spectrum(two, 0, one, 0.05), std::invalid_argument);
  EXPECT_THROW(shock_spectrum(two, 0.1, one, 1), std::invalid_argument);
}

// Two modes, two channels, one load.
ModalModel two_modes() {
  ModalModel m;
  m.lambda = Eigen::Vector2d(std::pow(2 * pi * 20, 2), std::pow(2 * pi * 55, 2));
  m.zeta = Eigen::Vector2d(0.03, 0.02);
  m.eta = Eigen::Vector2d(0, 0.02);
  m.output = (MatrixXd(2, 2) << 1, 0.5, 0.7, -0.4).finished();
  m.input = Eigen::Vector2d(0.8, 0.3);
  return m;
}

TEST(Transient, a_long_sine_ends_in_the_steady_response) {
  ModalModel m = two_modes();
  m.eta.setZero();
  const double hertz = 23, dt = 1. / (hertz * 400);
  const Index samples = 400 * 60;
  VectorXd load(samples);
  for (Index i = 0; i < samples; ++i) load[i] = std::sin(2 * pi * hertz * double(i) * dt);
  const MatrixXd a = transient_acceleration(m, load, dt);
  VectorXd omega(1);
  omega << 2 * pi * hertz;
  const Eigen::MatrixXcd H = -omega[0] * omega[0] * frequency_response(m, 0, omega);
  for (Index c = 0; c < 2; ++c) {
    const double measured = a.col(c).tail(400).cwiseAbs().maxCoeff();
    EXPECT_NEAR(measured, std::abs(H(0, c)), 2e-4 * std::abs(H(0, c)));
  }
}

TEST(Transient, blocks_leave_no_seam) {
  const ModalModel m = two_modes();
  const double dt = 1e-4;
  VectorXd load = VectorXd::Zero(20000);
  load.head(100).setOnes();
  const MatrixXd a = transient_acceleration(m, load, dt);
  // Free decay beyond the load: by the logarithmic decrement of each mode alone.
  for (Index j = 0; j < 2; ++j) {
    ModalModel one = m;
    one.lambda = m.lambda.segment(j, 1);
    one.zeta = m.zeta.segment(j, 1);
    one.eta = m.eta.segment(j, 1);
    one.output = MatrixXd::Ones(1, 1);
    one.input = MatrixXd::Ones(1, 1);
    const VectorXd q = transient_acceleration(one, load, dt);
    const double omega = std::sqrt(one.lambda[0]), zeta = one.zeta[0] + one.eta[0] / 2;
    const double d = omega * std::sqrt(1 - zeta * zeta);
    // a(t + s) of a free decay from two of its values, by its recurrence over a step.
    const double c = 2 * std::exp(-zeta * omega * dt) * std::cos(d * dt);
    const double e = std::exp(-2 * zeta * omega * dt);
    for (Index i = 4080; i < 4120; ++i) // round the end of the first block
      EXPECT_NEAR(q[i + 1], c * q[i] - e * q[i - 1], 1e-9 * q.cwiseAbs().maxCoeff());
  }
  EXPECT_TRUE(a.allFinite());
}

TEST(Transient, columns_above_half_of_the_sampling_rate_follow_statically) {
  ModalModel m = two_modes();
  m.lambda[1] = std::pow(2 * pi * 1e5, 2);
  const double dt = 1e-3, hertz = 3;
  VectorXd load(2000);
  for (Index i = 0; i < load.size(); ++i) load[i] = std::sin(2 * pi * hertz * double(i) * dt);
  const MatrixXd all = transient_acceleration(m, load, dt);
  m.input(0) = 0;
  const MatrixXd fast = transient_acceleration(m, load, dt);
  const double exact = 0.5 * 0.3 * std::pow(hertz / 1e5, 2); // (omega / omega_2)^2 of the load
  EXPECT_NEAR(fast.col(0).tail(1000).cwiseAbs().maxCoeff(), exact, 1e-3 * exact);
  EXPECT_GT(all.col(0).cwiseAbs().maxCoeff(), fast.col(0).cwiseAbs().maxCoeff());
}

} // namespace
} // namespace plica
