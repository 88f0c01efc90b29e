// Accelerometers beside the part: on the fixture under a held end, on the table.
#include "diagnose/diagnose.hpp"
#include "diagnose/effects/on_table.hpp"
#include "diagnose/predict/predictor.hpp"
#include "io/files/files.hpp"
#include "io/input/measured_file.hpp"
#include "tests/changed_beam.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <set>

namespace plica::test {
namespace {

using changed_beam::beam_of;
using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double zeta = 0.01, arm = 0.08;

MeasuredSensor beside(const std::string& name, const std::string& on, double y) {
  MeasuredSensor s;
  s.name = name;
  s.at = {0.05, y, -0.03};
  s.on = on;
  return s;
}

// A beam held at its root, sensors on its fixture to either side of the root, and on the table.
Measured watched(const std::string& mount = "mount.root") {
  Measured m;
  m.specimen = "beam";
  m.sensors = {beside("near", mount, 0), beside("before", mount, -arm),
               beside("behind", mount, arm), beside("table", "table", -0.5)};
  return m;
}

Case beam(bool on_springs = false) {
  Case c = beam_of(1, 0.06, 0.03, 0.03, true);
  if (on_springs) {
    c.mount[0].kind = MountKind::springs;
    c.mount[0].stiffness = {1e8, 1e8, 1e8, 1e5, 1e5, 1e5};
  }
  c.analyses.damping.modal = zeta;
  c.sensors = {{.name = "tip", .at = {0, 0.06, 0}}};
  return c;
}

// One that bends far below what it does as a rigid body.
Case slender(bool on_springs = false) {
  Case c = beam_of(4, 0.4, 0.03, 0.012, true);
  if (on_springs) {
    c.mount[0].kind = MountKind::springs;
    c.mount[0].stiffness = {1e8, 1e8, 1e8, 1e6, 1e6, 1e6};
  }
  c.sensors = {{.name = "tip", .at = {0, 0.4, 0}}};
  return c;
}

Hypothesis of(const std::string& effect, const Nominal& nominal, const Measured& m,
              const std::string& way = "", const std::string& place = "mount.root") {
  for (Hypothesis& h : effect_named(effect).hypotheses(nominal.structure(m)))
    if (h.place == place && h.way == way) return h;
  throw std::runtime_error("no " + effect + " " + way + " at " + place);
}

VectorXcd shown(const Nominal& nominal, const Hypothesis* acts, const VectorXd& values,
                const std::string& sensor, int base, int axis, const VectorXd& hertz,
                const std::shared_ptr<StateModels>& models = nullptr) {
  const TestRun run{.state = "",
                    .input = {.base = base, .force = ""},
                    .sensor = sensor,
                    .axis = axis,
                    .peaks = {}};
  TestReadings test; // that looks at every place
  test.runs = {run};
  for (const BuiltSensor& s : nominal.states.front().observed) {
    Reading reading;
    reading.run = 0;
    reading.kind = ReadingKind::amplitude;
    reading.sensor = s.name;
    test.readings.push_back(reading);
  }
  const std::vector<const Hypothesis*> together =
      acts ? std::vector{acts} : std::vector<const Hypothesis*>();
  return *Predictor(nominal, test, together, models).response(values, run, hertz);
}

const VectorXd hertz = VectorXd::LinSpaced(40, 20, 900);

TEST(FixtureSensors, read_one_on_what_does_not_move) {
  const Measured m = watched();
  for (bool on_springs : {false, true}) {
    const Nominal nominal = nominal_of(beam(on_springs), m);
    const auto models = std::make_shared<StateModels>(nominal); // reduced once
    for (const char* sensor : {"before", "table"})
      for (int base : {0, 1, 2})
        for (int axis : {0, 1, 2}) {
          const VectorXcd H =
              shown(nominal, nullptr, VectorXd(), sensor, base, axis, hertz, models);
          EXPECT_LT((H.array() - (axis == base ? 1. : 0.)).abs().maxCoeff(), 1e-9) << sensor;
        }
  }
}

// Along the axis the part is rigid: it and the fixture are one mass m + M on k = m (2 pi f)^2,
//   T = 1 + w^2 / (w0^2 - w^2 + 2 i zeta w0 w),   w0^2 = k / (m + M)
TEST(FixtureSensors, show_the_resonance_of_a_fixture) {
  const Measured m = watched();
  const Nominal nominal = nominal_of(beam(), m);
  const double mass = 2, f = 400, M = 7850 * 0.03 * 0.03 * 0.06;
  ASSERT_NEAR(nominal.mass, M, 1e-6 * M);
  const Hypothesis fixture = of("fixture_flexibility", nominal, m);
  const VectorXd values = Eigen::Vector4d(mass, f, 20, 1.3);
  const double w0 = 2 * std::numbers::pi * f * std::sqrt(mass / (mass + M));
  VectorXcd expected(hertz.size());
  for (Index i = 0; i < hertz.size(); ++i) {
    const double w = 2 * std::numbers::pi * hertz[i];
    expected[i] = 1. + w * w / std::complex<double>(w0 * w0 - w * w, 2 * zeta * w0 * w);
  }
  for (const char* sensor : {"near", "before", "behind"})
    EXPECT_LT((shown(nominal, &fixture, values, sensor, 1, 1, hertz) - expected)
                  .cwiseAbs()
                  .cwiseQuotient(expected.cwiseAbs())
                  .maxCoeff(),
              2e-3)
        << sensor;
  const VectorXcd table = shown(nominal, &fixture, values, "table", 1, 1, hertz);
  EXPECT_LT((table.array() - 1.).abs().maxCoeff(), 1e-9);
}

// Rocking moves the sensors before and behind the root apart, and the one between them goes
// halfway.
TEST(FixtureSensors, are_rigid_arms_of_a_fixture_that_rocks) {
  const Measured m = watched();
  const Nominal nominal = nominal_of(beam(), m);
  const Hypothesis fixture = of("fixture_flexibility", nominal, m);
  const VectorXd values = Eigen::Vector4d(0.5, 500, 0.7, 1.3);
  const auto along_z = [&](const char* sensor) {
    return shown(nominal, &fixture, values, sensor, 2, 2, hertz);
  };
  const VectorXcd before = along_z("before"), near = along_z("near"), behind = along_z("behind");
  EXPECT_GT((behind - before).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_LT(((before + behind) / 2 - near).cwiseAbs().maxCoeff(),
            1e-6 * near.cwiseAbs().maxCoeff());
}

// The end gives way between the part and the fixture: the part moves, the fixture does not.
TEST(FixtureSensors, tell_a_fixture_from_an_end_that_gives_way) {
  const Measured m = watched();
  const VectorXd soft = Eigen::Vector2d(2e6, 2e3);
  const Nominal rigid = nominal_of(slender(), m), sprung = nominal_of(slender(true), m);
  const Hypothesis springs = of("boundary_compliance", rigid, m),
                   ratio = of("boundary_compliance", sprung, m);
  const auto check = [&](const Nominal& nominal, const Hypothesis& h, const VectorXd& values) {
    const VectorXd low = VectorXd::LinSpaced(400, 10, 200);
    const VectorXcd tip = shown(nominal, &h, values, "tip", 2, 2, low),
                    fixture = shown(nominal, &h, values, "before", 2, 2, low);
    EXPECT_GT(tip.cwiseAbs().maxCoeff(), 2);
    EXPECT_LT((fixture.array() - 1.).abs().maxCoeff(), 1e-9);
  };
  check(rigid, springs, soft);
  check(sprung, ratio, VectorXd::Constant(1, 0.002));
  const Hypothesis under = of("fixture_flexibility", sprung, m);
  const VectorXcd moved =
      shown(sprung, &under, Eigen::Vector4d(0.5, 300, 1.5, 1.3), "near", 1, 1, hertz);
  EXPECT_GT(moved.cwiseAbs().maxCoeff(), 5);
}

// With the sensors there everything else answers as without them.
TEST(FixtureSensors, change_nothing_of_the_part) {
  const auto lambda = [](const Case& data, const Measured& m, const std::string& effect,
                         const VectorXd& values) {
    const Nominal nominal = nominal_of(data, m);
    const Hypothesis h = of(effect, nominal, m);
    return VectorXd(Predictor(nominal, TestReadings(), {&h}).modes(values)->lambda.head(4));
  };
  const Measured none;
  const VectorXd springs = Eigen::Vector2d(2e6, 2e3), fixture = Eigen::Vector4d(0.5, 300, 1.5, 1.3);
  const Case data = beam();
  const auto apart = [&](const std::string& effect, const VectorXd& values) {
    const VectorXd with = lambda(data, watched(), effect, values),
                   without = lambda(data, none, effect, values);
    return (with - without).cwiseQuotient(without).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(apart("boundary_compliance", springs), 1e-6); // of the spring that ties them
  EXPECT_LT(apart("fixture_flexibility", fixture), 1e-7);
  EXPECT_NEAR(nominal_of(data, watched()).length / nominal_of(data, none).length, 1, 1e-12);
}

// A table that moves across by a tenth is seen across by its own sensor, whatever the part does.
// What ties the fixture of a sensor is no joint of the part.
TEST(FixtureSensors, are_no_joints) {
  const auto joints = [](const Measured& m) {
    std::set<std::string> found;
    const Nominal nominal = nominal_of(beam(), m);
    for (const char* effect : {"joint_stiffness", "joint_friction"})
      for (const Hypothesis& h : effect_named(effect).hypotheses(nominal.structure(m)))
        found.insert(h.effect + " at " + h.place + " " + h.way);
    return found;
  };
  EXPECT_EQ(joints(watched()), joints(Measured()));
}

TEST(FixtureSensors, see_a_table_that_moves_across) {
  const Measured m = [] {
    Measured own = watched();
    MeasuredFrf sweep;
    sweep.base = Axis::z;
    own.frf = {sweep};
    return own;
  }();
  const Nominal nominal = nominal_of(beam(), m);
  const Hypothesis across = of("cross_axis_base_motion", nominal, m, "z to x", "base");
  const VectorXd tenth = VectorXd::Constant(1, 0.1);
  const auto along = [&](int axis) {
    return shown(nominal, &across, tenth, "table", 2, axis, hertz);
  };
  EXPECT_LT((along(0).array() - 0.1).abs().maxCoeff(), 1e-9);
  EXPECT_LT(along(1).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((along(2).array() - 1.).abs().maxCoeff(), 1e-9);
}

// They may be wrong themselves.
TEST(FixtureSensors, may_be_turned_and_read_too_much) {
  const Measured m = watched();
  const Nominal nominal = nominal_of(beam(), m);
  const Hypothesis gain = of("sensor_gain", nominal, m, "", "sensor.near");
  const VectorXcd more = shown(nominal, &gain, VectorXd::Constant(1, 1.2), "near", 2, 2, hertz);
  EXPECT_LT((more.array() - 1.2).abs().maxCoeff(), 1e-9);
  const Hypothesis turned = of("rotated_sensor", nominal, m, "about y", "sensor.table");
  const VectorXcd across =
      shown(nominal, &turned, VectorXd::Constant(1, 0.2), "table", 2, 0, hertz);
  EXPECT_LT((across.cwiseAbs().array() - std::sin(0.2)).abs().maxCoeff(), 1e-9);
}

// Sweeps along z of a slender beam: the first mode seen at its tip, and at the fixture where asked.
TestData sweeps(const Case& nominal_case, const Measured& m, bool at_fixture) {
  const Nominal nominal = nominal_of(nominal_case, m);
  const Hypothesis fixture = of("fixture_flexibility", nominal, m);
  const VectorXd values = Eigen::Vector4d(1.5, 90, 1.5, 1.3);
  const AffineModes modes = *Predictor(nominal, TestReadings(), {&fixture}).modes(values);
  TestData test{.data = m, .responses = {}};
  for (int base : {0, 2}) {
    MeasuredFrf entry;
    entry.base = static_cast<Axis>(base);
    entry.level = 1;
    entry.sigma = FrfSigma{.relative = 0.015, .floor = 0.01};
    FrfSet set;
    set.quantity = FrfQuantity::transmissibility;
    set.hertz = VectorXd::LinSpaced(2000, 0.4 * modes.hertz(0), 4 * modes.hertz(0));
    set.references = {std::string("base.") + axis_word(base)};
    std::vector<std::string> sensors{"tip"};
    if (at_fixture) sensors.emplace_back("near");
    set.H.emplace_back(set.hertz.size(), Index(3 * sensors.size()));
    for (const std::string& sensor : sensors)
      for (int axis : {0, 1, 2}) {
        set.H[0].col(Index(set.responses.size())) =
            shown(nominal, &fixture, values, sensor, base, axis, set.hertz);
        set.responses.push_back(sensor + "." + axis_word(axis));
      }
    test.data.frf.push_back(entry);
    test.responses.push_back({set});
  }
  return test;
}

TEST(FixtureSensors, rule_out_what_leaves_the_fixture_at_rest) {
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d = diagnose(slender(), sweeps(slender(), watched(), true), settings);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "fixture_flexibility") << d.headline;
  EXPECT_TRUE(std::none_of(d.effects.begin(), d.effects.end(), [](const NamedEffect& e) {
    return e.name == "boundary_compliance";
  })) << d.headline;
}

std::string problem_of(const std::string& text) {
  const TemporaryFolder folder("beside");
  write_whole(folder.path / "measured.yaml", "specimen: a\n" + text);
  return error_of([&] { read_measured((folder.path / "measured.yaml").string()); });
}

TEST(FixtureSensors, are_said_in_the_test_and_are_not_weighed) {
  const std::string on_part = "sensors:\n  - {name: tip, at: [0, 1, 0], mass: 5 g}\n",
                    on_fixture = "  - {name: low, at: [0, 0, 0], mass: 9 g, on: mount.root}\n";
  EXPECT_EQ(problem_of(on_part + on_fixture), "no error");
  const TemporaryFolder folder("weighed");
  write_whole(folder.path / "measured.yaml", "specimen: a\n" + on_part + on_fixture +
                                                 "mass: {value: 1 kg, without_sensors: true}\n");
  const Measured m = read_measured((folder.path / "measured.yaml").string());
  EXPECT_EQ(m.sensors[1].on, "mount.root");
  EXPECT_NEAR(m.weighings[0].value, 1.005, 1e-12);
  const std::string wrong = problem_of("sensors:\n  - {name: low, at: [0, 0, 0], on: bench}\n");
  EXPECT_NE(wrong.find("measured.yaml:3: sensors[0].on: 'bench' is nothing beside the part"),
            std::string::npos)
      << wrong;
  const std::string driven =
      problem_of(on_part + on_fixture +
                 "modes:\n  - {frequency: 10 Hz, shape: other, drive: low.z, force: 1 N}\n");
  EXPECT_NE(driven.find("modes[0].drive: 'low' sits beside the part"), std::string::npos) << driven;
}

TEST(FixtureSensors, need_a_mount_of_the_case_and_a_name_of_their_own) {
  const auto keys_of = [](const Case& data, const Measured& m) {
    std::vector<std::string> keys;
    for (const InputProblem& p : input_problems([&] { nominal_of(data, m); }))
      keys.push_back(p.key);
    return keys;
  };
  Measured m = watched("mount.tip");
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys_of(beam(), m), (Keys{"sensors[0].on", "sensors[1].on", "sensors[2].on"}));
  m = watched();
  m.sensors[3].name = "tip";
  EXPECT_EQ(keys_of(beam(), m), (Keys{"sensors[3].on"}));
}

} // namespace
} // namespace plica::test
