// Harmonic balance, continuation and backbones against closed forms and published examples.
#include "solve/backbone.hpp"
#include "solve/joint_time_integration.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

JointedStructure duffing() {
  return {.lambda = VectorXd::Ones(1),
          .zeta = VectorXd::Constant(1, 0.025),
          .eta = VectorXd::Zero(1),
          .joints = MatrixXd::Ones(1, 1),
          .input = VectorXd::Ones(1),
          .laws = {{.cubic = 0.1}}};
}

// q'' + 0.05 q' + q + 0.1 q^3 = 0.18 cos(w t) (Krack & Gross, example 1). One harmonic: the closed
// form; seven: their program,
// whose last point before the jump is 2.8287 at 1.2675; the branch itself goes on to 2.8302.
TEST(HarmonicBalance, of_duffing_meets_the_closed_form_and_the_published_branch) {
  HarmonicSettings settings{.harmonics = 1, .samples = 64, .from = 0.8, .to = 1.4};
  settings.largest_step = 3e-4;
  const Branch one = follow_frequency(duffing(), 0.18, settings);
  ASSERT_TRUE(one.complete) << one.reason;
  double peak = 0, at = 0;
  for (const PeriodicPoint& p : one.points) {
    const double a = std::abs(p.joints(0, 0)), z = 0.05, g = 0.1, P = 0.18;
    const double root = std::sqrt(
        std::max(0., P * P / (a * a) + std::pow(z, 4) / 4 - z * z - 3 * z * z * g * a * a / 4));
    const double middle = 1 - z * z / 2 + 3 * g * a * a / 4, w2 = p.omega * p.omega;
    EXPECT_LT(std::min(std::abs(w2 - middle - root), std::abs(w2 - middle + root)), 1e-6);
    if (a > peak) {
      peak = a;
      at = p.omega;
    }
  }
  EXPECT_NEAR(peak, 2.84162, 2e-4);
  EXPECT_NEAR(at, 1.26663, 1e-3);
  settings.harmonics = 7;
  const Branch seven = follow_frequency(duffing(), 0.18, settings);
  ASSERT_TRUE(seven.complete) << seven.reason;
  bool turned = false;
  for (std::size_t i = 1; i + 1 < seven.points.size(); ++i) {
    const bool rises = seven.points[i].omega > seven.points[i - 1].omega;
    turned = turned || !rises;
    if (rises != (seven.points[i + 1].omega > seven.points[i].omega)) continue; // at a fold
    EXPECT_EQ(seven.points[i].stable, rises)
        << seven.points[i].omega << ": between the folds, and only there, it is unstable";
  }
  EXPECT_TRUE(turned);
  const Sweep up = sweep_over(seven, true), down = sweep_over(seven, false);
  ASSERT_EQ(up.jumps.size(), 1);
  ASSERT_EQ(down.jumps.size(), 1);
  EXPECT_LT(down.jumps[0], up.jumps[0]);
  for (std::size_t i : up.points) EXPECT_TRUE(seven.points[i].stable);
  struct Row {
    double omega, a1, a3;
  };
  for (const Row& row :
       {Row{0.8, .474872, 5.663e-4}, Row{1.0, 1.305345, 7.179e-3}, Row{1.2, 2.509198, 3.587e-2}}) {
    settings.from = 0.8;
    settings.to = row.omega;
    PeriodicPoint p;
    if (row.omega == 0.8) {
      p = periodic_response(duffing(), 0.8, 0.18, settings).point;
    } else {
      const Branch upper = follow_frequency(duffing(), 0.18, settings);
      p = periodic_response(duffing(), row.omega, 0.18, settings, upper.points.back().joints).point;
    }
    EXPECT_NEAR(std::abs(p.joints(0, 0)) / row.a1, 1, row.omega > 1.25 ? 2e-5 : 1e-5) << row.omega;
    EXPECT_NEAR(std::abs(p.joints(1, 0)) / row.a3, 1, 1e-3) << row.omega;
  }
}

// Three modes, two joints with sliders, a cubic spring and a gap.
JointedStructure frame() {
  JointedStructure s;
  s.lambda = VectorXd{{1e4, 9e4, 4e5}};
  s.zeta = VectorXd{{0.01, 0.01, 0.02}};
  s.eta = VectorXd{{0.0, 0.01, 0.0}};
  s.joints = MatrixXd{{1, 0.3}, {-0.8, 1}, {0.5, -0.9}};
  s.input = VectorXd{{1, 0.5, -0.2}};
  s.laws = {
      {.stiffness = 2e3, .cubic = 1e9, .sliders = {{8e3, 2}, {5e3, 8}}},
      {.curve = {{-2e-3, -30}, {-1e-3, -1}, {0, 0}, {1e-3, 1}, {2e-3, 30}}, .sliders = {{4e3, 1}}}};
  return s;
}

void expect_jacobian_of_differences(const JointedStructure& s, int unknowns,
                                    const HarmonicSettings& settings) {
  std::mt19937 random(5);
  VectorXd x(unknowns);
  for (double& v : x) v = 2e-3 * (double(random()) / double(std::mt19937::max()) - 0.5);
  const double omega = 130, level = 20;
  const Residual r = harmonic_residual(s, omega, level, settings, x);
  const double h = 1e-9;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    VectorXd up = x, down = x;
    up[i] += h;
    down[i] -= h;
    const VectorXd d = (harmonic_residual(s, omega, level, settings, up).value -
                        harmonic_residual(s, omega, level, settings, down).value) /
                       (2 * h);
    EXPECT_LT((d - r.by_motion.col(i)).norm() / r.by_motion.norm(), 1e-6) << i;
  }
  const VectorXd d = (harmonic_residual(s, omega + 1e-4, level, settings, x).value -
                      harmonic_residual(s, omega - 1e-4, level, settings, x).value) /
                     2e-4;
  EXPECT_LT((d - r.by_parameter).norm() / r.by_parameter.norm(), 1e-6);
}

TEST(HarmonicBalance, has_the_jacobian_of_finite_differences) {
  const HarmonicSettings settings{.harmonics = 5, .samples = 512};
  expect_jacobian_of_differences(frame(), 12, settings); // odd laws: harmonics 1, 3, 5
  JointedStructure s = frame();
  s.laws[1].curve = {{-1e-3, 0}, {0, 0}, {1e-3, 20}}; // touches on one side
  expect_jacobian_of_differences(s, 22, settings);
  s.laws[0].coulomb = {.force = 3, .velocity = 0.05};
  expect_jacobian_of_differences(s, 22, settings);
  s.laws[0].offset = 1.1e-3; // beyond where its first slider slips
  s.laws[1].offset = -0.6e-3;
  expect_jacobian_of_differences(s, 22, settings);
  HarmonicSettings linearised = settings;
  linearised.method = JointMethod::describing_function;
  expect_jacobian_of_differences(s, 4, linearised);
}

// A small level sticks, a large one slips: both ends are linear.
TEST(HarmonicBalance, goes_from_stuck_to_slipping) {
  JointedStructure s = frame();
  s.laws = {{.stiffness = 2e3, .sliders = {{8e3, 2}}}, {.stiffness = 1e3, .sliders = {{4e3, 1}}}};
  HarmonicSettings settings{.harmonics = 5, .samples = 512, .from = 60, .to = 220};
  const auto peak = [&](double level) {
    const Branch b = follow_frequency(s, level, settings);
    EXPECT_TRUE(b.complete) << b.reason;
    double largest = 0, at = 0;
    for (const PeriodicPoint& p : b.points)
      if (std::abs(p.modes(0, 0)) > largest) {
        largest = std::abs(p.modes(0, 0));
        at = p.omega;
      }
    return std::pair{at, largest / level};
  };
  const auto low = peak(1e-3), middle = peak(8), high = peak(1e4);
  EXPECT_GT(low.first, middle.first);
  EXPECT_GT(middle.first, high.first);
  EXPECT_GT(low.second, middle.second); // friction damps in between
  EXPECT_GT(high.second, middle.second);
}

// x^2 + p = 0 ends at p = 0: what was reached comes back, with the reason.
TEST(Continuation, that_cannot_go_on_returns_what_it_had) {
  const ResidualFunction parabola = [](const VectorXd& x, double p) {
    return Residual{VectorXd::Constant(1, x[0] * x[0] + p), MatrixXd::Constant(1, 1, 2 * x[0]),
                    VectorXd::Ones(1)};
  };
  const Curve curve = follow(parabola, VectorXd::Ones(1), {.from = -1, .to = 1});
  EXPECT_FALSE(curve.complete);
  EXPECT_FALSE(curve.reason.empty());
  ASSERT_GT(curve.points.size(), 20);
  double highest = -1;
  for (const CurvePoint& c : curve.points) {
    EXPECT_NEAR(c.x[0] * c.x[0], -c.p, 1e-7);
    highest = std::max(highest, c.p);
  }
  EXPECT_NEAR(highest, 0, 0.01); // round the fold
  const Curve none = follow(parabola, VectorXd::Ones(1), {.from = 1, .to = 2});
  EXPECT_TRUE(none.points.empty());
  EXPECT_EQ(none.reason, "no solution at the start");
}

// Work of the joints in a cycle is the area of their loops, and all of them and the modes together
// take what the excitation gives: pi level Im-part of the motion it works on.
TEST(HarmonicBalance, takes_in_a_cycle_the_area_of_the_loops) {
  JointedStructure s = frame();
  s.laws = {{.stiffness = 2e3, .sliders = {{8e3, 2}}}, {.stiffness = 1e3, .sliders = {{4e3, 1}}}};
  const HarmonicSettings settings{.harmonics = 31, .samples = 4096};
  const PeriodicSolution p = periodic_response(s, 120, 20, settings);
  ASSERT_TRUE(p.converged);
  double taken = 0;
  const VectorXd energies = cycle_energies(s, p.point, p.orders);
  for (std::size_t j = 0; j < 2; ++j) {
    // Amplitude in time: harmonics add up.
    double largest = 0;
    for (int k = 0; k < 4096; ++k) {
      double x = 0;
      for (std::size_t n = 0; n < p.orders.size(); ++n)
        x += (p.point.joints(Eigen::Index(n), Eigen::Index(j)) *
              std::polar(1., 2 * pi * k * p.orders[n] / 4096))
                 .real();
      largest = std::max(largest, std::abs(x));
    }
    const double energy = energies[Eigen::Index(j)];
    ASSERT_GT(energy, 0);
    EXPECT_NEAR(energy / loop_energy(s.laws[j], largest), 1, 1e-4) << j;
    taken += energy;
  }
  double given = 0;
  for (Eigen::Index r = 0; r < 3; ++r) given += -pi * 20 * s.input[r] * p.point.modes(0, r).imag();
  for (std::size_t n = 0; n < p.orders.size(); ++n)
    for (Eigen::Index r = 0; r < 3; ++r) {
      const double W = p.orders[n] * 120.;
      taken += pi * std::norm(p.point.modes(Eigen::Index(n), r)) *
               (s.eta[r] * s.lambda[r] + 2 * s.zeta[r] * std::sqrt(s.lambda[r]) * W);
    }
  EXPECT_NEAR(taken / given, 1, 1e-3);
}

// Harmonic balance against integration in time, started from rest, over frequency and level.
TEST(HarmonicBalance, meets_integration_in_time_at_ten_points) {
  JointedStructure s = frame();
  s.eta.setZero();
  s.zeta << 0.02, 0.02, 0.02;
  s.laws = {{.stiffness = 2e3, .cubic = 1e6, .sliders = sliders_of({8e3, 4, -0.5, 1}, 12)},
            {.stiffness = 1e3, .sliders = {{4e3, 1}}}};
  const HarmonicSettings settings{.harmonics = 15, .samples = 1024};
  for (double level : {4., 30.})
    for (double omega : {60., 95., 115., 140., 300.}) {
      const PeriodicSolution p = periodic_response(s, omega, level, settings);
      ASSERT_TRUE(p.converged) << omega << " " << level;
      const SteadyMotion m = integrate(s, omega, level, 3, {});
      EXPECT_TRUE(m.settled) << omega << " " << level << " " << m.change;
      for (Eigen::Index r = 0; r < 3; ++r) {
        const double scale = p.point.modes.row(0).norm();
        EXPECT_LT(std::abs(p.point.modes(0, r) - m.modes(1, r)), 5e-3 * scale)
            << omega << " " << level << " " << r;
      }
    }
}

TEST(HarmonicBalance, follows_the_level_as_it_does_the_frequency) {
  JointedStructure s = frame();
  s.laws = {{.stiffness = 2e3, .sliders = {{8e3, 2}}}, {.stiffness = 1e3, .sliders = {{4e3, 1}}}};
  HarmonicSettings settings{.harmonics = 5, .samples = 512, .from = 0.5, .to = 30};
  const Branch b = follow_level(s, 110, settings);
  ASSERT_TRUE(b.complete) << b.reason;
  EXPECT_EQ(b.points.back().level, 30);
  const PeriodicSolution p = periodic_response(s, 110, 30, settings);
  ASSERT_TRUE(p.converged);
  EXPECT_LT((p.point.modes - b.points.back().modes).norm(), 1e-6 * p.point.modes.norm());
}

// Two masses, 0.02 kg with dry friction to the ground and 1 kg on 600 N/m, 40 N/m between (Krack &
// Gross, example 5): log10 a, log10 of the peak of q2, omega over that with mass 1 fixed, zeta %.
TEST(Backbone, of_two_masses_with_friction_meets_the_published_one) {
  const double m1 = 0.02, m2 = 1;
  MatrixXd K{{40 / m1, -40 / std::sqrt(m1 * m2)}, {-40 / std::sqrt(m1 * m2), 640 / m2}};
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(K);
  EXPECT_NEAR(std::sqrt(modes.eigenvalues()[0]), 24.15620, 1e-5);
  EXPECT_NEAR(std::sqrt(modes.eigenvalues()[1]), 45.3484, 1e-4);
  JointedStructure s;
  s.lambda = modes.eigenvalues();
  s.zeta = s.eta = s.input = VectorXd::Zero(2);
  s.joints = modes.eigenvectors().row(0).transpose() / std::sqrt(m1);
  s.laws = {{.coulomb = {.force = 5, .velocity = 0.05}}};
  const double fixed = 25.29822;
  struct Row {
    double a, peak, omega, zeta;
  };
  for (const Row& row : {Row{-1.5, -1.5, .99999, .0502}, Row{-1, -1, .99999, .0618},
                         Row{-.8, NAN, NAN, 3.739}, Row{-.75, -.7594, .97146, 3.7311},
                         Row{-.5, -.5097, .95758, 2.3687}, Row{-.25, -.2589, .95570, 1.3398},
                         Row{0, -.0086, .95511, .7548}, Row{.25, .2415, .95493, .4247},
                         Row{.5, .4915, .95489, .2388}, Row{1, .9915, .95486, .0755}}) {
    const Backbone to = backbone(s, 0,
                                 {.harmonics = 21,
                                  .samples = 1024,
                                  .from = std::pow(10, -1.5),
                                  .to = std::pow(10, std::max(row.a, -1.49)),
                                  .largest_step = 0.05});
    ASSERT_TRUE(to.complete) << to.reason;
    const BackbonePoint& p = row.a == -1.5 ? to.points.front() : to.points.back();
    EXPECT_NEAR(100 * p.zeta / row.zeta, 1, 0.01) << row.a;
    if (std::isnan(row.omega)) continue;
    EXPECT_NEAR(p.omega / fixed, row.omega, 1e-4) << row.a;
    double peak = 0;
    for (int k = 0; k < 720; ++k) {
      double q = 0;
      for (std::size_t n = 0; n < to.orders.size(); ++n)
        q += (modes.eigenvectors().row(1).dot(p.modes.row(Eigen::Index(n)).transpose()) *
              std::polar(1., 2 * pi * k * to.orders[n] / 720))
                 .real();
      peak = std::max(peak, std::abs(q));
    }
    EXPECT_NEAR(std::log10(peak), row.peak, 2e-3) << row.a;
  }
}

} // namespace
} // namespace plica
