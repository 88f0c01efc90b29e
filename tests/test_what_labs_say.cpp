// What a lab may say of its test besides the numbers: what the scale saw, what a static stiffness
// is, how well levels are known, and between which ends a rig pulled.
#include "compare/compare.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/predict/predictor.hpp"
#include "diagnose/readings/readings.hpp"
#include "diagnose/weigh/level_errors.hpp"
#include "io/files/files.hpp"
#include "io/input/measured_file.hpp"
#include "run/analyses/run.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plica::test {
namespace {

Measured measured_of(const std::string& text) {
  const TemporaryFolder folder("said");
  write_whole(folder.path / "measured.yaml", "specimen: a\n" + text);
  return read_measured((folder.path / "measured.yaml").string());
}

std::string problem_of(const std::string& text) {
  return error_of([&] { measured_of(text); });
}

TEST(WhatLabsSay, sensors_that_were_not_weighed_come_besides) {
  const std::string sensors = "sensors:\n  - {name: s1, at: [0, 0, 0], mass: 5 g}\n"
                              "  - {name: s2, at: [0, 1, 0], mass: 3 g}\n";
  EXPECT_NEAR(measured_of(sensors + "mass: {value: 1.2 kg, sigma: 2 g}\n").weighings.at(0).value,
              1.2, 1e-12);
  EXPECT_NEAR(measured_of(sensors + "mass: {value: 1.2 kg, sigma: 2 g, without_sensors: true}\n")
                  .weighings.at(0)
                  .value,
              1.208, 1e-12);
  EXPECT_NE(problem_of("mass: {value: 1.2 kg, without_sensors: true}\n")
                .find("none on the part has a mass"),
            std::string::npos);
}

TEST(WhatLabsSay, every_weighing_says_whether_it_saw_the_sensors) {
  const std::string sensors = "sensors:\n  - {name: s1, at: [0, 0, 0], mass: 5 g}\n",
                    mass = "mass:\n"
                           "  - {value: 1.2 kg, without_sensors: true}\n"
                           "  - {value: 1.3 kg}\n"
                           "  - {value: 1.4 kg, repeats: [1.39 kg, 1.41 kg], "
                           "without_sensors: true}\n";
  const Measured m = measured_of(sensors + mass);
  ASSERT_EQ(m.weighings.size(), 3U);
  EXPECT_NEAR(m.weighings[0].value, 1.205, 1e-12);
  EXPECT_NEAR(m.weighings[1].value, 1.3, 1e-12);
  EXPECT_NEAR(m.weighings[2].value, 1.405, 1e-12);
  EXPECT_NEAR(*m.weighings[2].sigma, 0.01 * std::sqrt(2), 1e-12);
  for (const char* key : {"mass[0].without_sensors", "mass[2].without_sensors"})
    EXPECT_NE(problem_of(mass).find(key), std::string::npos) << problem_of(mass);
}

TEST(WhatLabsSay, a_run_stands_beside_every_weighing_of_the_specimen_as_drawn) {
  Results results;
  results.model.mass = 1.25;
  const std::vector<MeasuredComparison> rows =
      compare(results, measured_of("states:\n"
                                   "  - {name: delivered, baseline: true}\n"
                                   "  - {name: mounted, baseline: true}\n"
                                   "  - {name: after}\n"
                                   "mass:\n"
                                   "  - {value: 1.2 kg, sigma: 1 g, state: delivered}\n"
                                   "  - {value: 1.3 kg, state: after}\n"
                                   "  - {value: 1.201 kg, state: mounted}\n"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].entry, "mass[0]");
  EXPECT_EQ(rows[0].sigma, 0.001);
  EXPECT_EQ(rows[1].entry, "mass[2]");
  EXPECT_EQ(rows[1].measured, 1.201);
  EXPECT_EQ(rows[1].computed, 1.25);
  EXPECT_EQ(compare(results, measured_of("mass: {value: 1.2 kg}\n")).at(0).entry, "mass");
}

// 3 N/mm up to 1 mm, 1 N/mm beyond it: over 2 mm a secant of 2 and a tangent of 1.
TEST(WhatLabsSay, a_static_stiffness_is_a_secant_or_a_tangent) {
  Results results;
  results.statics.emplace();
  results.strokes = {{"axial", {{0, 0}, {1e-3, 3}, {3e-3, 5}}}};
  const std::string entry = "  - {direction: axial, value: 2 N/mm, stroke: 2 mm";
  const auto computed = [&](const std::string& slope) {
    return compare(results, measured_of("static:\n" + entry + slope + "}\n")).at(0).computed;
  };
  EXPECT_NEAR(computed(""), 2000, 1e-6);
  EXPECT_NEAR(computed(", slope: secant"), 2000, 1e-6);
  EXPECT_NEAR(computed(", slope: tangent"), 1000, 1e-6);
  EXPECT_NE(problem_of("static: [{direction: axial, value: 1 N/m, slope: tangent}]\n")
                .find("which is not stated"),
            std::string::npos);
}

// Frequencies fall by 2 % and damping doubles over a factor e of the level, known within 5 %.
TEST(WhatLabsSay, an_error_of_the_level_shifts_what_follows_the_level) {
  TestReadings test;
  test.level_sigma = 0.05;
  std::vector<int> series;
  for (int run = 0; run < 3; ++run) {
    TestRun own;
    own.level = std::exp(run);
    test.runs.push_back(own);
    const auto add = [&](double log_value, int number) {
      Reading r;
      r.run = run;
      r.log_value = log_value;
      r.sigma = 0.01;
      test.readings.push_back(r);
      series.push_back(number);
    };
    add(5 - 0.02 * run, 0);
    add(-4 + std::log(2.) * run, 1);
    add(1, 2); // follows nothing
  }
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(9, 9);
  add_error_of_levels(test, series, S);
  const double f = -0.02 * 0.05, zeta = std::log(2.) * 0.05;
  EXPECT_NEAR(S(0, 0), f * f, 1e-12);
  EXPECT_NEAR(S(1, 1), zeta * zeta, 1e-12);
  EXPECT_NEAR(S(0, 1), f * zeta, 1e-12);
  EXPECT_NEAR(S(2, 2), 0, 1e-20);
  EXPECT_NEAR(S(0, 3), 0, 1e-20) << "of another run";
  EXPECT_NEAR(measured_of("level_sigma: 3 %\n").level_sigma, 0.03, 1e-12);
}

// Two beams and a lap whose springs lie between them, both far ends held.
Case lap_between_held_ends() {
  Case c;
  c.name = "a";
  c.materials["steel"] = {.E = 200e9, .nu = 0.3, .rho = 7850};
  for (const auto& [name, from] : {std::pair{"first", 0.}, {"second", 0.3}}) {
    BeamPart beam;
    beam.points = {{0, from, 0}, {0, from + 0.3, 0}};
    beam.elements = 4;
    beam.up = {0, 0, 1};
    beam.section.shape = BeamShape::rectangle;
    beam.section.material = "steel";
    beam.section.width = 0.02;
    beam.section.depth = 0.01;
    c.parts.push_back({name, beam});
  }
  Cap left, lap, right;
  left.name = "left";
  left.of = {"first.start"};
  lap.name = "lap";
  lap.of = {"first.end", "second.start"};
  lap.stiffness = Sextuple{5e7, 8e7, 5e7, 2e4, 2e4, 2e4};
  right.name = "right";
  right.of = {"second.end"};
  c.caps = {left, lap, right};
  c.mount = {{.cap = "left"}, {.cap = "right"}};
  c.analyses.modes = Modes{.count = 4};
  c.analyses.damping.modal = 0.01;
  return c;
}

TEST(WhatLabsSay, a_rig_pulls_at_the_ends_that_are_mounted) {
  Case c = lap_between_held_ends();
  const double exact = 1 / (0.6 / (200e9 * 0.02 * 0.01) + 1 / 8e7);
  const auto quietly = [](const std::string&) {};
  EXPECT_FALSE(run(c, quietly).statics) << "of three caps only where it is asked for";
  c.analyses.statics = true;
  const Results results = run(c, quietly);
  ASSERT_TRUE(results.statics);
  EXPECT_NEAR(results.statics->k_axial / exact, 1, 1e-9);
  const Measured m = measured_of("static: [{direction: axial, value: 30 MN/m}]\n");
  const TestReadings readings = readings_of({.data = m, .responses = {}});
  const auto y = Predictor(nominal_of(c, m), readings, {})(Eigen::VectorXd());
  ASSERT_TRUE(y);
  EXPECT_NEAR(std::exp((*y)[0]) / exact, 1, 1e-6);
  c.mount.pop_back();
  const Results none = run(c, quietly);
  EXPECT_FALSE(none.statics);
  ASSERT_FALSE(none.warnings.empty());
  EXPECT_NE(none.warnings.front().find("static stiffness left out"), std::string::npos);
}

} // namespace
} // namespace plica::test
