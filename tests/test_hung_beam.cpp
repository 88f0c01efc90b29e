// A beam that hangs in soft strings, and one that is free, before and after a change: against
// closed form (beam_roots.hpp).
#include "diagnose/account/gap_problem.hpp"
#include "tests/beam_roots.hpp"
#include "tests/before_and_after.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace plica {
namespace {

using namespace changed_beam;

constexpr double hung_length = 0.8, hung_width = 0.03, hung_depth = 0.012;
constexpr double string_stiffness = 500; // N/m of each end, in every direction

Case hung_at_both_ends(double k) {
  Case c = beam_of(4, hung_length, hung_width, hung_depth, false);
  for (const char* end : {"start", "end"}) {
    c.caps.push_back({.name = end, .of = {std::string("beam.") + end}});
    c.mount.push_back(
        {.cap = end, .kind = MountKind::springs, .stiffness = {k, k, k, 0.02, 0.02, 0.02}});
  }
  return c;
}

Case free_at_both_ends() {
  Case c = hung_at_both_ends(string_stiffness);
  for (auto& mount : c.mount) mount = {.cap = mount.cap, .kind = MountKind::free};
  return c;
}

// What a specimen is in the plane of bending of an axis; `loss` of stiffness over 80 mm about `at`.
struct HungSpecimen {
  double strings = 0, at = 0.29, mass = 0, loss = 0;

  beam_roots::BentBeam in(Axis axis) const {
    constexpr double E = 198e9; // where the case has 200 GPa
    const double wide = axis == Axis::z ? hung_width : hung_depth;
    const double deep = axis == Axis::z ? hung_depth : hung_width;
    const auto piece = [&](double length) { return beam_roots::rectangle(length, wide, deep, E); };
    beam_roots::BentBeam b;
    b.stretches = {piece(hung_length)};
    if (loss > 0) {
      constexpr double dent = 0.08;
      b.stretches = {piece(at - dent / 2), piece(dent), piece(hung_length - at - dent / 2)};
      b.stretches[1].EI *= 1 - loss;
      b.stretches[1].GA *= 1 - loss;
    }
    if (strings > 0) b.attached = {{0, strings, 0, 0.02}, {hung_length, strings, 0, 0.02}};
    if (mass > 0) b.attached.push_back({at, 0, mass, 0});
    return b;
  }

  // From below its rigid motions, or above them.
  std::vector<double> in_hertz(Axis axis, double low) const {
    return beam_roots::frequencies(in(axis), low, axis == Axis::z ? 4 : 3);
  }
};

constexpr double above_rigid = 40; // Hz

// Weighed and hit before and after.
Measured hit_before_and_after(const HungSpecimen& whole, const HungSpecimen& changed) {
  Measured m = before_and_after([&](Axis axis) { return whole.in_hertz(axis, above_rigid); },
                                [&](Axis axis) { return changed.in_hertz(axis, above_rigid); },
                                a_percent_off);
  const double weight = 7850 * hung_width * hung_depth * hung_length;
  weigh(m, weight, weight + changed.mass);
  return m;
}

// Every reading is of a mode that bends: the model's lies within 2.5 % of it.
void expect_no_rigid_motions(const Diagnosis& d) {
  EXPECT_EQ(d.readings.size(), 8U) << "a weighing and seven modes";
  EXPECT_EQ(d.baseline.readings.size(), 8U);
  for (const ComparedReading& r : d.baseline.readings)
    EXPECT_NEAR(r.nominal / r.measured, 1, 0.025) << r.name;
  for (const auto& e : d.effects) EXPECT_EQ(e.place.find("mount"), std::string::npos) << e.name;
}

// From either end, which frequencies do not tell apart.
void expect_place(const NamedEffect& e, double at) {
  const auto place = std::find_if(e.parameters.begin(), e.parameters.end(),
                                  [](const EstimatedParameter& p) { return p.name == "at"; });
  ASSERT_NE(place, e.parameters.end());
  const double nearer = std::min(place->value, hung_length - place->value);
  EXPECT_NEAR(nearer, at, 0.015);
  const auto holds = [&](double p) { return place->interval[0] <= p && p <= place->interval[1]; };
  EXPECT_TRUE(holds(at) || holds(hung_length - at))
      << place->interval[0] << " to " << place->interval[1];
}

// (beta L)^2 of a beam without ends held, Blevins, Formulas for Natural Frequency and Mode Shape,
// table 8-1; slender, so that shear and rotary inertia are next to nothing.
TEST(HungBeam, closed_form_is_that_of_textbooks) {
  const double L = 1, deep = 0.004;
  const beam_roots::BentBeam free{{beam_roots::rectangle(L, 0.03, deep, 200e9)}, {}, false};
  const double unit = std::sqrt(200e9 * deep * deep / (12 * 7850)) / (2 * std::numbers::pi * L * L);
  const std::vector<double> found = beam_roots::frequencies(free, 1, 3);
  constexpr std::array beta{4.730041, 7.853205, 10.995608};
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(found[k] / (beta[k] * beta[k] * unit), 1, 5e-4) << k;
}

// Strings of half and of twice the stiffness leave the readings as they are; their own motions, at
// 3 and 6 Hz, are none of them.
TEST(HungBeam, strings_are_no_readings) {
  const HungSpecimen specimen{.strings = string_stiffness};
  const std::vector<double> all = specimen.in_hertz(Axis::z, 1);
  EXPECT_LT(all[1], 0.1 * all[2]) << "two motions as a rigid body";
  Measured m = hit_before_and_after(specimen, specimen);
  std::erase_if(m.modes, [](const MeasuredMode& mode) { return mode.state == "after"; });
  m.states.pop_back();
  m.weighings.pop_back();
  const Eigen::VectorXd softer = read_by(hung_at_both_ends(string_stiffness / 2), m),
                        stiffer = read_by(hung_at_both_ends(string_stiffness * 2), m),
                        free = read_by(free_at_both_ends(), m);
  ASSERT_EQ(softer.size(), 8);
  EXPECT_LT((softer - stiffer).cwiseAbs().maxCoeff(), 6e-3);
  EXPECT_LT((softer - free).cwiseAbs().maxCoeff(), 6e-3);
}

TEST(HungBeam, a_mass_on_a_beam_in_strings_is_named_with_its_place) {
  const HungSpecimen whole{.strings = string_stiffness};
  HungSpecimen heavier = whole;
  heavier.mass = 0.15;
  Case nominal = hung_at_both_ends(string_stiffness);
  nominal.diagnose.effects = {"added_mass", "unweighed_mass", "local_damage",
                              "boundary_compliance"};
  const Diagnosis d = diagnosis_of(nominal, hit_before_and_after(whole, heavier));
  expect_no_rigid_motions(d);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "added_mass") << d.headline;
  EXPECT_EQ(e.place, "beam") << d.headline;
  ASSERT_EQ(e.parameters.front().name, "mass");
  EXPECT_LE(e.parameters.front().interval[0], heavier.mass) << d.headline;
  EXPECT_GE(e.parameters.front().interval[1], heavier.mass) << d.headline;
  expect_place(e, heavier.at);
}

TEST(HungBeamSlow, damage_of_a_beam_with_free_mounts_is_named_with_its_place) {
  const HungSpecimen whole;
  HungSpecimen dented = whole;
  dented.loss = 0.5;
  Case nominal = free_at_both_ends();
  nominal.diagnose.effects = {"added_mass", "unweighed_mass", "local_damage"};
  const Diagnosis d = diagnosis_of(nominal, hit_before_and_after(whole, dented));
  expect_no_rigid_motions(d);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "local_damage") << d.headline;
  EXPECT_EQ(e.place, "beam") << d.headline;
  expect_place(e, dented.at);
}

// Modes in z without a shape, their orders from `first` on, of a state.
void list_modes(Measured& m, const std::string& state, const std::vector<double>& hertz,
                int first) {
  for (std::size_t i = 0; i < hertz.size(); ++i) {
    m.modes.push_back(bending(Axis::z, first + int(i), state, hertz[i]));
    m.modes.back().shape = MeasuredShape::other;
    m.modes.back().damping = 0.005;
  }
}

Measured before_and_after_listed(const std::vector<double>& before, int first_before,
                                 const std::vector<double>& after, int first_after) {
  Measured m;
  m.specimen = "beam";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  list_modes(m, "before", before, first_before);
  list_modes(m, "after", after, first_after);
  return m;
}

TestReadings readings_beside_strings(const Measured& m) {
  const Case nominal = hung_at_both_ends(string_stiffness);
  return stated_gap(nominal, {.data = m, .responses = {}}, {})->readings;
}

// Two motions in strings and four that bend.
std::vector<double> all_in_strings(double softer = 1) {
  std::vector<double> all =
      beam_roots::frequencies(HungSpecimen{.strings = string_stiffness}.in(Axis::z), 1, 6);
  for (std::size_t i = 2; i < all.size(); ++i) all[i] *= softer;
  return all;
}

std::vector<double> without(std::vector<double> all, int first) {
  all.erase(all.begin(), all.begin() + first);
  return all;
}

// As an identification finds them.
TEST(HungBeam, how_it_swings_is_left_out_where_a_test_lists_it) {
  const std::vector<double> all = all_in_strings();
  Measured m;
  m.specimen = "beam";
  list_modes(m, "", all, 1);
  const Case nominal = hung_at_both_ends(string_stiffness);
  const TestData test{.data = m, .responses = {}};
  const auto problem = stated_gap(nominal, test, {});
  const TestReadings& found = problem->readings;
  ASSERT_EQ(found.readings.size(), 8U) << "of each mode that bends its frequency and damping";
  const Predictor predict(problem->nominal, found, {});
  const Eigen::VectorXd model = *predict(Eigen::VectorXd());
  for (std::size_t i = 0; i < found.readings.size(); ++i) {
    const Reading& r = found.readings[i];
    if (r.kind != ReadingKind::frequency) continue;
    EXPECT_EQ(r.value, all[std::size_t(r.order) + 1]);
    EXPECT_NEAR(model[Eigen::Index(i)], r.log_value, 0.02) << i;
  }
  EXPECT_EQ(std::count_if(found.warnings.begin(), found.warnings.end(),
                          [](const std::string& w) {
                            return w.find("swings as a rigid body") != std::string::npos;
                          }),
            2);
}

// Whichever of its motions are listed, modes that bend are counted from the first, in every state.
TEST(HungBeam, modes_that_bend_are_counted_from_the_first_whatever_is_listed_below) {
  const std::vector<double> all = all_in_strings();
  for (const Measured& m : {before_and_after_listed(all, 1, without(all, 2), 3),
                            before_and_after_listed(all, 1, without(all, 2), 1),
                            before_and_after_listed(without(all, 1), 2, without(all, 1), 2),
                            before_and_after_listed(without(all, 2), 1, all, 1)}) {
    const TestReadings found = readings_beside_strings(m);
    int frequencies = 0;
    for (const Reading& r : found.readings) {
      if (r.kind != ReadingKind::frequency) continue;
      EXPECT_EQ(r.value, all[std::size_t(r.order) + 1]) << r.entry;
      ++frequencies;
    }
    EXPECT_GE(frequencies, 4);
  }
}

TEST(HungBeam, modes_of_a_part_half_as_stiff_are_not_how_it_swings) {
  const std::vector<double> all = all_in_strings(0.48);
  const TestReadings found = readings_beside_strings(before_and_after_listed(all, 1, all, 1));
  ASSERT_FALSE(found.readings.empty());
  EXPECT_EQ(std::count_if(found.warnings.begin(), found.warnings.end(),
                          [](const std::string& w) {
                            return w.find("swings as a rigid body") != std::string::npos;
                          }),
            4)
      << "two in either state";
}

TEST(HungBeam, a_test_of_how_it_swings_alone_is_refused) {
  std::vector<double> all = all_in_strings();
  all.resize(2);
  Measured m;
  m.specimen = "beam";
  list_modes(m, "", all, 1);
  const std::string error = test::error_of([&] { readings_beside_strings(m); });
  EXPECT_NE(error.find("modes[0]: is how the part swings as a rigid body"), std::string::npos)
      << error;
}

// A table under the strings: of its one strong peak, the bounce, nothing is read, along or across.
TEST(HungBeam, a_bounce_on_a_table_is_no_reading) {
  const Case nominal = [] {
    Case c = hung_at_both_ends(string_stiffness);
    c.sensors = {{.name = "mid", .at = {0, hung_length / 2, 0}}};
    return c;
  }();
  TestData test;
  test.data.specimen = "beam";
  MeasuredMode bends = bending(Axis::z, 1, "", all_in_strings()[2]);
  test.data.modes = {bends};
  MeasuredFrf entry;
  entry.base = Axis::z;
  entry.sigma = FrfSigma{.relative = 0.015, .floor = 0.01};
  test.data.frf = {entry};
  FrfSet set;
  set.quantity = FrfQuantity::transmissibility;
  set.hertz = Eigen::VectorXd::LinSpaced(4000, 1, 60);
  set.references = {"base.z"};
  set.responses = {"mid.x", "mid.y", "mid.z"};
  set.H.emplace_back(set.hertz.size(), 3);
  const double bounce = all_in_strings()[0], zeta = 0.01;
  for (Eigen::Index i = 0; i < set.hertz.size(); ++i) {
    const double w = set.hertz[i] / bounce;
    const std::complex<double> T = 1. / std::complex<double>(1 - w * w, 2 * zeta * w);
    set.H[0].row(i) << 0.1 * T, 0.2 * T, T;
  }
  test.responses.push_back({set});
  const auto problem = stated_gap(nominal, test, {});
  ASSERT_EQ(problem->readings.readings.size(), 1U);
  EXPECT_EQ(problem->readings.readings[0].entry, "modes[0]");
}

} // namespace
} // namespace plica
