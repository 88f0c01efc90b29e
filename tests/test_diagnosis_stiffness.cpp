// Dynamic stiffness of a rig as readings of a diagnosis: what is read of a table, what the reduced
// model answers beside closed forms, and a joint that tables alone give away.
#include "compare/compare_stiffness.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/predict/predictor.hpp"
#include "diagnose/weigh/rig_errors.hpp"
#include "run/study/part_stiffness.hpp"
#include "tests/sliding_chain.hpp"
#include "tests/tube_case.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

void add_number(MeasuredStiffnessTable& table, double hertz, int direction, StiffnessKind kind,
                StiffnessQuantity quantity, double value, double amplitude = 0) {
  table.numbers.push_back({.hertz = hertz,
                           .amplitude = amplitude,
                           .direction = direction,
                           .kind = kind,
                           .quantity = quantity,
                           .value = value});
}

// Storage and loss.
void add_complex(MeasuredStiffnessTable& table, double hertz, int direction, StiffnessKind kind,
                 Complex k, double amplitude = 0) {
  add_number(table, hertz, direction, kind, StiffnessQuantity::storage, k.real(), amplitude);
  add_number(table, hertz, direction, kind, StiffnessQuantity::loss, k.imag(), amplitude);
}

TestReadings rig_readings(const Measured& m) {
  return readings_of({.data = m, .responses = {}});
}

TEST(RigReadings, are_a_few_of_each_motion_with_the_error_of_the_table) {
  Measured m;
  MeasuredStiffnessTable& table = m.stiffness.emplace_back();
  table.sigma = 0.02;
  for (int f = 1; f <= 100; ++f) // |k| as f^2
    add_complex(table, f, 1, StiffnessKind::transfer, std::polar(1e3 * f * f, 0.1));
  const TestReadings test = rig_readings(m);
  ASSERT_EQ(test.readings.size(), 12);
  EXPECT_TRUE(test.warnings.empty());
  EXPECT_EQ(test.readings[0].name, "y stiffness, 1 Hz");
  EXPECT_EQ(test.readings[1].name, "y loss factor, 1 Hz");
  EXPECT_EQ(test.readings[10].name, "y stiffness, 100 Hz");
  for (std::size_t i = 0; i < 12; i += 2) {
    const Reading &k = test.readings[i], &loss = test.readings[i + 1];
    EXPECT_EQ(k.kind, ReadingKind::dynamic_stiffness);
    EXPECT_EQ(k.unit, "N/m");
    EXPECT_NEAR(k.value, 1e3 * k.rig.hertz * k.rig.hertz, 1e-6 * k.value);
    EXPECT_NEAR(k.sigma, std::hypot(0.02, 2 * 0.003), 1e-4); // 0.3 % of the frequency
    EXPECT_EQ(loss.kind, ReadingKind::loss);
    EXPECT_NEAR(loss.value, std::sin(0.1), 1e-9);
    EXPECT_NEAR(loss.sigma, 0.02 / std::sin(0.1), 1e-9);
  }
}

TEST(RigReadings, of_amplitudes_take_the_first_and_the_last) {
  Measured m;
  MeasuredStiffnessTable& table = m.stiffness.emplace_back();
  table.ends = {"right", "left"};
  for (const double X : {1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3})
    for (const double f : {10., 20., 50., 100., 200.})
      add_number(table, f, 3, StiffnessKind::driving_point, StiffnessQuantity::storage, -5, X);
  const TestReadings test = rig_readings(m);
  ASSERT_EQ(test.readings.size(), 12); // four amplitudes, three frequencies
  EXPECT_EQ(test.readings.front().name, "rx driving point storage at 0.000572958 deg, 10 Hz");
  EXPECT_EQ(test.readings.back().stroke, 1e-3);
  for (const Reading& r : test.readings) {
    EXPECT_TRUE(r.rig.storage && r.rig.driving_point && r.assumed);
    EXPECT_EQ(r.unit, "Nm/rad");
    EXPECT_EQ(r.value, 5); // its size
  }
  m.hold_out = {"stiffness[0]"};
  EXPECT_TRUE(rig_readings(m).readings.front().held_out);
}

// A loss below twice its error is not read, nor one without a stiffness beside it.
TEST(RigReadings, leave_out_a_loss_that_is_not_known) {
  Measured m;
  MeasuredStiffnessTable& table = m.stiffness.emplace_back();
  table.sigma = 0.02;
  add_complex(table, 10, 1, StiffnessKind::transfer, {1e5, 3e3});
  EXPECT_EQ(rig_readings(m).readings.size(), 1);
  m.stiffness[0].numbers.erase(m.stiffness[0].numbers.begin());
  EXPECT_TRUE(rig_readings(m).readings.empty());
  EXPECT_EQ(rig_readings(m).warnings.size(), 1);
}

// exp of what the case answers to the readings of a test.
VectorXd rig_answers(const Case& data, const Measured& m,
                     const std::vector<const Hypothesis*>& together = {},
                     const VectorXd& values = {}) {
  const TestReadings test = rig_readings(m);
  const Nominal nominal = nominal_of(data, m);
  return Predictor(nominal, test, together)(values)->array().exp();
}

// k21 = EA* k / sin(k L), k11 = EA* k cot(k L), k^2 = m w^2 / EA*, EA* = EA (1 + i eta).
TEST(RigAnswers, of_a_rod_are_the_closed_form) {
  constexpr double m = 2, eta = 0.05;
  Case data = tube(m);
  std::get<BeamPart>(data.parts[0].body).elements = 100;
  data.analyses.damping.loss_factors = {{.of = "tube", .value = eta}};
  for (const MountKind far : {MountKind::rigid, MountKind::free}) { // whatever holds it on a table
    data.mount[1].kind = far;
    Measured test;
    MeasuredStiffnessTable& table = test.stiffness.emplace_back();
    table.ends = {"right", "left"};
    table.sigma = 0.01;
    for (const double hertz : {10., 100., 200., 300.}) {
      const Complex E = EA * Complex(1, eta), k = 2 * pi * hertz * std::sqrt(m / E);
      add_complex(table, hertz, 1, StiffnessKind::transfer, E * k / std::sin(k * L));
      add_complex(table, hertz, 1, StiffnessKind::driving_point, E * k / std::tan(k * L));
    }
    const VectorXd y = rig_answers(data, test);
    const std::vector<Reading> readings = rig_readings(test).readings;
    ASSERT_EQ(readings.size(), 16);
    ASSERT_EQ(y.size(), 16);
    for (Index i = 0; i < y.size(); ++i) {
      const Reading& r = readings[std::size_t(i)];
      if (far == MountKind::rigid) print_for_table("rig of a rod, " + r.name, y[i], r.value, 0.01);
      EXPECT_NEAR(y[i] / r.value, 1, 0.01) << r.name;
    }
  }
}

// Two tubes with a lap between, held at one end on the table; the rig moves the other.
Case lapped_tube() {
  Case data;
  data.name = "lapped_tube";
  data.materials["aluminium"] = {.E = 70e9, .nu = 0.33, .rho = 2700};
  for (const auto& [name, from, to] : {std::tuple{"first", 0., 0.3}, {"second", 0.3, 0.6}}) {
    BeamPart beam;
    beam.points = {{0, from, 0}, {0, to, 0}};
    beam.elements = 6;
    beam.section.shape = BeamShape::pipe;
    beam.section.material = "aluminium";
    beam.section.radius = 0.02;
    beam.section.thickness = 0.002;
    data.parts.push_back({name, beam});
  }
  data.caps = {{.name = "root", .of = {"first.start"}},
               {.name = "lap", .of = {"first.end", "second.start"}},
               {.name = "tip", .of = {"second.end"}}};
  data.caps[1].stiffness = Sextuple{5e7, 5e7, 5e7, 2e4, 2e4, 2e4};
  data.mount.push_back({.cap = "root"});
  data.analyses.damping.loss_factors = {{.of = "first", .value = 0.02},
                                        {.of = "second", .value = 0.02},
                                        {.of = "caps.lap", .value = 0.02}};
  return data;
}

// A mount between the ends: the diagnosis goes on without the table, and says so.
TEST(RigErrors, of_a_part_that_is_held_elsewhere_say_why) {
  Case data = lapped_tube();
  data.mount.push_back({.cap = "lap"});
  Measured test;
  MeasuredStiffnessTable& table = test.stiffness.emplace_back();
  table.ends = {"tip", "root"};
  add_complex(table, 50, 1, StiffnessKind::transfer, {1e6, 1e4});
  const TestReadings readings = rig_readings(test);
  const RigMeshCorrection found =
      rig_mesh_correction(data, test, readings, VectorXd::Zero(Index(readings.readings.size())));
  EXPECT_EQ(found.log, VectorXd::Zero(found.log.size()));
  ASSERT_EQ(found.refused.size(), readings.readings.size());
  for (const std::string& why : found.refused)
    EXPECT_NE(why.find("mount.lap: holds the part besides its two ends"), std::string::npos) << why;
}

// As by the modes of the part alone (run/study/part_stiffness.hpp), with ratios of modes and
// dashpots in a lap.
TEST(RigAnswers, of_damped_modes_and_dampers_are_those_of_the_part) {
  Case data = lapped_tube();
  data.analyses.damping = {.modal = 0.02};
  data.caps[1].damping.emplace().dashpot = Sextuple{4e3, 4e3, 4e3, 2, 2, 2};
  StiffnessRequest request;
  request.ends = {"tip", "root"};
  request.hertz = VectorXd::LinSpaced(4, 10, 310);
  const EndDynamicStiffness part = part_stiffness(data, request, [](const std::string&) {});
  Measured test;
  MeasuredStiffnessTable& table = test.stiffness.emplace_back();
  table.sigma = 1e-4;
  table.ends = request.ends;
  for (Index f = 0; f < request.hertz.size(); ++f)
    for (const int direction : {0, 1, 3, 4})
      add_complex(table, request.hertz[f], direction, StiffnessKind::transfer,
                  transfer_stiffness(part.states[0].over.at[0][std::size_t(f)], direction));
  const VectorXd y = rig_answers(data, test);
  const std::vector<Reading> readings = rig_readings(test).readings;
  ASSERT_FALSE(readings.empty());
  ASSERT_EQ(y.size(), Index(readings.size()));
  for (Index i = 0; i < y.size(); ++i) {
    const Reading& r = readings[std::size_t(i)];
    const double tolerance = r.kind == ReadingKind::loss ? 0.03 : 0.01;
    EXPECT_NEAR(y[i] / r.value, 1, tolerance) << r.name;
  }
}

// A slider beside a spring, slowly: k = K + k_t H(X / x_s), H of Jenkins' element; two of them in a
// row share the motion. Sliders that all slip at one distance are an exponent without end.
TEST(RigAnswers, of_a_group_that_slips_are_its_loop) {
  constexpr double K = 2e4, k_t = 6e4, force = 3;
  const auto jenkins = [](double X) -> Complex {
    const double slip = force / k_t;
    if (X <= slip) return K + k_t;
    const double theta = std::acos(1 - 2 * slip / X);
    return {K + k_t / pi * (theta - std::sin(2 * theta) / 2),
            4 * force * (X - slip) / (pi * X * X)};
  };
  Measured test;
  MeasuredStiffnessTable& table = test.stiffness.emplace_back();
  table.sigma = 0.01;
  for (const double X : {5e-5, 2e-4, 4e-4, 2e-3})
    add_complex(table, 0.5, 1, StiffnessKind::transfer, jenkins(X / 2) / 2., X);
  const Case data = sliding_chain();
  const Nominal nominal = nominal_of(data, test);
  const std::vector<Hypothesis> all =
      effect_named("joint_friction").hypotheses(nominal.structure(test));
  ASSERT_FALSE(all.empty());
  // Of the whole connector, stretched along: sqrt(k / stiffness of the group) per motion of an end.
  const double slip = 2 * force / k_t * std::sqrt((K + k_t) / 2 / all[0].group_stiffness);
  VectorXd values(6); // ratio, share, slip, exponent, across, loss
  values << 1, k_t / (K + k_t), slip * 51 / 50, 50, 1, 1;
  const VectorXd y = rig_answers(data, test, {&all[0]}, values);
  const std::vector<Reading> readings = rig_readings(test).readings;
  ASSERT_EQ(readings.size(), 7); // stuck, nothing is lost
  ASSERT_EQ(y.size(), 7);
  for (Index i = 0; i < y.size(); ++i) {
    const Reading& r = readings[std::size_t(i)];
    print_for_table("rig of sliders, " + r.name, y[i], r.value, 0.01);
    EXPECT_NEAR(y[i] / r.value, 1, 0.01) << r.name;
  }
}

TEST(RigAnswers, are_none_for_other_caps_and_beyond_the_basis) {
  Measured test;
  MeasuredStiffnessTable& table = test.stiffness.emplace_back();
  add_number(table, 1e5, 1, StiffnessKind::transfer, StiffnessQuantity::storage, 1);
  EXPECT_TRUE(std::isnan(rig_answers(tube(2), test)[0]));
  table.numbers[0].hertz = 10;
  EXPECT_TRUE(std::isfinite(rig_answers(tube(2), test)[0]));
  table.ends = {"left", "elsewhere"};
  EXPECT_TRUE(std::isnan(rig_answers(tube(2), test)[0]));
}

// What a rig reads of it in four directions, half a percent off here and there.
Measured rig_of(const Case& truth) {
  StiffnessRequest request;
  request.ends = {"tip", "root"};
  request.hertz = VectorXd::LinSpaced(31, 5, 305);
  const EndDynamicStiffness part = part_stiffness(truth, request, [](const std::string&) {});
  Measured m;
  m.specimen = truth.name;
  MeasuredStiffnessTable& table = m.stiffness.emplace_back();
  table.ends = request.ends;
  table.sigma = 0.01;
  for (Index f = 0; f < request.hertz.size(); ++f)
    for (const int direction : {0, 1, 3, 4}) {
      const double off = 1 + 0.005 * std::cos(7. * double(f) + 3. * direction);
      add_complex(table, request.hertz[f], direction, StiffnessKind::transfer,
                  off * transfer_stiffness(part.states[0].over.at[0][std::size_t(f)], direction));
    }
  return m;
}

TEST(DiagnosisOfARig, finds_a_lap_that_is_softer_by_its_tables_alone) {
  Case truth = lapped_tube();
  constexpr double ratio = 0.4;
  for (double& k : *truth.caps[1].stiffness) k *= ratio;
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis none =
      diagnose(lapped_tube(), {.data = rig_of(lapped_tube()), .responses = {}}, settings);
  EXPECT_EQ(none.verdict, Verdict::none);
  const Diagnosis found =
      diagnose(lapped_tube(), {.data = rig_of(truth), .responses = {}}, settings);
  EXPECT_EQ(found.verdict, Verdict::identified);
  ASSERT_FALSE(found.effects.empty());
  EXPECT_EQ(found.effects[0].name, "joint_stiffness");
  EXPECT_EQ(found.effects[0].place, "caps.lap");
  ASSERT_FALSE(found.effects[0].parameters.empty());
  print_for_table("a softer lap by the tables of a rig, ratio",
                  found.effects[0].parameters[0].value, ratio, 0.1);
  EXPECT_NEAR(found.effects[0].parameters[0].value / ratio, 1, 0.1);
}

// Held amid its length the part has no stiffness between its ends: what else was measured is
// explained all the same, and the report says what was set aside and why. Fine enough for a mesh of
// the case besides that of the diagnosis.
TEST(DiagnosisOfARig, goes_on_without_a_table_that_the_mesh_cannot_answer) {
  Measured m = rig_of(lapped_tube());
  m.weighings = {{.value = 2700 * 2 * pi * 0.02 * 0.002 * 0.6, .sigma = 1e-3, .repeats = {}}};
  Case data = lapped_tube();
  for (Part& part : data.parts) std::get<BeamPart>(part.body).elements = 1300;
  data.mount.push_back({.cap = "lap"});
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis found = diagnose(data, {.data = m, .responses = {}}, settings);
  EXPECT_EQ(found.verdict, Verdict::none);
  std::string said;
  for (const std::string& warning : found.warnings) said += warning + "\n";
  EXPECT_NE(said.find("stiffness[0] is set aside"), std::string::npos) << said;
  EXPECT_NE(said.find("mount.lap: holds the part besides its two ends"), std::string::npos) << said;
}

} // namespace
} // namespace plica::test
