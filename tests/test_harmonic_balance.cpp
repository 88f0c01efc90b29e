// Friction laws and harmonic balance against closed forms and published examples.
#include "solve/harmonic_balance.hpp"

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

VectorXd cosine(double amplitude, int steps) {
  VectorXd x(steps);
  for (int k = 0; k < steps; ++k) x[k] = amplitude * std::cos(2 * pi * k / steps);
  return x;
}

// Real and imaginary part of the first harmonic of the force per amplitude: stiffness and loss
// stiffness.
std::complex<double> describing_function(const JointLaw& law, double amplitude, int steps) {
  const VectorXd x = cosine(amplitude, steps);
  const VectorXd f = period_forces(law, x, MatrixXd::Zero(steps, 0)).force;
  std::complex<double> sum = 0;
  for (int k = 0; k < steps; ++k) sum += f[k] * std::polar(1., -2 * pi * k / steps);
  return 2. / steps * sum / amplitude;
}

// Closed forms: k_eq = (k_t / pi)(th - sin(2 th) / 2), th = acos(1 - 2 x_s / A); h = 4 mu (1 - x_s / A)
// / (pi A); energy 4 mu (A - x_s).
TEST(Jenkins, has_the_stiffness_and_loss_of_the_closed_form) {
  struct Row {
    double ratio, k, h, energy;
  };
  const JointLaw law{.sliders = {{2e5, 30}}};
  const double slip = 30 / 2e5;
  for (const Row& row : {Row{1.0, 1, 0, 0}, Row{1.2, .89045, .17684, .8}, Row{1.5, .70821, .28294, 2},
                         Row{2, .5, .31831, 4}, Row{3, .29179, .28294, 8}, Row{5, .14238, .20372, 16},
                         Row{10, .05204, .11459, 36}}) {
    const std::complex<double> g = describing_function(law, row.ratio * slip, 1 << 14);
    EXPECT_NEAR(g.real() / 2e5, row.k, 1e-4) << row.ratio;
    EXPECT_NEAR(g.imag() / 2e5, row.h, 1e-4) << row.ratio;
    EXPECT_NEAR(loop_energy(law, row.ratio * slip) / (30 * slip), row.energy, 1e-4);
    // The loop's area is that of the first harmonic: pi h A^2.
    EXPECT_NEAR(pi * g.imag() * std::pow(row.ratio * slip, 2) / (30 * slip), row.energy, 2e-4);
  }
}

TEST(SegalmanIwan, meets_its_force_energy_and_secant_stiffness) {
  const SegalmanIwan iwan{.K_T = 1.5e7, .F_S = 4000, .chi = -0.5, .beta = 1};
  EXPECT_NEAR(iwan.R() / 1.875e8, 1, 1e-12);
  EXPECT_NEAR(iwan.S() / 7.5e6, 1, 1e-12);
  EXPECT_NEAR(iwan.pm() / 4e-4, 1, 1e-12);
  const JointLaw law{.sliders = sliders_of(iwan, 4000)};
  EXPECT_NEAR(law.stuck_stiffness() / 1.5e7, 1, 1e-12);
  struct Row {
    double u, force, energy;
  };
  for (const Row& row : {Row{0.1, 536.7544, 2.023858e-3}, Row{0.3, 1471.3665, 3.154882e-2},
                         Row{0.6, 2670.4840, 1.784671e-1}, Row{0.9, 3692.3701, 4.917974e-1}}) {
    const double u = row.u * iwan.pm();
    EXPECT_NEAR(first_loading(law, u) / row.force, 1, 1e-5) << row.u;
    EXPECT_NEAR(loop_energy(law, u) / row.energy, 1, 1e-4) << row.u;
  }
  for (const SegalmanIwan& bad : {SegalmanIwan{0, 1, 0, 0}, SegalmanIwan{1, -1, 0, 0},
                                  SegalmanIwan{1, 1, -1, 0}, SegalmanIwan{1, 1, 0, -1}})
    EXPECT_THROW(sliders_of(bad), std::invalid_argument);
}

// Unloading from x0: F0 + 2 f((x - x0) / 2), sliders in parallel obey it exactly.
TEST(Sliders, obey_masing) {
  const JointLaw law{.sliders = sliders_of({.K_T = 2e6, .F_S = 300, .chi = -0.3, .beta = 0.5}, 60)};
  const double A = 3e-4;
  const int steps = 4096;
  const VectorXd x = cosine(A, steps);
  const VectorXd f = period_forces(law, x, MatrixXd::Zero(steps, 0)).force;
  for (int k = 0; k <= steps / 2; k += 64)
    EXPECT_NEAR(f[k], f[0] + 2 * first_loading(law, (x[k] - A) / 2), 1e-6 * f[0]) << k;
}

JointedStructure duffing() {
  return {.lambda = VectorXd::Ones(1),
          .zeta = VectorXd::Constant(1, 0.025),
          .eta = VectorXd::Zero(1),
          .joints = MatrixXd::Ones(1, 1),
          .input = VectorXd::Ones(1),
          .laws = {{.cubic = 0.1}}};
}

// q'' + 0.05 q' + q + 0.1 q^3 = 0.18 cos(w t) (Krack & Gross, example 1). One harmonic: the closed
// form; seven: their program.
TEST(HarmonicBalance, of_duffing_meets_the_closed_form_and_the_published_branch) {
  HarmonicSettings settings{.harmonics = 1, .samples = 64, .from = 0.8, .to = 1.4};
  settings.largest_step = 0.002;
  const Branch one = follow_frequency(duffing(), 0.18, settings);
  ASSERT_TRUE(one.complete) << one.reason;
  double peak = 0, at = 0;
  for (const PeriodicPoint& p : one.points) {
    const double a = std::abs(p.joints(1, 0)), z = 0.05, g = 0.1, P = 0.18;
    const double root =
        std::sqrt(std::max(0., P * P / (a * a) + std::pow(z, 4) / 4 - z * z - 3 * z * z * g * a * a / 4));
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
  peak = 0;
  bool turned = false;
  for (std::size_t i = 0; i < seven.points.size(); ++i) {
    peak = std::max(peak, std::abs(seven.points[i].joints(1, 0)));
    turned = turned || (i > 0 && seven.points[i].omega < seven.points[i - 1].omega);
  }
  EXPECT_TRUE(turned); // round the fold
  EXPECT_NEAR(peak, 2.8287, 5e-4);
  struct Row {
    double omega, a1, a3;
  };
  for (const Row& row : {Row{0.8, .474872, 5.663e-4}, Row{1.0, 1.305345, 7.179e-3},
                         Row{1.2, 2.509198, 3.587e-2}}) {
    settings.from = 0.8;
    settings.to = row.omega;
    PeriodicPoint p;
    if (row.omega == 0.8) {
      p = periodic_response(duffing(), 0.8, 0.18, settings).point;
    } else {
      const Branch upper = follow_frequency(duffing(), 0.18, settings);
      p = periodic_response(duffing(), row.omega, 0.18, settings, upper.points.back().joints).point;
    }
    EXPECT_NEAR(std::abs(p.joints(1, 0)) / row.a1, 1, 1e-5) << row.omega;
    EXPECT_NEAR(std::abs(p.joints(3, 0)) / row.a3, 1, 1e-3) << row.omega;
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
  s.laws = {{.stiffness = 2e3, .cubic = 1e9, .sliders = {{8e3, 2}, {5e3, 8}}},
            {.curve = {{-2e-3, -30}, {-1e-3, -1}, {0, 0}, {1e-3, 1}, {2e-3, 30}}, .sliders = {{4e3, 1}}}};
  return s;
}

TEST(HarmonicBalance, has_the_jacobian_of_finite_differences) {
  const HarmonicSettings settings{.harmonics = 5, .samples = 512};
  std::mt19937 random(5);
  VectorXd x(22);
  for (double& v : x) v = 2e-3 * (double(random()) / double(std::mt19937::max()) - 0.5);
  const double omega = 130, level = 20;
  const HarmonicResidual r = harmonic_residual(frame(), omega, level, settings, x);
  const double h = 1e-9;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    VectorXd up = x, down = x;
    up[i] += h;
    down[i] -= h;
    const VectorXd d = (harmonic_residual(frame(), omega, level, settings, up).value -
                        harmonic_residual(frame(), omega, level, settings, down).value) /
                       (2 * h);
    EXPECT_LT((d - r.by_motion.col(i)).norm() / r.by_motion.norm(), 1e-6) << i;
  }
  const VectorXd d = (harmonic_residual(frame(), omega + 1e-4, level, settings, x).value -
                      harmonic_residual(frame(), omega - 1e-4, level, settings, x).value) /
                     2e-4;
  EXPECT_LT((d - r.by_omega).norm() / r.by_omega.norm(), 1e-6);
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
      if (std::abs(p.modes(1, 0)) > largest) {
        largest = std::abs(p.modes(1, 0));
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

} // namespace
} // namespace plica
