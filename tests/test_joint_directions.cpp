// Joints that give way in one direction, drawn with whatever large number stands for rigid.
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/effects/joint_groups.hpp"
#include "tests/bellows_case.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace plica {
namespace {

using namespace changed_beam;

Case two_halves(double bending_stiffness) {
  return changed_beam::two_halves(
      Sextuple{1e9, 1e9, 1e9, bending_stiffness, 1e6, bending_stiffness});
}

TEST(JointDirectionsSlow, what_gives_way_is_found_whatever_stands_for_rigid) {
  constexpr double loose = 3e3; // Nm/rad
  for (const double rigid : {1e4, 1e5, 1e6}) {
    const Case nominal = two_halves(rigid);
    const Diagnosis d = diagnosis_of(nominal, before_and_after(nominal, two_halves(loose)));
    ASSERT_FALSE(d.effects.empty()) << rigid << ": " << d.headline;
    const NamedEffect& e = d.effects.front();
    EXPECT_EQ(e.name, "joint_stiffness") << rigid << ": " << d.headline;
    EXPECT_EQ(e.place, "caps.joint") << rigid << ": " << d.headline;
    EXPECT_EQ(e.way, "bending") << rigid << ": " << d.headline;
    EXPECT_NEAR(e.parameters.front().value * rigid, loose, 0.25 * loose) << rigid;
  }
}

// Frequency and damping of the first peak at the end of the beam, along two axes of the table, over
// the level, as a model with these hypotheses in it reads them.
Measured swept(const Case& nominal, const std::vector<const Hypothesis*>& together,
               const Eigen::VectorXd& values) {
  Measured m;
  m.specimen = "beam";
  for (Axis axis : {Axis::x, Axis::z}) {
    MeasuredPeaks peaks;
    peaks.base = peaks.direction = axis;
    peaks.sensor = "tip";
    peaks.level = {0.5, 1, 2, 4, 8, 16};
    peaks.frequency.assign(peaks.level.size(), 30);
    peaks.damping.assign(peaks.level.size(), 0.01);
    m.peaks.push_back(peaks);
  }
  const Nominal model = nominal_of(nominal, m);
  const TestReadings test = readings_of({.data = m, .responses = {}});
  const Eigen::VectorXd y = *Predictor(model, test, together)(values);
  for (std::size_t i = 0; i < test.readings.size(); ++i) {
    const Reading& r = test.readings[i];
    const TestRun& run = test.runs[std::size_t(r.run)];
    MeasuredPeaks& peaks = m.peaks[run.input.base == 0 ? 0 : 1];
    const auto level = std::size_t(std::find(peaks.level.begin(), peaks.level.end(), run.level) -
                                   peaks.level.begin());
    (r.kind == ReadingKind::frequency ? peaks.frequency : peaks.damping)[level] =
        std::exp(y[Eigen::Index(i)]);
  }
  return m;
}

Case seen_at_its_tip(Case beam) {
  Sensor tip;
  tip.name = "tip";
  tip.at = {0, 0.6, 0};
  beam.sensors.push_back(tip);
  return beam;
}

// The lap slides as it bends; along the beam it holds.
TEST(JointDirections, what_slips_in_one_motion_is_found_as_that) {
  const Case nominal = seen_at_its_tip(two_halves(3e3));
  const Measured any = swept(nominal, {}, {});
  const Nominal model = nominal_of(nominal, any);
  const std::vector<Hypothesis> all = joint_friction().hypotheses(model.structure(any));
  std::set<std::string> ways;
  for (const Hypothesis& h : all) ways.insert(h.way);
  EXPECT_EQ(ways, (std::set<std::string>{"", "axial", "bending", "lateral", "torsion"}));
  const auto bending =
      std::find_if(all.begin(), all.end(), [](const Hypothesis& h) { return h.way == "bending"; });
  ASSERT_NE(bending, all.end());
  Eigen::VectorXd values(6); // ratio, share, slip, exponent, across, loss
  values << 1, 0.6, 2e-5, 1, 1, 1;
  const Measured m = swept(nominal, {&*bending}, values);
  EXPECT_LT(m.peaks[0].frequency.back(), 0.9 * m.peaks[0].frequency.front()) << "it slips";
  const Diagnosis d = diagnosis_of(nominal, m);
  ASSERT_EQ(d.verdict, Verdict::identified) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "joint_friction");
  EXPECT_EQ(e.place, "caps.joint");
  EXPECT_EQ(e.way, "bending") << d.headline;
  for (const EstimatedParameter& p : e.parameters)
    if (p.name == "slip") {
      EXPECT_LE(p.interval[0], 2e-5);
      EXPECT_GE(p.interval[1], 2e-5);
    }
}

// A clamp that is drawn as rigid slips as one that is drawn with the springs that it sticks with.
TEST(JointDirections, a_clamp_drawn_as_rigid_slips_by_the_same_law) {
  constexpr double stuck = 9e3; // Nm/rad
  const auto slipping = [](const Case& clamped, double first) {
    const Case nominal = seen_at_its_tip(clamped);
    const Measured any = swept(nominal, {}, {});
    const Nominal model = nominal_of(nominal, any);
    const std::vector<Hypothesis> all = joint_friction().hypotheses(model.structure(any));
    const auto bending = std::find_if(all.begin(), all.end(), [](const Hypothesis& h) {
      return h.way == "bending" && h.place == "caps.joint";
    });
    if (bending == all.end()) throw std::runtime_error("no clamp that slips as it bends");
    Eigen::VectorXd values(6); // ratio or stiffness, share, slip, exponent, across, loss
    values << first, 0.8, 1e-4, 1, 1, 1;
    return swept(nominal, {&*bending}, values);
  };
  const Measured rigid = slipping(changed_beam::two_halves({}), stuck),
                 drawn = slipping(two_halves(stuck), 1);
  EXPECT_LT(rigid.peaks[0].frequency.back(), 0.95 * rigid.peaks[0].frequency.front());
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t k = 0; k < rigid.peaks[axis].level.size(); ++k) {
      const double f = drawn.peaks[axis].frequency[k], zeta = drawn.peaks[axis].damping[k];
      EXPECT_NEAR(rigid.peaks[axis].frequency[k], f, 5e-3 * f) << axis << ", " << k;
      EXPECT_NEAR(rigid.peaks[axis].damping[k], zeta, 0.05 * zeta) << axis << ", " << k;
    }
}

// In one motion, or in motions of which none is larger than another of its kind, a softer joint
// says the same as one that slips.
TEST(JointFriction, is_tried_where_something_was_looked_at_at_two_levels) {
  const Case nominal = two_halves(3e3);
  const Nominal model = nominal_of(nominal, {});
  const auto is_tried = [&](const Measured& m) {
    return !joint_friction().hypotheses(model.structure(m)).empty();
  };
  MeasuredPeaks peaks;
  peaks.level = {5, 10};
  Measured m;
  EXPECT_FALSE(is_tried(m));
  m.peaks = {peaks};
  EXPECT_TRUE(is_tried(m));
  m.peaks[0].level = {5, 5.2};
  EXPECT_FALSE(is_tried(m)) << "one level twice, as a controller holds it";
  MeasuredFrf frf;
  frf.base = Axis::x;
  frf.level = 10;
  m.frf = {frf};
  EXPECT_FALSE(is_tried(m)) << "another level along another axis";
  m.frf[0].base = Axis::y;
  EXPECT_TRUE(is_tried(m)) << "peaks and a response of the same table";
  m.frf[0].state = "before";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}}};
  EXPECT_FALSE(is_tried(m)) << "in a baseline nothing slips that is looked for";

  Measured driven;
  driven.modes = {bending(Axis::z, 1, "", 80), bending(Axis::z, 1, "", 80)};
  for (MeasuredMode& mode : driven.modes) mode.drive = "tip.z";
  driven.modes[0].acceleration = 5;
  driven.modes[1].force = 10;
  EXPECT_FALSE(is_tried(driven)) << "nobody knows which is the higher";
  driven.modes[1].force.reset();
  driven.modes[1].acceleration = 10;
  EXPECT_TRUE(is_tried(driven));

  Measured rig;
  MeasuredStiffnessTable table;
  table.numbers = {{.hertz = 10, .amplitude = 1e-4}, {.hertz = 20, .amplitude = 1e-4}};
  rig.stiffness = {table};
  EXPECT_FALSE(is_tried(rig)) << "one amplitude";
  rig.stiffness[0].numbers[1].amplitude = 1e-3;
  EXPECT_TRUE(is_tried(rig));
}

// Four pieces of a clamped beam that meet in three joints, as coils of a liner do.
Case in_coils(double bending_stiffness) {
  Case c = two_halves(bending_stiffness);
  const auto piece = [&](std::size_t k, double from, double to) {
    std::get<BeamPart>(c.parts[k].body).points = {{0, from, 0}, {0, to, 0}};
  };
  piece(0, 0, 0.15);
  piece(1, 0.15, 0.3);
  for (const char* name : {"beam3", "beam4"}) {
    Part part = c.parts[1];
    part.name = name;
    c.parts.push_back(part);
  }
  piece(2, 0.3, 0.45);
  piece(3, 0.45, 0.6);
  for (int k = 2; k <= 3; ++k) {
    Cap coil = c.caps[1];
    coil.name = "joint" + std::to_string(k);
    coil.of = {"beam" + std::to_string(k) + ".end", "beam" + std::to_string(k + 1) + ".start"};
    c.caps.push_back(coil);
  }
  Sensor tip;
  tip.name = "tip";
  tip.at = {0, 0.6, 0};
  c.sensors.push_back(tip);
  return c;
}

// All of them softer by one factor, or slipping alike, is one cause, not three.
TEST(Joints, that_all_give_way_alike_are_one_cause) {
  const Case nominal = in_coils(8e3);
  const Diagnosis d = diagnosis_of(nominal, before_and_after(nominal, in_coils(3e3)));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "joint_stiffness") << d.headline;
  EXPECT_EQ(d.effects.front().place, "joints") << d.headline;
  EXPECT_NEAR(d.effects.front().parameters.front().value, 3. / 8, 0.1);
  EXPECT_EQ(d.effects.front().nodes.size(), 6U) << "drawn at all of them";
}

TEST(Joints, that_all_slip_are_found_together) {
  const Case nominal = in_coils(8e3);
  const Measured any = swept(nominal, {}, {});
  const Nominal model = nominal_of(nominal, any);
  const std::vector<Hypothesis> all = joint_friction().hypotheses(model.structure(any));
  const auto together = std::find_if(all.begin(), all.end(), [](const Hypothesis& h) {
    return h.place == "joints" && h.way == "bending";
  });
  ASSERT_NE(together, all.end());
  Eigen::VectorXd values(6); // ratio, share, slip, exponent, across, loss
  values << 1, 0.6, 2e-5, 1, 1, 1;
  const Diagnosis d = diagnosis_of(nominal, swept(nominal, {&*together}, values));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "joint_friction") << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_TRUE(e.place == "joints" || std::find(e.other_places.begin(), e.other_places.end(),
                                               "joints") != e.other_places.end())
      << d.headline;
}

// Springs in a row: 2, 3 and 6 N/m give 1; what couples its motions has no stiffness of its own.
TEST(JointDirections, of_springs_in_a_row_add_their_compliance) {
  Model model;
  JointGroup group{.place = "row", .bushings = {}, .beams = {}};
  for (const double k : {2., 3., 6.}) {
    BushingElement spring;
    spring.bushing.law.diagonal() << 10 * k, k, 5 * k, 0, 4 * k, 0;
    group.bushings.push_back(int(model.bushings.size()));
    model.bushings.push_back(spring);
  }
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::axial), 1, 1e-12);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::lateral), 10, 1e-12);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::torsion), 4, 1e-12);
  EXPECT_EQ(stiffness_in(model, group, JointDirection::bending), 0);
  scale_group(model, group, 3, JointDirection::axial);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::axial), 3, 1e-12);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::lateral), 10, 1e-12);
  model.bushings[0].bushing.law(0, 1) = model.bushings[0].bushing.law(1, 0) = 1;
  EXPECT_EQ(stiffness_in(model, group, JointDirection::axial), 0);
}

// Bellows A with an interlock along it.
Case with_interlock(double EA, double EI) {
  Case c = test::verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2});
  c.parts.push_back({"interlock", Interlock{.along = "bellows",
                                            .attachment = Attachment::synchronous,
                                            .EA = EA,
                                            .EI = EI,
                                            .mass = 0.02,
                                            .radius = 0.02}});
  return c;
}

Measured bent_and_stretched(const Case& truth) {
  Measured m;
  m.specimen = "bellows";
  for (Axis axis : {Axis::x, Axis::z})
    for (int order = 1; order <= 3; ++order) m.modes.push_back(bending(axis, order, ""));
  for (int order = 1; order <= 2; ++order) {
    m.modes.push_back(bending(Axis::y, order, ""));
    m.modes.back().shape = MeasuredShape::axial;
  }
  take_readings(m, read_by(truth, m));
  for (MeasuredMode& mode : m.modes) mode.sigma = 2e-3 * mode.frequency;
  return m;
}

// Coils that hook into each other resist bending and hardly stretching. Where the case gives them a
// mass alone, as that of A2 does, they bend stiffly; where it gives them a tube, they stretch
// softly. Those that do not resist at all are far out of the prior, as the case says it or not.
TEST(JointDirectionsSlow, an_interlock_that_bends_and_does_not_stretch_is_found_as_that) {
  constexpr double EI = 0.8, EA = 3e3; // of the bellows 1.54 N m2 and 3250 N
  const auto expect_interlock = [](const Diagnosis& d, const char* way) {
    ASSERT_FALSE(d.effects.empty()) << d.headline;
    const NamedEffect& e = d.effects.front();
    EXPECT_EQ(e.name, "joint_stiffness") << d.headline;
    EXPECT_EQ(e.place, "interlock") << d.headline;
    EXPECT_EQ(e.way, way) << d.headline;
  };
  expect_interlock(diagnosis_of(with_interlock(0, 0), bent_and_stretched(with_interlock(0, EI))),
                   "bending");
  Case tube = with_interlock(EA, EI);
  expect_interlock(diagnosis_of(tube, bent_and_stretched(with_interlock(0.15 * EA, EI))), "axial");
  const Measured loose = bent_and_stretched(with_interlock(0, EI));
  const Diagnosis far = diagnosis_of(tube, loose);
  EXPECT_NE(far.headline.find("nearest comes joint_stiffness at interlock (axial)"),
            std::string::npos)
      << far.headline;
  tube.diagnose.priors = {
      {.effect = "joint_stiffness", .parameter = "ratio", .between = {}, .widening = 4}};
  expect_interlock(diagnosis_of(tube, loose), "axial");
}

} // namespace
} // namespace plica
