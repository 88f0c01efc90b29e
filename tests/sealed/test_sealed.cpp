// The sealed suite's own solvers against closed forms and against each other.
#include "changes/changes.hpp"
#include "changes/line_model.hpp"
#include "changes/line_structures.hpp"
#include "response.hpp"
#include "specimen.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

using namespace sealed;
using std::numbers::pi;

namespace {

constexpr double w0 = 2 * pi * 100, zeta = 0.02;

// One mass on one spring on a table that moves along x, with a nonlinear spring beside.
Bench oscillator(const NonlinearSpring& spring) {
  Bench bench;
  Structure& s = bench.test;
  s.K = MatrixXd::Constant(1, 1, w0 * w0);
  s.M = MatrixXd::Identity(1, 1);
  s.R = MatrixXd::Zero(1, 6);
  s.R(0, 0) = 1;
  s.nonlinear = {spring};
  bench.zeta = VectorXd::Constant(1, zeta);
  bench.table[0] = {1, 0, 0, 0, 0, 0};
  MatrixXd rows = MatrixXd::Zero(3, 1);
  rows(0, 0) = 1;
  bench.probes.push_back({.name = "mass", .rows = rows, .reading = Matrix3d::Identity()});
  return bench;
}

Assembly as_drawn(const Bench& bench) {
  return {modes_of(bench.test), bench.zeta};
}

// |x| of the first harmonic by bisection: x |w0^2 + softer(x) - w^2 + i (2 zeta w0 w + loss(x))| =
// a.
template <class Added> double amplitude(double w, double a, const Added& added) {
  double low = 0, high = 1;
  for (int i = 0; i < 200; ++i) {
    const double x = (low + high) / 2;
    const std::complex<double> z =
        std::complex<double>(w0 * w0 - w * w, 2 * zeta * w0 * w) + added(x);
    (x * std::abs(z) > a ? high : low) = x;
  }
  return low;
}

double relative_motion(const Eigen::MatrixXcd& response, double w) {
  return std::abs((response(0, 0) - 1.) / (w * w)); // acceleration of the mass less the table's
}

} // namespace

TEST(SealedSuite, hardening_in_time_follows_duffing) {
  NonlinearSpring spring{.law = Law::cubic, .row = VectorXd::Ones(1)};
  const double a = 1, linear = a / (2 * zeta * w0 * w0);
  spring.stiffness = 0.02 * w0 * w0 / (linear * linear);
  spring.slip = 0.01 * linear;
  const Bench bench = oscillator(spring);
  for (const double f : {90., 97., 104.}) { // one solution at each
    const double w = 2 * pi * f;
    const double expected =
        amplitude(w, a, [&](double x) { return 0.75 * spring.stiffness * x * x; });
    const auto response =
        nonlinear_response(bench, as_drawn(bench), 0, a, VectorXd::Constant(1, f));
    EXPECT_NEAR(relative_motion(response, w) / expected, 1, 0.01) << f;
  }
}

TEST(SealedSuite, a_joint_far_beyond_its_slip_is_coulomb_friction) {
  NonlinearSpring spring{.law = Law::bouc_wen, .row = VectorXd::Ones(1)};
  spring.stiffness = 0.3 * w0 * w0;
  const double a = 1;
  spring.slip = 0.002 * a / (2 * zeta * w0 * w0);
  const Bench bench = oscillator(spring);
  const double force = spring.stiffness * spring.slip;
  for (const double f : {75., 83.6, 95.}) {
    const double w = 2 * pi * f;
    const double expected = amplitude(w, a, [&](double x) {
      return std::complex<double>(-spring.stiffness, 4 * force / (pi * x));
    });
    const auto response =
        nonlinear_response(bench, as_drawn(bench), 0, a, VectorXd::Constant(1, f));
    EXPECT_NEAR(relative_motion(response, w) / expected, 1, 0.05)
        << f; // steps are coarser than slips
  }
}

TEST(SealedSuite, a_beam_of_the_suite_has_the_stiffness_of_a_beam) {
  Structure s;
  s.R = MatrixXd(0, 6);
  s.K = s.M = MatrixXd(0, 0);
  add_unknowns(s, 12);
  const MatrixXd one = MatrixXd::Identity(12, 12);
  const double L = 0.5, EI = 7;
  add_beam(s, one.topRows(6), one.bottomRows(6), L, 1e3, EI, 3);
  const MatrixXd free = s.K.bottomRightCorner(6, 6);
  VectorXd load = VectorXd::Zero(6);
  load[0] = 1;
  const VectorXd u = free.ldlt().solve(load);
  EXPECT_NEAR(u[0], L * L * L / (3 * EI), 1e-12);
  EXPECT_NEAR(u[5], -L * L / (2 * EI), 1e-12); // dx/dy = -rz
  VectorXd turn = VectorXd::Zero(12);          // a rigid rotation about z
  turn[5] = turn[11] = 1;
  turn[6] = -L;
  EXPECT_LT((s.K * turn).norm(), 1e-9);
}

TEST(SealedSuite, has_the_promised_specimens) {
  const Suite suite = plan_suite(1, false);
  std::map<std::string, int> kinds, classes;
  std::map<std::string, std::set<std::string>> strengths;
  int outside = 0, beams = 0;
  for (const Specimen& s : suite.specimens) {
    ++kinds[s.kind];
    if (s.kind == "effect") {
      ++classes[s.cls];
      strengths[s.cls].insert(s.strength);
      EXPECT_FALSE(s.effects.empty()) << s.cls;
    }
    if (s.kind == "pair") {
      EXPECT_EQ(s.effects.size(), 2u) << s.cls;
    }
    outside += s.cls == "clearance" || s.cls == "hardening" || s.cls == "absorber";
    beams += s.structure != "short_bellows";
  }
  EXPECT_GE(suite.specimens.size(), 250u);
  EXPECT_EQ(kinds["none"], 100);
  EXPECT_GE(kinds["stranger"], 40);
  EXPECT_EQ(2 * outside, kinds["stranger"]);
  EXPECT_EQ(kinds["pair"], 24);
  EXPECT_GE(beams, 60);
  for (const std::string& name : effect_names()) {
    EXPECT_GE(classes[name], 8) << name;
    EXPECT_EQ(strengths[name].size(), 3u) << name;
  }
}

TEST(SealedSuite, sixty_strangers_are_outside_of_the_library) {
  const Suite suite = plan_sixty_strangers(1);
  EXPECT_EQ(suite.specimens.size(), 60u);
  std::map<std::string, int> classes;
  for (const Specimen& s : suite.specimens) {
    EXPECT_EQ(s.kind, "stranger");
    ++classes[s.cls];
  }
  EXPECT_EQ(classes,
            (std::map<std::string, int>{{"absorber", 18}, {"clearance", 21}, {"hardening", 21}}));
}

// Euler's beam, 100 times as long as deep (Blevins 1979); lambda^2 of the first three modes clamped
// and free.
TEST(SealedChanges, a_line_bends_as_a_slender_beam_does) {
  const double EI = steel::E * 1e-8 / 12, mass = steel::rho * 1e-4; // 10 x 10 mm, 1 m
  const SectionAt slender = [&](double) {
    return LineSection{.EI = EI, .GA = 1e9, .mass = mass, .inertia = mass * 1e-4 / 12};
  };
  const double unit = std::sqrt(EI / mass) / (2 * pi);
  LineModel clamped;
  clamped.add_stretch(0, 1, 10, slender);
  clamped.fix(0, true, true);
  const FoundModes of_clamped = clamped.modes(3, {0.5, 1});
  const auto f = of_clamped.frequencies;
  constexpr double half_way = 0.339523; // of the motion of the tip, first mode
  EXPECT_NEAR(of_clamped.shapes[0][0] / of_clamped.shapes[0][1], half_way, 1e-3);
  LineModel free;
  free.add_stretch(0, 0.4, 4, slender);
  free.add_stretch(0.4, 1, 6, slender);
  const auto g = free.modes(4, {}).frequencies;
  const double clamped_roots[] = {1.87510407, 4.69409113}, free_roots[] = {4.73004074, 7.85320462};
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(f[k], unit * clamped_roots[k] * clamped_roots[k], 1e-3 * f[k]);
    EXPECT_NEAR(g[k + 2], unit * free_roots[k] * free_roots[k], 1e-3 * g[k + 2]);
  }
}

// NAFEMS FV16, square, 10 m: after Barton 0.421, 1.029, 2.582, 3.306, 3.753 Hz, accepted within 2
// %.
TEST(SealedChanges, a_plate_by_ritz_is_the_clamped_plate_of_nafems) {
  const auto plate =
      clamped_plate({.length = 10, .width = 10, .thickness = 0.05, .sensor_mass = 0});
  const auto f = plate->frequencies({}, {});
  const double published[] = {0.421, 1.029, 2.582, 3.306, 3.753};
  const double as_steel = std::sqrt(steel::E / 200e9 * 8000 / steel::rho);
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(f[k], published[k] * as_steel, 0.02 * f[k]) << "mode " << k + 1;
}

// What the model leaves out has no part in it where there is none of it, and a change of nothing
// changes nothing.
TEST(SealedChanges, mechanisms_and_changes_begin_at_nothing) {
  for (const auto& structure : changed_structures()) {
    if (structure->name() == "bellows") continue; // minutes
    const auto right = structure->frequencies({}, {});
    ASSERT_EQ(std::size_t(right.size()), structure->labels().size());
    for (const std::string& mechanism : mechanisms) {
      const auto barely =
          structure->frequencies({.name = mechanism, .amount = 1e-7, .seed = 3}, {});
      const auto more = structure->frequencies({.name = mechanism, .amount = 1e-2, .seed = 3}, {});
      EXPECT_LT((barely - right).cwiseQuotient(right).cwiseAbs().maxCoeff(), 1e-4)
          << structure->name() << ", " << mechanism;
      EXPECT_GT((more - right).norm(), (barely - right).norm())
          << structure->name() << ", " << mechanism;
    }
    Draws draws(5, structure->name());
    for (int i = 0; i < 12; ++i) {
      const Change change = structure->draw_change(draws);
      Effect least = change.effect;
      least.value[change.size] = change.value(change.smallest);
      const auto changed = structure->frequencies({}, least);
      EXPECT_LT((changed - right).cwiseQuotient(right).cwiseAbs().maxCoeff(), 3e-3)
          << structure->name() << ", " << change.effect.name << " at " << change.effect.place;
    }
  }
}

namespace {

using nlohmann::json;

// What the scorer says of one diagnosis of a structure in which `effect` is the change.
json marks_of(const std::string& structure, const json& effect, const json& position,
              const json& said) {
  const plica::test::TemporaryFolder folder("marks");
  const std::filesystem::path truth = folder.path / "truth", out = folder.path / "out";
  std::filesystem::create_directories(truth);
  std::filesystem::create_directories(out / "1");
  std::ofstream(truth / "1.json") << json{{"id", "1"},
                                          {"kind", "effect"},
                                          {"class", effect["name"]},
                                          {"structure", structure},
                                          {"mechanism", "theory"},
                                          {"strength", ""},
                                          {"detectable", true},
                                          {"ratio", 3},
                                          {"position", position},
                                          {"effects", json::array({effect})}};
  std::ofstream(out / "1" / "diagnosis.json")
      << json{{"verdict", "identified"}, {"effects", json::array({said})}};
  EXPECT_TRUE(score_changes(truth, out));
  json score;
  std::ifstream(out / "score.json") >> score;
  return score["specimens"][0];
}

} // namespace

// A mass on the plate is right where its interval, or 5 % of the plate, holds it or its mirror
// image across the middle line.
TEST(SealedChanges, a_mass_on_the_plate_is_marked_by_its_place) {
  const json truth{{"name", "added_mass"},
                   {"place", "plate"},
                   {"value", {{"mass", 0.02}, {"at", 0.2}, {"across", 0.03}}}};
  const auto is_right = [&](double at, double across, double within) {
    const json marks = marks_of("plate", truth, {0.2, 0.03},
                                {{"name", "added_mass"},
                                 {"place", "plate"},
                                 {"value", {{"mass", 0.02}, {"at", at}, {"across", across}}},
                                 {"interval",
                                  {{"mass", {0.01, 0.03}},
                                   {"at", {at - within, at + within}},
                                   {"across", {across - within, across + within}}}}});
    EXPECT_EQ(marks["wrong"], !marks["best_right"]);
    return bool(marks["best_right"]);
  };
  EXPECT_TRUE(is_right(0.2, 0.03, 1e-3));
  EXPECT_FALSE(is_right(0.2, 0.07, 1e-3));
  EXPECT_TRUE(is_right(0.2, 0.07, 0.05)) << "within its interval";
  EXPECT_FALSE(is_right(0.05, 0.03, 1e-3));
  double width = 0;
  for (const auto& structure : changed_structures())
    if (structure->name() == "plate") width = structure->mirrored({0, 0})[1];
  EXPECT_TRUE(is_right(0.2, width - 0.03, 1e-3)) << "its mirror image";
}

// In the frame a heavier floor answers as a softer storey does; a sensor that is turned there does
// not.
TEST(SealedChanges, what_answers_alike_in_the_frame_is_a_mass_or_a_storey) {
  const json storey{
      {"name", "local_damage"}, {"place", "legs.stretch[4]"}, {"value", {{"loss", 0.2}}}};
  const auto is_right = [&](const char* name, const char* place) {
    return bool(
        marks_of("frame", storey, json::array(), {{"name", name}, {"place", place}})["best_right"]);
  };
  EXPECT_TRUE(is_right("local_damage", "legs.stretch[4]"));
  EXPECT_FALSE(is_right("local_damage", "legs.stretch[3]"));
  EXPECT_TRUE(is_right("component_mass", "floor1"));
  EXPECT_TRUE(is_right("added_mass", "sensor.floor1"));
  EXPECT_FALSE(is_right("component_mass", "floor2"));
  EXPECT_FALSE(is_right("rotated_sensor", "sensor.floor1"));
  EXPECT_FALSE(is_right("sensor_gain", "sensor.floor1"));
}
