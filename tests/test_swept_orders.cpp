// Orders of an engine whose speed runs: against Runge-Kutta, the steady response, a closed form.
#include "solve/swept_sine.hpp"

#include "tests/tube_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;
constexpr Complex turn_(0, 1);

constexpr double w0 = 2 * pi * 20, zeta = 0.02, from = 2 * pi * 10, to = 2 * pi * 40;

// From 10 to 40 Hz in `seconds`, the amplitude growing from 1 to 2.
struct Chirp {
  double seconds = 1;
  double rate(double t) const { return from + (to - from) * t / seconds; }
  double phase(double t) const { return from * t + (to - from) * t * t / (2 * seconds); }
  double amplitude(double t) const { return 1 + t / seconds; }
};

SweptLoad sampled(const Chirp& c, double dt) {
  const auto samples = Index(std::lround(c.seconds / dt)) + 1;
  SweptLoad load{dt, VectorXd(samples), VectorXd(samples), MatrixXd(samples, 1)};
  for (Index i = 0; i < samples; ++i) {
    load.phase[i] = c.phase(double(i) * dt);
    load.rate[i] = c.rate(double(i) * dt);
    load.amplitude(i, 0) = c.amplitude(double(i) * dt);
  }
  return load;
}

ModalModel oscillator() {
  return {.lambda = VectorXd::Constant(1, w0 * w0),
          .zeta = VectorXd::Constant(1, zeta),
          .eta = VectorXd::Zero(1),
          .output = MatrixXd::Ones(1, 1),
          .input = MatrixXd::Ones(1, 1)};
}

// z'' + 2 zeta w0 z' + w0^2 z = a(t) e^{i phi(t)}, from the steady motion at the first frequency,
// by the classical method of fourth order in steps of 5 us.
std::vector<Complex> by_runge_kutta(const Chirp& c, double dt) {
  constexpr int parts = 40;
  const double h = dt / parts;
  const auto force = [&](double t) { return std::polar(c.amplitude(t), c.phase(t)); };
  const auto slope = [&](double t, Complex z, Complex v) {
    return force(t) - 2 * zeta * w0 * v - w0 * w0 * z;
  };
  Complex z = force(0) / (w0 * w0 - from * from + 2. * turn_ * zeta * w0 * from);
  Complex v = turn_ * from * z;
  std::vector<Complex> acceleration;
  const auto samples = int(std::lround(c.seconds / dt));
  for (int i = 0; i <= samples; ++i) {
    const double start = i * dt;
    acceleration.push_back(slope(start, z, v) * std::polar(1., -c.phase(start)));
    for (int k = 0; k < parts; ++k) {
      const double t = start + k * h;
      const Complex a1 = slope(t, z, v), v2 = v + h / 2 * a1;
      const Complex a2 = slope(t + h / 2, z + h / 2 * v, v2), v3 = v + h / 2 * a2;
      const Complex a3 = slope(t + h / 2, z + h / 2 * v2, v3), v4 = v + h * a3;
      const Complex a4 = slope(t + h, z + h * v3, v4);
      z += h / 6 * (v + 2. * v2 + 2. * v3 + v4);
      v += h / 6 * (a1 + 2. * a2 + 2. * a3 + a4);
    }
  }
  return acceleration;
}

TEST(SweptSine, is_that_of_runge_kutta_while_it_runs_through_a_resonance) {
  for (const double seconds : {0.5, 4.}) {
    const Chirp c{seconds};
    constexpr double dt = 2e-4; // 125 samples of the fastest period
    const MatrixXcd z = swept_acceleration(oscillator(), VectorXcd::Ones(1), sampled(c, dt), 5);
    const std::vector<Complex> exact = by_runge_kutta(c, dt);
    double largest = 0;
    for (const Complex& a : exact) largest = std::max(largest, std::abs(a));
    ASSERT_EQ(z.rows(), Index(exact.size() - 1) / 5 + 1);
    for (Index i = 0; i < z.rows(); ++i)
      EXPECT_LT(std::abs(z(i, 0) - exact[std::size_t(5 * i)]), 1e-3 * largest)
          << seconds << " " << i;
  }
}

// 24 samples of a period, as runs take them: 0.5 % of the largest.
TEST(SweptSine, keeps_its_accuracy_at_the_sampling_of_a_run) {
  const Chirp c{2};
  const double dt = 1. / (24 * 40);
  const MatrixXcd z = swept_acceleration(oscillator(), VectorXcd::Ones(1), sampled(c, dt), 1);
  const std::vector<Complex> exact = by_runge_kutta(c, dt);
  double largest = 0;
  for (const Complex& a : exact) largest = std::max(largest, std::abs(a));
  ASSERT_EQ(z.rows(), 24 * 40 * 2 + 1);
  for (Index i = 0; i < z.rows(); ++i)
    EXPECT_LT(std::abs(z(i, 0) - exact[std::size_t(i)]), 5e-3 * largest) << i;
}

// A column above half of the sampling rate answers like a spring.
TEST(SweptSine, of_a_stiff_mode_is_static) {
  ModalModel stiff = oscillator();
  stiff.lambda[0] = std::pow(2 * pi * 5e4, 2);
  const Chirp c{2};
  const MatrixXcd z =
      swept_acceleration(stiff, VectorXcd::Constant(1, turn_), sampled(c, 1e-4), 100);
  ASSERT_EQ(z.rows(), 201);
  for (Index i = 1; i + 1 < z.rows(); ++i) {
    // The second derivative of a e^{i phi}, a and the frequency growing.
    const double t = double(i) * 1e-2, w = c.rate(t), a = c.amplitude(t);
    const Complex grown = turn_ * ((to - from) / c.seconds * a + 2 * w / c.seconds);
    const Complex wanted = turn_ * (grown - w * w * a) / stiff.lambda[0];
    EXPECT_LT(std::abs(z(i, 0) - wanted), 1e-3 * std::abs(wanted)) << i;
  }
}

Case running_up(double seconds) {
  Case data = mass_between(4e4, 1e4, 2, 0.03);
  data.analyses.response = Response{.bases = {1}, .band = {1, 80}, .points = 60};
  RunUp up;
  up.name = "up";
  up.table = {{0, 5}, {seconds, 25}};
  EngineOrder second;
  second.order = 2;
  second.of = "y";
  second.acceleration = 1;
  up.orders = {second};
  data.analyses.run_ups = {up};
  return data;
}

const OrderCrossing& resonance(const RunUpResult& r) {
  return *std::max_element(
      r.crossings.begin(), r.crossings.end(),
      [](const OrderCrossing& a, const OrderCrossing& b) { return a.amplitude < b.amplitude; });
}

TEST(RunUpsInTime, slow_ones_are_the_steady_response_and_fast_ones_stay_below) {
  const Results slow = run_silently(running_up(600)), fast = run_silently(running_up(1));
  const RunUpResult& r = slow.run_ups.at(0);
  ASSERT_TRUE(r.sweeps);
  EXPECT_LT(*resonance(r).haste, 0.1);
  EXPECT_NEAR(*resonance(r).reached, resonance(r).amplitude, 0.01 * resonance(r).amplitude);
  const OrderSweeps& s = *r.sweeps;
  for (Index i = 0; i < s.time.size(); i += 50) { // beside the steady response at that speed
    Index at = 0;
    (r.speed.array() - s.speed[i]).abs().minCoeff(&at);
    if (std::abs(r.speed[at] - s.speed[i]) > 1e-3) continue;
    const Complex steady = r.orders[0].acceleration(at, 1);
    EXPECT_LT(std::abs(s.orders[0].acceleration(i, 1) - steady), 0.03 * resonance(r).amplitude);
  }
  EXPECT_NEAR(s.overall(0, 1), std::abs(s.orders[0].acceleration(0, 1)) / std::sqrt(2), 1e-12);
  const OrderCrossing& hasty = resonance(fast.run_ups.at(0));
  EXPECT_GT(*hasty.haste, 1);
  EXPECT_LT(*hasty.reached, 0.9 * hasty.amplitude);
}

// A Maxwell branch that makes its mount stiffer by as much again over the band: mode by mode the
// peak would stand elsewhere.
TEST(RunUpsInTime, take_springs_over_frequency_as_the_steady_response_does) {
  Case data = running_up(600);
  data.mount[0].damping.emplace();
  data.mount[0].damping->maxwell = {{1., 0.02}};
  data.analyses.damping.modal = 0.005;
  const Results slow = run_silently(data);
  const RunUpResult& r = slow.run_ups.at(0);
  ASSERT_TRUE(r.sweeps);
  for (const std::string& w : slow.warnings) EXPECT_EQ(w.find("is long"), std::string::npos) << w;
  const OrderSweeps& s = *r.sweeps;
  const double largest = r.orders[0].acceleration.col(1).cwiseAbs().maxCoeff();
  int compared = 0;
  for (Index i = 0; i < s.time.size(); ++i) {
    Index at = 0;
    (r.speed.array() - s.speed[i]).abs().minCoeff(&at);
    if (std::abs(r.speed[at] - s.speed[i]) > 1e-3) continue;
    ++compared;
    EXPECT_LT(std::abs(s.orders[0].acceleration(i, 1) - r.orders[0].acceleration(at, 1)),
              0.02 * largest)
        << s.speed[i] << " of " << largest;
  }
  EXPECT_GT(compared, 10);
}

TEST(RunUpsInTime, are_left_out_where_only_a_range_of_speeds_is_given) {
  Case data = running_up(10);
  data.analyses.run_ups[0].table.clear();
  data.analyses.run_ups[0].speed = {5, 25};
  const Results r = run_silently(data);
  EXPECT_FALSE(r.run_ups.at(0).sweeps);
  EXPECT_FALSE(resonance(r.run_ups[0]).reached);
}

} // namespace
} // namespace plica::test
