// Damped springs in the harmonic balance: against the same damping in the modes, against the linear
// response of the stuck and of the slipping structure, against integration in time.
#include "io/files/files.hpp"
#include "io/input/case_file.hpp"
#include "run/analyses/run.hpp"
#include "solve/backbone.hpp"
#include "solve/harmonic_balance.hpp"
#include "solve/joint_time_integration.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;

// q'' + 0.05 q' + q + 0.1 q^3 = 0.18 cos(w t), its damping that of the mode or a dashpot.
JointedStructure oscillator_on(bool dashpot) {
  JointedStructure s;
  s.lambda = VectorXd::Ones(1);
  s.zeta = VectorXd::Constant(1, dashpot ? 0 : 0.025);
  s.eta = VectorXd::Zero(1);
  s.joints = MatrixXd::Ones(1, 1);
  s.input = VectorXd::Ones(1);
  s.laws = {{.cubic = 0.1}};
  if (!dashpot) return s;
  s.dampers = MatrixXd::Constant(1, 1, 0.5);
  s.added = {[](Complex x) { return 0.2 * x; }}; // 0.5^2 * 0.2 = 0.05
  return s;
}

// Two joints and two damped springs over three modes: a Maxwell branch and a springpot.
JointedStructure line() {
  JointedStructure s;
  s.lambda = VectorXd{{1e4, 9e4, 4e5}};
  s.zeta = VectorXd{{0.01, 0.01, 0.02}};
  s.eta = VectorXd::Zero(3);
  s.joints = MatrixXd{{1, 0.3}, {-0.8, 1}, {0.5, -0.9}};
  s.input = VectorXd{{1, 0.5, -0.2}};
  s.laws = {{.stiffness = 2e3, .sliders = {{8e3, 2}}}, {.stiffness = 1e3, .sliders = {{4e3, 1}}}};
  s.dampers = MatrixXd{{0.6, -0.2}, {0.3, 0.9}, {-0.4, 0.5}};
  s.added = {[](Complex x) { return 4e3 * x * 0.01 / (1. + x * 0.01); },
             [](Complex x) { return 9e3 * std::pow(x * 1e-4, 0.5); }};
  return s;
}

TEST(DampedLevels, a_dashpot_is_the_viscous_damping_of_its_mode) {
  HarmonicSettings settings{.harmonics = 5, .samples = 128, .from = 0.8, .to = 1.4};
  settings.largest_step = 0.01;
  const Branch modal = follow_frequency(oscillator_on(false), 0.18, settings);
  const Branch spring = follow_frequency(oscillator_on(true), 0.18, settings);
  ASSERT_TRUE(modal.complete && spring.complete) << spring.reason;
  ASSERT_EQ(modal.points.size(), spring.points.size());
  for (std::size_t i = 0; i < modal.points.size(); ++i) {
    EXPECT_NEAR(modal.points[i].omega, spring.points[i].omega, 1e-6);
    EXPECT_LT((modal.points[i].modes - spring.points[i].modes).norm(),
              1e-5 * modal.points[i].modes.norm());
    EXPECT_NEAR(energy_damping(oscillator_on(true), spring.points[i], spring.orders),
                energy_damping(oscillator_on(false), modal.points[i], modal.orders), 1e-7);
  }
  const BackboneSettings along{.harmonics = 5, .samples = 128, .from = 0.01, .to = 3};
  const Backbone a = backbone(oscillator_on(false), 0, along),
                 b = backbone(oscillator_on(true), 0, along);
  ASSERT_TRUE(a.complete && b.complete) << b.reason;
  EXPECT_NEAR(a.points.back().omega, b.points.back().omega, 1e-6);
  EXPECT_NEAR(a.points.back().zeta, b.points.back().zeta, 1e-7);
  EXPECT_NEAR(b.points.front().zeta, 0.025, 1e-5);
}

TEST(DampedLevels, have_the_jacobian_of_finite_differences) {
  const JointedStructure s = line();
  const HarmonicSettings settings{.harmonics = 3, .samples = 512};
  const VectorXd x = 1e-3 * VectorXd{{0.4, -0.7, 0.2, 0.1, -0.5, 0.3, 0.6, -0.2}};
  const double omega = 130, level = 20;
  const Residual r = harmonic_residual(s, omega, level, settings, x);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const VectorXd h = 1e-9 * VectorXd::Unit(x.size(), i);
    const VectorXd d = (harmonic_residual(s, omega, level, settings, x + h).value -
                        harmonic_residual(s, omega, level, settings, x - h).value) /
                       2e-9;
    EXPECT_LT((d - r.by_motion.col(i)).norm() / r.by_motion.norm(), 1e-6) << i;
  }
  const VectorXd d = (harmonic_residual(s, omega + 1e-4, level, settings, x).value -
                      harmonic_residual(s, omega - 1e-4, level, settings, x).value) /
                     2e-4;
  EXPECT_LT((d - r.by_parameter).norm() / r.by_parameter.norm(), 1e-6);
}

// The response of the line with springs in place of its joints: D(w) q = f over all modes.
VectorXcd linear_response(const JointedStructure& s, const VectorXd& springs, double omega) {
  MatrixXcd D = s.lambda.cast<Complex>().asDiagonal();
  for (Eigen::Index r = 0; r < 3; ++r)
    D(r, r) += Complex(-omega * omega, 2 * s.zeta[r] * std::sqrt(s.lambda[r]) * omega);
  for (Eigen::Index k = 0; k < 2; ++k) {
    D += s.dampers.col(k) * s.added[std::size_t(k)]({0, omega}) * s.dampers.col(k).transpose();
    D += springs[k] * s.joints.col(k) * s.joints.col(k).transpose();
  }
  return D.partialPivLu().solve(VectorXcd(s.input.cast<Complex>()));
}

TEST(DampedLevels, small_ones_are_the_stuck_and_large_ones_the_slipping_linear_response) {
  const HarmonicSettings settings{.harmonics = 3, .samples = 512};
  for (const double omega : {60., 115., 140., 290.}) {
    const auto first = [&](double level) -> VectorXcd {
      return periodic_response(line(), omega, level, settings).point.modes.row(0).transpose() /
             level;
    };
    const VectorXcd stuck = linear_response(line(), VectorXd{{10e3, 5e3}}, omega);
    EXPECT_LT((first(1e-3) - stuck).norm(), 1e-9 * stuck.norm()) << omega;
    const VectorXcd slipping = linear_response(line(), VectorXd{{2e3, 1e3}}, omega);
    EXPECT_LT((first(1e7) - slipping).norm(), 1e-5 * slipping.norm()) << omega;
  }
}

// In between, against Newmark's method with the springs as they are at that frequency; a dashpot is
// the same in every harmonic.
TEST(DampedLevels, between_are_met_by_integration_in_time) {
  JointedStructure s = line();
  s.added[0] = [](Complex x) { return 30. * x; };
  s.added[1] = [](Complex x) { return 12. * x; };
  const HarmonicSettings settings{.harmonics = 9, .samples = 1024};
  for (const double omega : {100., 125.}) {
    const PeriodicSolution balanced = periodic_response(s, omega, 8, settings);
    ASSERT_TRUE(balanced.converged) << omega;
    const SteadyMotion in_time =
        integrate(s, omega, 8, 1, {.steps = 4000}, balanced.orders, balanced.point);
    ASSERT_TRUE(in_time.settled);
    const auto wanted = in_time.modes.row(1);
    EXPECT_LT((balanced.point.modes.row(0) - wanted).norm(), 2e-3 * wanted.norm()) << omega;
  }
}

// A mass on a rubber mount with friction beside it, as a case file says it.
constexpr const char* rubber = R"(case: rubber
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850 kg/m3}}
parts:
  bar: {type: beam, points: [[0, 0, 0], [0, 0.1, 0]], elements: 2,
        section: {shape: solid, material: steel, radius: 10 mm}}
  weight: {type: mass, at: bar.end, mass: 2 kg}
caps: {foot: {of: bar.start}}
mount:
  foot: {stiffness: [40 N/mm, 40 N/mm, 40 N/mm, 5000, 5000, 5000], damping: {loss_factor: 15 %},
         friction: {y: {sliders: [{stiffness: 20 N/mm, slip_force: 3 N}]}}}
sensors: [{name: top, at: [0, 0.1, 0]}]
analyses:
  modes: {count: 6}
  error_bars: false
  levels: {base: [y], levels: [0.001, 100000], band: [10 Hz, 45 Hz], points: 60}
)";

TEST(DampedLevels, of_a_rubber_mount_with_friction_are_between_two_complex_springs) {
  const test::TemporaryFolder folder("rubber");
  write_whole(folder.path / "rubber.yaml", rubber);
  const CaseFile file = read_case((folder.path / "rubber.yaml").string());
  const Results r = run(file.data, [](const std::string&) {});
  const LevelResponses& responses = r.level_responses.at(0);
  const double mass = r.model.mass;
  for (std::size_t i = 0; i < 2; ++i) {
    const LevelCurve& c = responses.curves.at(i);
    ASSERT_TRUE(c.complete) << c.reason;
    const Complex k = 4e4 * Complex(1, 0.15) + (i == 0 ? 2e4 : 0);
    for (Eigen::Index p = 0; p < c.hertz.size(); ++p) {
      const double w = 2 * pi * c.hertz[p];
      const Complex wanted = k / (k - mass * w * w);
      EXPECT_LT(std::abs(c.first(p, responses.strongest) - wanted), 5e-3 * std::abs(wanted))
          << c.level << " at " << c.hertz[p];
    }
  }
}

} // namespace
} // namespace plica
