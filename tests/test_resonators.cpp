// What hangs on a structure by a spring of its own: no effect of the library, but what would
// explain most of a test has to stand up to it.
#include "diagnose/account/gap_problem.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/effects/resonators.hpp"
#include "tests/changed_beam.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of changed_beam::held_beam().
constexpr double beam_length = 0.5, beam_width = 0.03, beam_depth = 0.01;

// Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1.
constexpr std::array<double, 8> lambda_of_cantilever{1.87510407,  4.69409113,  7.85475744,
                                                     10.99554073, 14.13716839, 17.27875953,
                                                     20.42035225, 23.56194490};

// Frequencies (Hz) of Euler's cantilever with a mass on a spring at a place, by the modes of the
// bare one, which have a mass of rho A L each.
VectorXd with_a_hung_mass(double thickness, double mass, double hertz, double at) {
  constexpr auto n = Index(lambda_of_cantilever.size());
  const double area = beam_width * beam_depth, omega = 2 * std::numbers::pi * hertz;
  constexpr double E = 200e9, rho = 7850;
  const double bending = E * area * thickness * thickness / 12;
  MatrixXd K = MatrixXd::Zero(n + 1, n + 1), M = MatrixXd::Zero(n + 1, n + 1);
  VectorXd shape(n + 1);
  for (Index i = 0; i < n; ++i) {
    const double l = lambda_of_cantilever[std::size_t(i)], x = l * at / beam_length;
    const double sigma = (std::cosh(l) + std::cos(l)) / (std::sinh(l) + std::sin(l));
    shape[i] = std::cosh(x) - std::cos(x) - sigma * (std::sinh(x) - std::sin(x));
    M(i, i) = rho * area * beam_length;
    K(i, i) = bending * std::pow(l / beam_length, 4) * beam_length;
  }
  shape[n] = -1;
  M(n, n) = mass;
  K += mass * omega * omega * shape * shape.transpose();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(K, M);
  return pairs.eigenvalues().cwiseSqrt() / (2 * std::numbers::pi);
}

// The cantilever with 60 g on a spring 0.3 m along, which resonates between its modes.
Measured hammered(double mass, double hertz) {
  Measured m;
  m.specimen = "beam";
  const auto add = [&](Axis axis, double thickness, int count) {
    const VectorXd f = with_a_hung_mass(thickness, mass, hertz, 0.3);
    for (int order = 1; order <= count; ++order) {
      m.modes.push_back(changed_beam::bending(axis, order, "", f[order - 1]));
      m.modes.back().sigma = 0.001 * f[order - 1];
    }
  };
  add(Axis::z, beam_depth, 4);
  add(Axis::x, beam_width, 3);
  return m;
}

TEST(Resonators, hang_at_sensors_and_anywhere_along_a_beam) {
  Case c = changed_beam::held_beam();
  c.sensors = {{.name = "tip", .at = {0, beam_length, 0}}};
  const Measured m;
  const Nominal nominal = nominal_of(c, m);
  const std::vector<Hypothesis> all = resonators(nominal.structure(m));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].place, "sensor.tip");
  EXPECT_EQ(all[1].place, "beam");
  EXPECT_EQ(all[1].along, std::vector<std::size_t>{2});
  EXPECT_EQ(words_of_resonator(all[1], Eigen::Vector3d(0.015, 805, 0.3)),
            "15 g on a spring of its own, which resonates at 805 Hz, at beam, 0.3 m");
  EXPECT_EQ(words_of_resonator(all[1], Eigen::Vector4d(0.015, 1450, 0.3, 0.03)),
            "15 g, then 30 g on a spring of its own, which resonates at 1450 Hz, at beam, 0.3 m")
      << "of two states that changed";
  c.diagnose.places = {"sensor"};
  const Nominal asked = nominal_of(c, m);
  const std::vector<Hypothesis> there = resonators(asked.structure(m));
  ASSERT_EQ(there.size(), 1U);
  EXPECT_EQ(there[0].place, "sensor.tip");
}

// But for what shear and rotary inertia take from Euler's beam, at most twice what they take from a
// wave of its length (Timoshenko): (1 + E / (kappa G)) (lambda r / L)^2 / 2, r the radius of
// gyration.
TEST(Resonators, on_a_cantilever_move_its_modes_as_in_closed_form) {
  const Measured m = hammered(0.06, 150);
  const Nominal nominal = nominal_of(changed_beam::held_beam(), m);
  const std::vector<Hypothesis> all = resonators(nominal.structure(m));
  const TestData test{.data = m, .responses = {}};
  const TestReadings readings = readings_of(test);
  const auto y = Predictor(nominal, readings, {&all.back()})(Eigen::Vector3d(0.06, 150, 0.3));
  ASSERT_TRUE(y);
  for (std::size_t i = 0; i < readings.readings.size(); ++i) {
    const MeasuredMode& mode = m.modes[i];
    const double thickness = mode.direction == Axis::z ? beam_depth : beam_width;
    const double wave = lambda_of_cantilever[std::size_t(mode.order) - 1] / beam_length;
    const double shear = (1 + 2.6 / 0.85) * std::pow(wave * thickness, 2) / 12;
    EXPECT_NEAR((*y)[Index(i)], readings.readings[i].log_value, 0.001 + shear)
        << readings.readings[i].name;
  }
}

// Its mass, its frequency and its place, though the model is 2 % off in one mode and the readings
// are said to be known within a per mille.
TEST(ResonatorsSlow, are_told_of_where_nothing_that_is_known_explains_the_test) {
  const Measured m = hammered(0.06, 150);
  const Diagnosis d =
      diagnose(changed_beam::held_beam(), {.data = m, .responses = {}}, {.plan_next = false});
  EXPECT_TRUE(d.verdict == Verdict::unknown || d.verdict == Verdict::ambiguous) << d.headline;
  ASSERT_TRUE(d.resonator) << d.headline;
  EXPECT_NE(d.headline.find("would do better: " + d.resonator->words), std::string::npos)
      << d.headline;
  EXPECT_EQ(d.resonator->found.place, "beam");
  EXPECT_FALSE(d.resonator->found.nodes.empty());
  const std::vector<EstimatedParameter>& found = d.resonator->found.parameters;
  ASSERT_EQ(found.size(), 3U) << "mass, frequency and place";
  EXPECT_NEAR(found[0].value, 0.06, 0.006);
  EXPECT_NEAR(found[1].value, 150, 2);
  EXPECT_NEAR(found[2].value, 0.3, 0.01);
  for (const EstimatedParameter& p : found)
    EXPECT_TRUE(p.interval[0] <= p.value && p.value <= p.interval[1]) << p.name;
}

// A light one that resonates high, a heavy one that resonates low, of what the model itself
// answers: the search finds either, from all over their range.
TEST(Resonators, are_found_wherever_they_resonate) {
  for (const Eigen::Vector3d& truth : {Eigen::Vector3d(0.01, 480, 0.3), {0.15, 60, 0.3}}) {
    Measured m = hammered(truth[0], truth[1]);
    const Nominal nominal = nominal_of(changed_beam::held_beam(), m);
    const Hypothesis hanging = resonators(nominal.structure(m)).back();
    const TestReadings readings = readings_of({.data = m, .responses = {}});
    const auto y = Predictor(nominal, readings, {&hanging})(truth);
    ASSERT_TRUE(y);
    for (std::size_t i = 0; i < m.modes.size(); ++i)
      m.modes[i].frequency = std::exp((*y)[Index(i)]);
    const TestData test{.data = m, .responses = {}};
    const auto problem = stated_gap(changed_beam::held_beam(), test, {});
    const std::vector<Hypothesis> all = resonators_of(*problem);
    ASSERT_EQ(all.size(), 1U);
    const HypothesisFit fit = fit_of(problem->context(), {&all.front()});
    ASSERT_TRUE(fit.solved);
    EXPECT_NEAR(fit.values[1] / truth[1], 1, 0.05); // mass and place trade
    EXPECT_LT(fit.chi2, 1) << "of " << fit.error.size() << " readings";
  }
}

} // namespace
} // namespace plica::test
