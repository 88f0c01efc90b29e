// Friction in cases: joints of connectors, interlocks, walls and mounts, at rest, slowly loaded,
// and at several levels of excitation.
#include "compare/fit/fit.hpp"
#include "run/analyses/jointed_model.hpp"
#include "run/analyses/run.hpp"
#include "run/routes/ply_slip.hpp"
#include "solve/backbone.hpp"
#include "tests/bellows_case.hpp"
#include "tests/fit_parameter.hpp"
#include "tests/sliding_chain.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

// 0.5 kg between two elements, each 20 kN/m with a slider of 60 kN/m and 3 N beside it, along y.
Case mass_between_sliders() {
  Case data = test::sliding_chain();
  data.sensors = {{.name = "mid", .at = {0, 0.1, 0}}};
  data.analyses.error_bars = false;
  data.analyses.modes = Modes{.count = 3};
  data.analyses.damping.modal = 0.01;
  Levels levels;
  levels.bases = {1};
  levels.levels = {0.01, 2, 8, 2000};
  levels.band = {20, 120};
  levels.harmonics = 7;
  data.analyses.levels = levels;
  return data;
}

const double stuck_hertz = std::sqrt(2 * 8e4 / 0.5) / (2 * pi);
const double slipping_hertz = std::sqrt(2 * 2e4 / 0.5) / (2 * pi);

const LevelPeak& first_peak(const LevelCurve& curve, int channel) {
  for (const LevelPeak& p : curve.peaks_up)
    if (p.channel == channel) return p;
  throw std::runtime_error("no peak");
}

// Both elements move alike, so the middle is one mass on one spring with one slider.
TEST(Levels, go_from_the_stuck_to_the_slipping_frequency) {
  const Results r = test::run_silently(mass_between_sliders());
  EXPECT_NEAR(r.modes.at(0).frequency / stuck_hertz, 1, 1e-6); // small motion sticks
  EXPECT_NEAR(r.statics->k_axial / 1e4, 1, 1e-6);              // a test rig slips
  EXPECT_NEAR(r.slipping->k_axial_stuck / 4e4, 1, 1e-6);
  ASSERT_EQ(r.level_responses.size(), 1);
  const LevelResponses& responses = r.level_responses[0];
  EXPECT_EQ(responses.joints, 2);
  ASSERT_EQ(responses.curves.size(), 4);
  for (const LevelCurve& c : responses.curves) EXPECT_TRUE(c.complete) << c.level << c.reason;
  EXPECT_EQ(responses.channels[std::size_t(responses.strongest)].second, "y");
  const LevelPeak& low = first_peak(responses.curves[0], responses.strongest);
  const LevelPeak& high = first_peak(responses.curves[3], responses.strongest);
  EXPECT_NEAR(low.frequency / stuck_hertz, 1, 1e-3);
  EXPECT_NEAR(high.frequency / slipping_hertz, 1, 5e-3);
  // Half way there, damping by energy is that of the closed form: at amplitude A of the joints
  // zeta = h / (2 (k + k_eq)) and that of the mode.
  const LevelCurve& middle = responses.curves[1];
  const LevelPeak& peak = first_peak(middle, responses.strongest);
  EXPECT_LT(peak.frequency, 0.99 * stuck_hertz);
  EXPECT_GT(peak.energy_damping, 0.05);
  double taken = 0;
  for (const JointMotion& j : middle.joints) {
    taken += j.energy;
    EXPECT_NEAR(j.energy / loop_energy({.sliders = {{6e4, 3}}}, j.motion), 1, 0.05) << j.joint;
  }
  EXPECT_GT(taken, 0);
  for (const RefereeCheck& check : responses.referee) {
    EXPECT_TRUE(check.settled);
    EXPECT_LT(check.difference, 5e-3) << check.level << " at " << check.frequency;
  }
  ASSERT_EQ(responses.backbones.size(), 1);
  const BackboneCurve& b = responses.backbones[0];
  EXPECT_TRUE(b.complete) << b.reason;
  EXPECT_NEAR(b.frequency[0] / stuck_hertz, 1, 1e-6);
  EXPECT_NEAR(b.damping[0], 0.01, 1e-5); // as the case says for small motion
  EXPECT_NEAR(b.frequency[b.frequency.size() - 1] / slipping_hertz, 1, 1e-2);
}

// Slowly from rest: k = 40 kN/m until the sliders give way at 0.1 mm, beyond 6 N / 2 + 10 kN/m x.
TEST(Levels, of_a_slow_stroke_are_the_closed_form) {
  const Results r = test::run_silently(mass_between_sliders());
  ASSERT_FALSE(r.strokes.empty());
  const StrokeCurve& axial = r.strokes[0];
  EXPECT_EQ(axial.direction, "axial");
  for (const auto& [d, force] : axial.points) {
    const double expected = std::abs(d) < 1e-4 ? 4e4 * d : std::copysign(3, d) + 1e4 * d;
    EXPECT_NEAR(force, expected, 1e-6 * (3 + std::abs(expected))) << d;
  }
}

// Friction knows no scale of its own: twice the slip forces at twice the levels move alike.
TEST(Levels, scale_with_the_slip_forces) {
  Case data = mass_between_sliders();
  data.analyses.levels->levels = {2, 6};
  const LevelResponses one = test::run_silently(data).level_responses[0];
  std::get<ConnectorChain>(data.parts[0].body).friction->axial->sliders[0].slip_force *= 2;
  data.analyses.levels->levels = {4, 12};
  const LevelResponses two = test::run_silently(data).level_responses[0];
  for (std::size_t k = 0; k < 2; ++k) {
    const LevelPeak &a = first_peak(one.curves[k], one.strongest),
                    &b = first_peak(two.curves[k], two.strongest);
    EXPECT_NEAR(a.frequency / b.frequency, 1, 1e-6);
    EXPECT_NEAR(a.amplitude / b.amplitude, 1, 1e-6);
    EXPECT_NEAR(a.energy_damping / b.energy_damping, 1, 1e-6);
  }
}

TEST(Levels, by_equivalent_linearisation_are_near) {
  Case data = mass_between_sliders();
  data.analyses.levels->levels = {2, 4, 8};
  const LevelResponses full = test::run_silently(data).level_responses[0];
  ASSERT_EQ(full.linearised.size(), 3);
  for (const LinearisedError& e : full.linearised) {
    EXPECT_LT(std::abs(e.frequency), 0.02) << e.level;
    EXPECT_LT(std::abs(e.amplitude), 0.05) << e.level;
  }
  data.analyses.levels->method = JointMethod::describing_function;
  const LevelResponses fast = test::run_silently(data).level_responses[0];
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(first_peak(fast.curves[k], fast.strongest).frequency /
                        first_peak(full.curves[k], full.strongest).frequency -
                    1,
                full.linearised[k].frequency, 1e-9);
}

// A tabulated spring is the same joint whether it is a connector's or stands in a law.
TEST(Levels, bend_with_a_tabulated_connector) {
  Case data = mass_between_sliders();
  ConnectorChain& chain = std::get<ConnectorChain>(data.parts[0].body);
  chain.friction.reset();
  chain.spring.axial = 0;
  chain.spring.axial_curve = {{-2e-3, -90}, {-1e-3, -20}, {0, 0}, {1e-3, 20}, {2e-3, 90}};
  data.analyses.levels->levels = {0.5, 20};
  data.analyses.levels->backbones = 0;
  const LevelResponses curve = test::run_silently(data).level_responses[0];
  chain.spring.axial_curve.clear();
  chain.spring.axial = 1e4;

  chain.friction.emplace().axial.emplace().curve = {
      {-2e-3, -70}, {-1e-3, -10}, {0, 0}, {1e-3, 10}, {2e-3, 70}};
  const LevelResponses law = test::run_silently(data).level_responses[0];
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(first_peak(curve.curves[k], curve.strongest).frequency /
                    first_peak(law.curves[k], law.strongest).frequency,
                1, 1e-6);
  EXPECT_GT(first_peak(curve.curves[1], curve.strongest).frequency,
            1.1 * first_peak(curve.curves[0], curve.strongest).frequency);
}

// Measured at levels that the program made itself, with two of them held out: the sliders are
// found again from another start.
TEST(Levels, give_the_sliders_back) {
  Case data = mass_between_sliders();
  data.analyses.levels->levels = {1, 2, 3, 4, 6, 8};
  data.analyses.levels->method = JointMethod::describing_function;
  TestData test;
  test.data.specimen = data.name;
  MeasuredPeaks peaks;
  peaks.sensor = "mid";
  const LevelResponses made = test::run_silently(data).level_responses[0];
  for (const LevelCurve& c : made.curves) {
    peaks.level.push_back(c.level);
    peaks.frequency.push_back(first_peak(c, made.strongest).frequency);
  }
  peaks.sigma = 0.2;
  test.data.peaks = {peaks};
  auto& slider = std::get<ConnectorChain>(data.parts[0].body).friction->axial->sliders[0];
  slider = {4e4, 5};
  FitRequest request;
  const std::string path = "parts.chain.friction.axial.sliders[0].";
  request.parameters = {test::fit_parameter(path + "stiffness", 1e4, 2e5, true),
                        test::fit_parameter(path + "slip_force", 0.5, 20, true)};
  request.targets = {{.quantity = "peaks[0]"}};
  request.hold_out_levels = {3, 6};
  const FitResult fit = fit_case(data, request, test, {});
  EXPECT_NEAR(fit.parameters[0].value / 6e4, 1, 1e-2);
  EXPECT_NEAR(fit.parameters[1].value / 3, 1, 1e-2);
  ASSERT_TRUE(fit.parameters[0].sigma);
  int held = 0;
  for (const FittedTarget& t : fit.targets) {
    held += t.held_out;
    EXPECT_NEAR(t.value / t.measured, 1, 5e-3) << t.quantity;
  }
  EXPECT_EQ(held, 2);
  EXPECT_EQ(fit.targets.size(), 6);
}

// A bellows of six convolutions, its ends held.
Case small_bellows() {
  Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = 0.065;
  MeridianSection convolutions;
  convolutions.count = 12;
  convolutions.height = 0.008;
  convolutions.pitch = 0.0066;
  bellows.profile = {convolutions};
  bellows.wall = {.plies = {0.00025, 0.00025}, .bond = 0};
  bellows.mesh = {.around = 36, .arc = 3, .wall = 4};
  Case data;
  data.name = "bellows";
  data.materials["steel"] = {.E = 193e9, .nu = 0.3, .rho = 8000};
  data.parts.push_back({"bellows", bellows});
  data.caps = {{.name = "left", .of = {"bellows.left"}},
               {.name = "right", .of = {"bellows.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.sensors = {{.name = "mid", .at = {0, 0.0396, 0.065}}};
  data.analyses.error_bars = false;
  data.analyses.modes = Modes{.count = 6};
  data.analyses.damping.modal = 0.01;
  Levels levels;
  levels.bases = {1, 0};
  levels.levels = {1};
  levels.band = {100, 2500};
  data.analyses.levels = levels;
  return data;
}

double first(const Results& results, const std::string& shape) {
  for (const ModeResult& m : results.modes)
    if (m.shape == shape) return m.frequency;
  return 0;
}

// The reduced model of the joints with all of them stuck against the shells with springs in their
// place, and plies that stick against one solid wall.
TEST(PlySlip, sticks_as_one_wall_and_slips_as_two) {
  Case data = small_bellows();
  auto& wall = std::get<Bellows>(data.parts[0].body).wall;
  const double two = test::run_silently([&] {
                       Case c = data;
                       c.analyses.levels.reset();
                       return c;
                     }())
                         .statics->k_axial;
  PlySlip slip;
  slip.slip_force = 100;
  slip.segments = 11;
  wall.slip = slip;
  const Results r = test::run_silently(data);
  EXPECT_NEAR(r.statics->k_axial / two, 1, 1e-9);
  data.analyses.levels.reset();
  wall.slip.reset();
  wall.bond = 1;
  const Results solid = test::run_silently(data);
  EXPECT_NEAR(r.slipping->k_axial_stuck / solid.statics->k_axial, 1, 1e-9);
  EXPECT_NEAR(first(r, "axial") / first(solid, "axial"), 1, 1e-9);
  // 1 m/s2 moves the joints by less than their smallest slip distance.
  for (const LevelResponses& responses : r.level_responses) {
    const double expected = first(solid, responses.excitation == "y" ? "axial" : "transverse");
    EXPECT_NEAR(first_peak(responses.curves[0], responses.strongest).frequency / expected, 1, 0.03)
        << responses.excitation;
  }
}

TEST(InterlockFriction, reduces_to_the_modes_of_the_stuck_shells) {
  Case data = small_bellows();
  Interlock liner;
  liner.along = "bellows";
  liner.attachment = Attachment::stations;
  liner.stations = 7;
  liner.mass = 0.3;
  liner.radius = 0.06;
  liner.friction.emplace();
  liner.friction->axial.emplace().sliders = {{2e5, 50}};
  liner.friction->bending.emplace().sliders = {{360, 1.5}};
  data.parts.push_back({"interlock", liner});
  const Results stuck = test::run_silently(data); // springs in place of the joints
  const BuiltCase slipping = slipping_case(data);
  Timing timing;
  const StageListener quiet = [](const std::string&) {};
  const auto route = choose_route(slipping, data.analyses, quiet, timing);
  const JointedModel model = jointed_model(data, slipping, *route);
  for (int excitation : {0, 1}) {
    const ExcitedPart part = excited_part(model, excitation);
    EXPECT_EQ(part.joints.size(), 8);
    const double lowest = std::sqrt(stuck_modes(part.structure).lambda[0]) / (2 * pi);
    EXPECT_NEAR(lowest / first(stuck, excitation == 0 ? "axial" : "transverse"), 1, 2e-3);
  }
}

// A liner between the caps in four slipping pieces: its nodes are interface nodes of the
// Craig-Bampton reduction, and the answer is that of the shells.
TEST(InterlockFriction, is_the_same_on_a_superelement) {
  Case data = small_bellows();
  Interlock liner;
  liner.along = "bellows";
  liner.attachment = Attachment::caps;
  liner.EA = 2e4;
  liner.EI = liner.GJ = 40;
  liner.mass = 0.3;
  liner.radius = 0.06;
  liner.friction.emplace();
  liner.friction->segments = 4;
  liner.friction->axial.emplace().sliders = {{4e5, 2}};
  data.parts.push_back({"interlock", liner});
  Levels& levels = *data.analyses.levels;
  levels.bases = {1};
  levels.levels = {0.5, 20};
  levels.band = {100, 1000};
  levels.backbones = levels.referee = 0;
  data.sensors = {{.name = "middle", .at = {0, 0.0396, 0.065}}};
  const Results shells = test::run_silently(data);
  data.analyses.reduction = SuperelementsInRun{.cutoff = 6000};
  const Results reduced = test::run_silently(data);
  ASSERT_TRUE(reduced.reduced);
  const LevelResponses &a = shells.level_responses[0], &b = reduced.level_responses[0];
  EXPECT_EQ(a.joints, b.joints);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_FALSE(a.curves[k].peaks_up.empty());
    const LevelPeak &one = first_peak(a.curves[k], a.strongest),
                    &other = first_peak(b.curves[k], a.strongest);
    EXPECT_NEAR(one.frequency / other.frequency, 1, 2e-3) << k;
    EXPECT_NEAR(one.amplitude / other.amplitude, 1, 1e-2) << k;
  }
}

} // namespace
} // namespace plica
