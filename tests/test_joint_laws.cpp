// Friction laws and their describing functions against closed forms.
#include "elements/joint_law.hpp"

#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

VectorXd cosine(double amplitude, int steps) {
  VectorXd x(steps);
  for (int k = 0; k < steps; ++k) x[k] = amplitude * std::cos(2 * pi * k / steps);
  return x;
}

// Real and imaginary part of the first harmonic of the force per amplitude: stiffness and loss
// stiffness.
std::complex<double> sampled_gain(const JointLaw& law, double amplitude, int steps) {
  const VectorXd x = cosine(amplitude, steps);
  const VectorXd f = period_forces(law, x, VectorXd::Zero(steps));
  std::complex<double> sum = 0;
  for (int k = 0; k < steps; ++k) sum += f[k] * std::polar(1., -2 * pi * k / steps);
  return 2. / steps * sum / amplitude;
}

// Closed forms: k_eq = (k_t / pi)(th - sin(2 th) / 2), th = acos(1 - 2 x_s / A); h = 4 mu (1 - x_s
// / A) / (pi A); energy 4 mu (A - x_s).
// From where it slips, a slider of slip displacement x_s that moves by A cos: below x_s it sticks,
// its mean lower by k A; beyond, its loop is that around rest and its mean nothing.
TEST(JointLaws, count_from_the_offset) {
  const JointLaw law{.sliders = {{2e5, 30}}, .offset = 4e-4}; // x_s = 0.15 mm
  constexpr int steps = 4096;
  VectorXd c(steps);
  for (int k = 0; k < steps; ++k) c[k] = std::cos(2 * pi * k / steps);
  for (const double A : {0.5e-4, 1e-4, 2e-4, 1e-3}) {
    const VectorXd f = period_forces(law, A * c, VectorXd::Zero(steps));
    EXPECT_NEAR(f.mean(), A < 1.5e-4 ? -2e5 * A : -30, 1e-3) << A;
    EXPECT_NEAR(2. / steps * f.dot(c) / A / describing_function(law, A, 1).gain.real(), 1, 1e-5)
        << A;
  }
  EXPECT_EQ(first_loading(law, 1e-4), 0);
  EXPECT_NEAR(first_loading(law, -1e-4), -20, 1e-9);
  EXPECT_NEAR(first_loading(law, -1), -60, 1e-9);
  EXPECT_EQ(law.stuck_stiffness(), 2e5);
  const JointLaw springs{
      .stiffness = 3e3, .cubic = 2e9, .curve = {{-1e-3, -8}, {2e-4, 0}, {1e-3, 30}}};
  JointLaw moved = springs;
  moved.offset = 7e-4;
  for (const double x : {-2e-3, -1e-4, 5e-4}) {
    const ElasticForce here = elastic_force(moved, x, 0),
                       whole = elastic_force(springs, 7e-4 + x, 0);
    EXPECT_NEAR(here.force, whole.force - elastic_force(springs, 7e-4, 0).force, 1e-12);
    EXPECT_NEAR(here.by_motion, whole.by_motion, 1e-9);
  }
  EXPECT_FALSE(moved.is_odd());
}

TEST(Jenkins, has_the_stiffness_and_loss_of_the_closed_form) {
  struct Row {
    double ratio, k, h, energy;
  };
  const JointLaw law{.sliders = {{2e5, 30}}};
  const double slip = 30 / 2e5;
  for (const Row& row :
       {Row{1.0, 1, 0, 0}, Row{1.2, .89045, .17684, .8}, Row{1.5, .70821, .28294, 2},
        Row{2, .5, .31831, 4}, Row{3, .29179, .28294, 8}, Row{5, .14238, .20372, 16},
        Row{10, .05204, .11459, 36}}) {
    const std::complex<double> g = sampled_gain(law, row.ratio * slip, 1 << 14);
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

// A density phi^-1.5 from the smallest slip on: the force at first loading by its integral.
TEST(SegalmanIwan, with_a_smallest_slip_has_its_stiffness_and_forces) {
  const SegalmanIwan iwan{.K_T = 2e6, .F_S = 40, .chi = -1.5, .beta = 0, .smallest = 1e-3};
  const JointLaw law{.sliders = sliders_of(iwan, 800)};
  EXPECT_NEAR(law.stuck_stiffness() / 2e6, 1, 1e-12);
  double slip_force = 0;
  for (const JenkinsSlider& s : law.sliders) slip_force += s.slip_force;
  EXPECT_NEAR(slip_force / 40, 1, 1e-12);
  const double R = iwan.R(), pm = iwan.pm(), low = 1e-3 * pm;
  for (double u : {0.01 * pm, 0.1 * pm, 0.5 * pm}) {
    // sliders below u slip with R phi^-0.5, those above stick with R phi^-1.5 u
    const double force = R * 2 * (std::sqrt(u) - std::sqrt(low)) +
                         R * u * 2 * (1 / std::sqrt(u) - 1 / std::sqrt(pm));
    EXPECT_NEAR(first_loading(law, u) / force, 1, 1e-4) << u / pm;
  }
  EXPECT_THROW(sliders_of({.K_T = 1, .F_S = 1, .chi = -1.5}), std::invalid_argument);
}

// Unloading from x0: F0 + 2 f((x - x0) / 2), sliders in parallel obey it exactly.
TEST(Sliders, obey_masing) {
  const JointLaw law{.sliders = sliders_of({.K_T = 2e6, .F_S = 300, .chi = -0.3, .beta = 0.5}, 60)};
  const double A = 3e-4;
  const int steps = 4096;
  const VectorXd x = cosine(A, steps);
  const VectorXd f = period_forces(law, x, VectorXd::Zero(steps));
  for (int k = 0; k <= steps / 2; k += 64)
    EXPECT_NEAR(f[k], f[0] + 2 * first_loading(law, (x[k] - A) / 2), 1e-6 * f[0]) << k;
}

// The closed forms of the describing function against the sampled loop.
TEST(DescribingFunction, is_the_first_harmonic_of_the_loop) {
  const JointLaw law{.stiffness = 1e3,
                     .cubic = 4e9,
                     .curve = {{-2e-3, -30}, {-1e-3, -1}, {0, 0}, {1e-3, 1}, {2e-3, 30}},
                     .sliders = {{8e3, 2}, {5e3, 8}}};
  for (double A : {1e-4, 4e-4, 1.2e-3, 3e-3}) {
    const std::complex<double> sampled = sampled_gain(law, A, 1 << 14);
    const DescribingFunction f = describing_function(law, A, 100);
    EXPECT_LT(std::abs(f.gain - sampled), 1e-3 * std::abs(sampled)) << A;
    const double h = 1e-7;
    const std::complex<double> slope =
        (describing_function(law, A + h, 100).gain - describing_function(law, A - h, 100).gain) /
        (2 * h);
    EXPECT_LT(std::abs(f.slope - slope), 1e-3 * std::abs(sampled) / A) << A;
  }
}

TEST(Sliders, in_series_move_together_as_one) {
  const JointLaw whole{.stiffness = 100,
                       .cubic = 3e5,
                       .curve = {{-1, -5}, {0, 0}, {1, 8}},
                       .sliders = {{50, 2}},
                       .coulomb = {1, 0.1}};
  const JointLaw part = in_series(whole, 4);
  EXPECT_NEAR(first_loading(part, 0.02), first_loading(whole, 0.08), 1e-12);
  EXPECT_NEAR(elastic_force(part, 0.02, 0.01).force, elastic_force(whole, 0.08, 0.04).force, 1e-12);
}

} // namespace
} // namespace plica
