// Modes that a shaker drives to a level: by the acceleration that is held where it drives, or by
// its force.
#include "diagnose/diagnose.hpp"
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/predict/predictor.hpp"
#include "diagnose/readings/readings.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plica {
namespace {

const std::string lap_folder = PLICA_SOURCE_DIR "/cases/lap_levels/";

// A free uniform beam with a spring against bending in its middle (cases/lap_levels):
// square of the first mode of unit mass at a place, 1/kg. Half of it, free at x = 0:
//   w = cosh bx + cos bx + c (sinh bx + sin bx), no shear force at x = L: c = -w3[0] / w3[1]
double mode_squared(double hertz, double place) {
  constexpr double half = 0.36, width = 0.0254, depth = 0.0127, rho = 7900, E = 196e9;
  const double EI = E * width * std::pow(depth, 3) / 12, mass = rho * width * depth;
  const double b = std::pow(mass * std::pow(2 * std::numbers::pi * hertz, 2) / EI, 0.25);
  const double x = b * half;
  const double c = -(std::sinh(x) + std::sin(x)) / (std::cosh(x) - std::cos(x));
  const auto w = [&](double at) {
    return std::cosh(b * at) + std::cos(b * at) + c * (std::sinh(b * at) + std::sin(b * at));
  };
  double integral = 0;
  constexpr int steps = 2000; // of Simpson's rule
  for (int i = 0; i <= steps; ++i)
    integral += (i == 0 || i == steps ? 1
                 : i % 2              ? 4
                                      : 2) *
                std::pow(w(half * i / steps), 2) * half / steps / 3;
  return std::pow(w(2 * half - place), 2) / (2 * mass * integral);
}

// At resonance a force F drives a mode to the acceleration F phi^2 / (2 zeta): the force that gives
// the damping that a held acceleration gives says what phi is.
TEST(DrivenModes, a_force_and_the_acceleration_that_it_gives_are_one_level) {
  const CaseFile file = read_case(lap_folder + "lap_levels.yaml");
  Measured m = read_measured(lap_folder + "measured.yaml");
  const Nominal nominal = nominal_of(file.data, m);
  const std::vector<Hypothesis> all = joint_friction().hypotheses(nominal.structure(m));
  m.modes.resize(1);
  m.hold_out.clear();
  ASSERT_TRUE(!all.empty() && all[0].way.empty()) << "of all its motions";
  const auto answer = [&](std::optional<double> acceleration, std::optional<double> force) {
    m.modes[0].acceleration = acceleration;
    m.modes[0].force = force;
    const TestReadings readings = readings_of({.data = m, .responses = {}});
    const Predictor predictor(nominal, readings, {&all[0]});
    Eigen::VectorXd values(6); // ratio, share, slip, exponent, across, loss
    values << 1, 0.5, 1e-4, 1, 1, 1;
    const auto y = predictor(values);
    return std::pair{std::exp((*y)[0]), std::exp((*y)[1])}; // Hz, damping
  };
  double before = 0;
  for (const double a : {20., 50., 300.}) {
    const auto [hertz, zeta] = answer(a, std::nullopt);
    EXPECT_GT(zeta, 1.001 * before) << "damping grows until all of it slides";
    before = zeta;
    double low = 1e-4, high = 1e3;
    for (int i = 0; i < 60; ++i) {
      const double force = std::sqrt(low * high);
      (answer(std::nullopt, force).second < zeta ? low : high) = force;
    }
    EXPECT_NEAR(answer(std::nullopt, low).first, hertz, 1e-5 * hertz);
    constexpr double drive = 0.6438;
    EXPECT_NEAR(2 * zeta * a / low, mode_squared(hertz, drive), 0.01 * mode_squared(hertz, drive))
        << a << " m/s2";
  }
}

// Where the share of what slips grows as X^b, a Masing joint loses 4 c b / (2 + b) X^(2 + b) in a
// cycle and softens by c X^b: d zeta = 4 / pi b / (2 + b) |df| / f, whatever share of the mode it
// has (Segalman, J. Appl. Mech. 72, 2005). Sliders are discrete: from one to the next it holds
// within a tenth, on the mean of three levels within 4 %.
TEST(DrivenModes, what_a_joint_loses_goes_with_what_it_softens_as_masing_says) {
  const CaseFile file = read_case(lap_folder + "lap_levels.yaml");
  Measured m = read_measured(lap_folder + "measured.yaml");
  const Nominal nominal = nominal_of(file.data, m);
  const std::vector<Hypothesis> all = joint_friction().hypotheses(nominal.structure(m));
  ASSERT_FALSE(all.empty());
  m.modes.resize(1);
  m.hold_out.clear();
  for (const double b : {0.5, 1., 1.6}) {
    const auto answer = [&](double acceleration) {
      m.modes[0].acceleration = acceleration;
      m.modes[0].force.reset();
      const TestReadings readings = readings_of({.data = m, .responses = {}});
      Eigen::VectorXd values(6); // ratio, share, slip, exponent, across, loss
      values << 1, 0.5, 1e-4, b, 1, 1;
      const auto y = Predictor(nominal, readings, {&all[0]})(values);
      return std::pair{std::exp((*y)[0]), std::exp((*y)[1])}; // Hz, damping
    };
    const auto [stuck, least] = answer(1e-7);
    const double expected = 4 / std::numbers::pi * b / (2 + b);
    double mean = 0;
    for (const double acceleration : {15., 30., 60.}) {
      const auto [hertz, zeta] = answer(acceleration);
      ASSERT_LT(hertz, stuck * (1 - 1e-6)) << "it softens";
      const double own = (zeta - least) / (1 - hertz / stuck);
      EXPECT_NEAR(own / expected, 1, 0.1) << b << ", " << acceleration;
      mean += own / expected / 3;
    }
    EXPECT_NEAR(mean, 1, 0.04) << b;
  }
}

// The Brake-Reuss beam (cases/lap_levels says whose measurement it is): damping that
// grows fourfold is friction in the lap, not damping of everything. By Masing's rule that softens,
// too: -0.5 % of frequency over the levels, while the measured one falls by 0.3 % and rises again.
TEST(DrivenModes, damping_that_grows_over_the_level_is_friction_in_the_lap) {
  const CaseFile file = read_case(lap_folder + "lap_levels.yaml");
  const Measured m = read_measured(lap_folder + "measured.yaml");
  const Diagnosis d = diagnose(file.data, {.data = m, .responses = {}}, {});
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "joint_friction") << d.headline;
  EXPECT_EQ(d.effects.front().place, "caps.lap") << d.headline;
  EXPECT_EQ(d.verdict, Verdict::identified) << d.headline;
  std::vector<const ComparedReading*> frequencies;
  for (const ComparedReading& r : d.readings) {
    if (r.kind == ReadingKind::frequency) frequencies.push_back(&r);
    if (r.kind == ReadingKind::damping) {
      EXPECT_NEAR(r.best / r.measured, 1, 0.15) << r.name;
    }
  }
  ASSERT_EQ(frequencies.size(), 8U);
  EXPECT_NEAR(frequencies.back()->best / frequencies.front()->best, 0.995, 0.001);
  EXPECT_GT(frequencies.back()->measured, frequencies.front()->measured);
  const auto grows = std::find_if(d.trends.begin(), d.trends.end(), [](const LevelTrend& t) {
    return t.quantity.starts_with("damping");
  });
  ASSERT_NE(grows, d.trends.end());
  EXPECT_NEAR(grows->slope, 0.52, 0.06);
  EXPECT_NEAR(grows->best, grows->slope, 0.06);
}

} // namespace
} // namespace plica
