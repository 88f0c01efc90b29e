// Clamps that a case draws as rigid, and that a diagnosis may find giving way.
#include "diagnose/effects/joint_groups.hpp"
#include "diagnose/predict/sprung_clamps.hpp"
#include "tests/bellows_case.hpp"
#include "tests/changed_beam.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <numbers>
#include <sstream>

namespace plica {
namespace {

using namespace changed_beam;
using Names = std::vector<std::string>;

Names clamps_of(Case data) {
  return put_springs_in_clamps(data);
}

Names clamps_of_shipped(const std::string& name, const std::string& model) {
  return clamps_of(
      read_case(std::string(PLICA_SOURCE_DIR) + "/cases/" + name + "/" + name + ".yaml", model)
          .data);
}

// Euler's beam, clamped and free, in whose middle a spring k takes the moment: of b = beta L,
// w = A (cosh - cos) + B (sinh - sin) from the clamp, C (cosh + cos) + D (sinh + sin) from the free
// end, the same deflection, moment and shear at the spring, slopes M / k apart. `compliance`:
// EI / (k L). The determinant of these four.
double determinant(double b, double compliance) {
  const double x = b / 2, c = std::cos(x), s = std::sin(x), C = std::cosh(x), S = std::sinh(x);
  Eigen::Matrix4d rows;
  // deflection; slope, that of the free half being against its own direction; moment; shear
  rows << C - c, S - s, -(C + c), -(S + s),                                             //
      S + s + compliance * b * (C + c), C - c + compliance * b * (S + s), S - s, C + c, //
      C + c, S + s, -(C - c), -(S - s),                                                 //
      S - s, C + c, S + s, C - c;
  return rows.determinant() / (C * C); // of one size over b
}

// The lowest three, Hz.
std::array<double, 3> frequencies(double L, double EI, double mass_per_length, double k) {
  const double compliance = EI / (k * L);
  std::array<double, 3> found{};
  std::size_t count = 0;
  constexpr double step = 0.05;
  for (double b = 0.5; count < found.size(); b += step) {
    double low = b, high = b + step;
    const double sign = determinant(low, compliance);
    if (sign * determinant(high, compliance) > 0) continue;
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2;
      (sign * determinant(middle, compliance) > 0 ? low : high) = middle;
    }
    found[count++] = low * low / (2 * std::numbers::pi * L * L) * std::sqrt(EI / mass_per_length);
  }
  return found;
}

// Before and after the clamp has come loose: k, Nm/rad, about both axes. Each mode is some
// thousandths off, as mounted anew.
Measured loosened(double k) {
  constexpr double L = 0.6, width = 0.025, depth = 0.012, E = 200e9, rho = 7850, rigid = 1e12;
  const auto modes = [&](Axis axis, double stiffness) {
    const double a = axis == Axis::x ? depth : width, h = axis == Axis::x ? width : depth;
    return frequencies(L, E * a * h * h * h / 12, rho * width * depth, stiffness);
  };
  constexpr std::array mounted_anew{0.001, -0.0015, 0.0005, 0.0015, -0.001};
  Measured m;
  m.specimen = "beam";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  std::size_t off = 0;
  for (Axis axis : {Axis::z, Axis::x})
    for (int order = 1; order <= (axis == Axis::z ? 3 : 2); ++order, ++off) {
      const auto i = std::size_t(order - 1);
      m.modes.push_back(bending(axis, order, "before", modes(axis, rigid)[i]));
      m.modes.push_back(bending(axis, order, "after", modes(axis, k)[i] * (1 + mounted_anew[off])));
    }
  return m;
}

// 1.8751, 4.6941, 7.8548: a cantilever without a spring (Blevins, table 8-1); with one as soft as
// air the clamped half, 1.8751 at twice the length.
TEST(SprungClamps, are_held_against_the_beam_of_textbooks) {
  const auto b_of = [](double hertz) { return std::sqrt(2 * std::numbers::pi * hertz); };
  const std::array<double, 3> whole = frequencies(1, 1, 1, 1e12);
  EXPECT_NEAR(b_of(whole[0]), 1.8751, 1e-4);
  EXPECT_NEAR(b_of(whole[1]), 4.6941, 1e-4);
  EXPECT_NEAR(b_of(whole[2]), 7.8548, 1e-4);
}

TEST(SprungClamps, do_not_move_the_nominal_structure) {
  const Case rigid = two_halves({});
  EXPECT_EQ(nominal_of(rigid, {}).rigid_clamps, Names{"caps.joint"});
  Case sprung = rigid;
  EXPECT_EQ(put_springs_in_clamps(sprung), Names{"caps.joint"});
  const Results own = test::run_silently(rigid), on_springs = test::run_silently(sprung);
  ASSERT_GE(own.modes.size(), 6U);
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_NEAR(on_springs.modes[j].frequency / own.modes[j].frequency, 1, 1e-4) << j;
}

// The same pulled along its axis: a tension of 2 kN stiffens it by some percents.
Case pulled(Case c) {
  Cap tip;
  tip.name = "tip";
  tip.of = {"beam2.end"};
  c.caps.push_back(tip);
  c.state.emplace().force = {{.cap = "tip", .force = {0, 2e3, 0}}};
  return c;
}

TEST(SprungClamps, do_not_move_a_structure_in_its_state) {
  const Case rigid = pulled(two_halves({}));
  EXPECT_EQ(nominal_of(rigid, {}).rigid_clamps, Names{"caps.joint"});
  Case sprung = rigid;
  EXPECT_EQ(put_springs_in_clamps(sprung), Names{"caps.joint"});
  const Results own = test::run_silently(rigid), on_springs = test::run_silently(sprung),
                at_rest = test::run_silently(two_halves({}));
  ASSERT_GE(own.modes.size(), 6U);
  EXPECT_GT(own.modes[0].frequency, 1.01 * at_rest.modes[0].frequency);
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_NEAR(on_springs.modes[j].frequency / own.modes[j].frequency, 1, 1e-4) << j;
}

// Of what it is by the run of a case that says so, in the state: readings of five modes.
TEST(SprungClamps, one_that_gives_way_in_a_state_is_followed) {
  Measured m;
  m.specimen = "beam";
  add_modes(m, "");
  const Case nominal = pulled(two_halves({}));
  constexpr double loose = 5e3; // Nm/rad
  const Nominal model = nominal_of(nominal, m);
  const Structure s = model.structure(m);
  const TestReadings readings = readings_of({.data = m, .responses = {}});
  int followed = 0;
  for (const Hypothesis& h : joint_stiffness().hypotheses(s)) {
    if (h.place != "caps.joint" || h.way != "bending") continue;
    Sextuple springs = cap_named(s.data, "joint")->stiffness.value();
    springs[3] = springs[5] = loose;
    const Eigen::VectorXd whole = read_by(pulled(two_halves(springs)), m),
                          rigid = read_by(nominal, m),
                          own = *Predictor(model, readings,
                                           {&h})(Eigen::VectorXd::Constant(1, loose));
    EXPECT_GT((rigid - whole).maxCoeff(), 0.05) << "it is seen";
    for (Eigen::Index i = 0; i < whole.size(); ++i) EXPECT_NEAR(own[i], whole[i], 1e-3) << i;
    ++followed;
  }
  EXPECT_EQ(followed, 1);
}

// A fifth to four fifths of the beam's own compliance, by its two axes.
TEST(SprungClamps, one_that_gives_way_is_found_with_its_stiffness) {
  constexpr double loose = 5e3; // Nm/rad
  const Case nominal = two_halves({});
  const Diagnosis d = diagnosis_of(nominal, loosened(loose));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "joint_stiffness") << d.headline;
  EXPECT_EQ(e.place, "caps.joint") << d.headline;
  EXPECT_EQ(e.way, "bending") << d.headline;
  const EstimatedParameter& k = e.parameters.front();
  EXPECT_EQ(k.name, "stiffness");
  EXPECT_EQ(k.unit, "Nm/rad");
  EXPECT_LE(k.interval[0], loose) << d.headline;
  EXPECT_GE(k.interval[1], loose) << d.headline;
  EXPECT_LT(k.interval[1], 2 * loose) << d.headline;
  EXPECT_TRUE(std::any_of(d.assumptions.begin(), d.assumptions.end(), [](const std::string& words) {
    return words.starts_with("drawn as rigid") && words.ends_with(" caps.joint");
  }));

  const CaseEdits edits = e.in_case(nominal); // which has no number there
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].path, "caps.joint.stiffness");
  std::string text = edits[0].value;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '[' || c == ']' || c == ','; }, ' ');
  std::istringstream numbers(text);
  Sextuple springs{};
  for (double& number : springs) numbers >> number;
  ASSERT_TRUE(numbers) << edits[0].value;
  for (const std::size_t about : {3, 5}) {
    EXPECT_GE(springs[about], k.interval[0]);
    EXPECT_LE(springs[about], k.interval[1]);
  }
  EXPECT_GT(springs[4], 1e3 * loose) << "torsion stays rigid";
  for (const std::size_t along : {0, 1, 2}) EXPECT_GT(springs[along], 1e9);
}

TEST(SprungClamps, one_that_holds_is_not_named) {
  const Diagnosis d = diagnosis_of(two_halves({}), loosened(1e12));
  EXPECT_EQ(d.verdict, Verdict::none) << d.headline;
  for (const NamedEffect& e : d.effects) EXPECT_NE(e.name, "joint_stiffness") << d.headline;
}

Case mounted_joint() {
  Case c = two_halves({});
  c.mount.push_back({.cap = "joint"});
  return c;
}

TEST(SprungClamps, stand_wherever_ends_are_joined) {
  EXPECT_EQ(clamps_of(two_halves({})), Names{"caps.joint"});
  EXPECT_EQ(clamps_of(two_halves(Sextuple{1, 1, 1, 1, 1, 1})), Names{}) << "drawn with springs";
  const Names both{"caps.joint.beam.end", "caps.joint.beam2.start"};
  EXPECT_EQ(clamps_of(mounted_joint()), both);
  Case one_part = two_halves({});
  one_part.caps.back().of = {"beam.end", "beam.point[2]"};
  const Names apart{"caps.joint.beam.end", "caps.joint.beam.point[2]"};
  EXPECT_EQ(clamps_of(one_part), apart) << "0.15 m apart";
  Case three = two_halves({});
  Part third = three.parts[1];
  third.name = "beam3";
  three.parts.push_back(third);
  three.caps.back().of.push_back("beam3.start");
  const Names each{"caps.joint.beam.end", "caps.joint.beam2.start", "caps.joint.beam3.start"};
  EXPECT_EQ(clamps_of(three), each);
  three.caps.back().ends = {{.end = "beam2.start", .stiffness = {1, 1, 1, 1, 1, 1}}};
  const Names others{"caps.joint.beam.end", "caps.joint.beam3.start"};
  EXPECT_EQ(clamps_of(three), others) << "one end is drawn on springs";
  three.caps.back().ends.push_back({.end = "beam3.start", .stiffness = {1, 1, 1, 1, 1, 1}});
  EXPECT_EQ(clamps_of(three), Names{}) << "what is left is the cap";
  Case side_by_side = two_halves({});
  Part inner = side_by_side.parts[0];
  inner.name = "inner";
  side_by_side.parts.push_back(inner);
  side_by_side.caps[0].of.push_back("inner.start");
  side_by_side.caps[1].of = {"beam.end", "inner.end"};
  const Names within{"caps.root.beam.start", "caps.root.inner.start", "caps.joint"};
  EXPECT_EQ(clamps_of(side_by_side), within) << "a beam within a beam";
}

// A body between two ends that lie apart, 0.1 m off their middle.
TEST(SprungClamps, of_ends_that_lie_apart_move_nothing) {
  Case rigid = two_halves({});
  rigid.caps.back().of = {"beam.end", "beam.point[2]"};
  rigid.caps.back().mass = 0.2;
  rigid.caps.back().offset = {0.1, 0, 0.02};
  rigid.parts.pop_back();
  Case sprung = rigid;
  put_springs_in_clamps(sprung);
  const Results own = test::run_silently(rigid), on_springs = test::run_silently(sprung);
  ASSERT_GE(own.modes.size(), 6U);
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_NEAR(on_springs.modes[j].frequency / own.modes[j].frequency, 1, 1e-4) << j;
}

TEST(SprungClamps, that_stay_rigid_are_told) {
  Case spinning = two_halves({}); // neither half resists torsion
  for (Part& part : spinning.parts) {
    BeamSection& section = std::get<BeamPart>(part.body).section = {};
    section.shape = BeamShape::general;
    section.EA = 6e7;
    section.EI = 720;
    section.GJ = 0;
  }
  EXPECT_EQ(put_springs_in_clamps(spinning), Names{});
  EXPECT_EQ(clamps_left_rigid(spinning), Names{"caps.joint"});
  Case found = two_halves({});
  put_springs_in_clamps(found);
  EXPECT_EQ(clamps_left_rigid(found), Names{});
}

// Two halves on one mount at their joint, the second one loose in bending: what a run of the case
// that says so has, and the other half goes on as it did.
TEST(SprungClamps, at_a_mount_are_followed_end_by_end) {
  Measured m;
  m.specimen = "beam";
  add_modes(m, "");
  const Case nominal = mounted_joint();
  constexpr double loose = 5e3; // Nm/rad
  const Nominal model = nominal_of(nominal, m);
  const Structure s = model.structure(m);
  const TestReadings readings = readings_of({.data = m, .responses = {}});
  const Eigen::VectorXd as_drawn = read_by(nominal, m);
  EXPECT_LT((*Predictor(model, readings, {})(Eigen::VectorXd()) - as_drawn).cwiseAbs().maxCoeff(),
            1e-3);
  std::map<std::string, int> followed;
  for (const Hypothesis& h : joint_stiffness().hypotheses(s)) {
    const bool lets_go = h.way == "all directions";
    if (!h.place.starts_with("caps.joint.") || !(lets_go || h.way == "bending")) continue;
    const double lever = lever_of(s), translation = loose / (lever * lever);
    const Eigen::VectorXd value = Eigen::VectorXd::Constant(1, lets_go ? translation : loose);
    const CaseEdits edits = h.in_case(nominal, value);
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0].path, "caps.joint.ends");
    Sextuple springs{1e11, 1e11, 1e11, loose, 1e11, loose};
    if (lets_go) springs = {translation, translation, translation, loose, loose, loose};
    Case truth = nominal;
    truth.caps.back().ends = {
        {.end = h.place.substr(std::string("caps.joint.").size()), .stiffness = springs}};
    EXPECT_EQ(edits[0].value.find("[{end: '" + truth.caps.back().ends[0].end + "'"), 0U);
    const Eigen::VectorXd whole = read_by(truth, m), own = *Predictor(model, readings, {&h})(value);
    if (h.place == "caps.joint.beam2.start") {
      EXPECT_GT((as_drawn - whole).maxCoeff(), 0.02) << "it is seen";
    }
    for (Eigen::Index i = 0; i < whole.size(); ++i)
      EXPECT_NEAR(own[i], whole[i], 1e-3) << h.place << " " << i;
    if (lets_go) {
      Sextuple told{};
      const std::string text = edits[0].value.substr(edits[0].value.rfind('[') + 1);
      std::size_t at = 0;
      for (double& number : told) {
        number = std::stod(text.substr(at));
        at = text.find(',', at) + 1;
      }
      // The priors stand as near to ten times what is beside as that is small beside rigid.
      for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(told[i] / springs[i], 1, 1e-3) << i;
    }
    ++followed[h.place];
  }
  EXPECT_EQ(followed, (std::map<std::string, int>{{"caps.joint.beam.end", 2},
                                                  {"caps.joint.beam2.start", 2}}));
}

// The interlock ends in the caps of its bellows and is a joint itself; a clamp between pipe and
// bellows is what it is drawn for, whatever stands for the bellows, the arms of a chain too.
TEST(SprungClamps, of_the_shipped_cases_stand_between_pipes_and_bellows) {
  Case lined = test::verification_case("bellows_a");
  test::add_liner(lined, Attachment::caps);
  EXPECT_EQ(clamps_of(lined), Names{});
  EXPECT_EQ(clamps_of_shipped("bellow_a2", ""), Names{});
  EXPECT_EQ(clamps_of_shipped("bolted_lap", ""), Names{});
  const Names four{"caps.clamp_1", "caps.clamp_2", "caps.clamp_3", "caps.clamp_4"};
  for (const char* model : {"pipe", "connector"})
    EXPECT_EQ(clamps_of_shipped("dual_assembly", model), four) << model;
}

// One hypothesis of each motion for a clamp, and one for all clamps alike; the number that stands
// for rigid is in none of their priors.
TEST(SprungClamps, may_give_way_each_and_all_alike) {
  Case nominal = two_halves({});
  Part third = nominal.parts[1];
  third.name = "beam3";
  std::get<BeamPart>(third.body).points = {{0, 0.6, 0}, {0, 0.75, 0}};
  nominal.parts.push_back(third);
  Cap second = nominal.caps[1];
  second.name = "second";
  second.of = {"beam2.end", "beam3.start"};
  nominal.caps.push_back(second);
  const Measured none;
  const Nominal model = nominal_of(nominal, none);
  const Structure s = model.structure(none);
  std::map<std::string, int> places;
  for (const Hypothesis& h : joint_stiffness().hypotheses(s)) {
    ++places[h.place];
    EXPECT_NE(h.way, "");
    const bool turning = h.way == "bending" || h.way == "torsion";
    const double beside = s.stiffness * (turning ? std::pow(lever_of(s), 2) : 1);
    const double expected = (h.place == "clamps" ? 20 : 10) * beside; // two in a row
    EXPECT_NEAR(h.parameters[0].prior.centre / expected, 1, 0.01) << h.place << " " << h.way;
    const Sextuple springs = cap_named(s.data, "joint")->stiffness.value();
    const Eigen::VectorXd rigid = Eigen::VectorXd::Constant(1, springs[turning ? 3 : 0]);
    EXPECT_NEAR(h.coefficients(rigid)[0] / h.coefficients(0 * rigid)[0], 0, 1e-9)
        << "at what stands for rigid nothing changes";
    const CaseEdits edits =
        h.in_case(nominal, h.parameters[0].prior.centre * 0.1 * Eigen::VectorXd::Ones(1));
    EXPECT_EQ(edits.size(), h.place == "clamps" ? 2U : 1U);
  }
  EXPECT_EQ(places,
            (std::map<std::string, int>{{"caps.joint", 5}, {"caps.second", 5}, {"clamps", 5}}));
}

} // namespace
} // namespace plica
