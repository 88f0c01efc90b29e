// What readings of a baseline say, and what they do not say of the change.
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/weigh/baseline.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using namespace changed_beam;
using Eigen::Index;
using Eigen::VectorXd;

// A held beam with three masses, the second of which, 50 g, gains 40 g.
Case with_masses() {
  Case c = beam_of(5, 0.5, 0.03, 0.01, true);
  add_masses(c);
  return c;
}
Case with_a_heavier_one() {
  Case c = with_masses();
  for (Part& part : c.parts)
    if (part.name == "m2") std::get<PointMass>(part.body).mass *= 1.8;
  return c;
}

Measured weighed_in(const std::string& state, const Case& as_it_was) {
  Measured m = before_and_after(with_masses(), with_a_heavier_one());
  m.mass.emplace();
  m.mass->value = 1;
  m.mass->state = state;
  const VectorXd y = read_by(as_it_was, m);
  m.mass->value = 1.004 * std::exp(y[0]);
  return m;
}

bool has_mass(const TestReadings& test) {
  return std::any_of(test.readings.begin(), test.readings.end(),
                     [](const Reading& r) { return r.kind == ReadingKind::mass; });
}

// The readings of the change, once the baseline is known.
TestReadings of_the_change(const Measured& m) {
  const Case nominal = with_masses();
  TestReadings test = readings_of({.data = m, .responses = {}});
  const Nominal model = nominal_of(nominal, m);
  Uncertainty u = uncertainty_of(nominal, model, test, m, {}, remounting_of(test, m, {}));
  given_baselines(m, {}, test, u);
  return test;
}

TEST(Weighing, belongs_to_the_state_it_was_made_in) {
  const Measured before = weighed_in("before", with_masses());
  const TestReadings readings = readings_of({.data = before, .responses = {}});
  ASSERT_EQ(readings.readings.front().kind, ReadingKind::mass);
  EXPECT_EQ(readings.readings.front().state, "before");
  EXPECT_EQ(readings.readings.front().name, "mass, before");
  EXPECT_FALSE(has_mass(of_the_change(before))) << "it says nothing of the change";
  EXPECT_TRUE(has_mass(of_the_change(weighed_in("after", with_a_heavier_one()))));
}

TEST(Weighing, knows_what_was_changed_in_its_state) {
  Measured m;
  m.specimen = "beam";
  m.states = {{.name = "loaded",
               .baseline = false,
               .set = {{"parts.m2.mass", "150 g"}},
               .numbers = {{"parts.m2.mass", 0.15}}}};
  add_modes(m, "");
  m.mass.emplace();
  m.mass->value = 1;
  m.mass->state = "loaded";
  const Case c = with_masses();
  EXPECT_NEAR(std::exp(read_by(c, m)[0]), nominal_of(c, m).mass + 0.15 - 0.05, 1e-9);
}

// On the scale before the mass came: it weighs what is drawn, and the modes say what came.
TEST(Weighing, in_a_baseline_does_not_speak_against_what_came_after) {
  const Diagnosis d = diagnosis_of(with_masses(), weighed_in("before", with_masses()));
  EXPECT_TRUE(std::none_of(d.readings.begin(), d.readings.end(),
                           [](const auto& r) { return r.kind == ReadingKind::mass; }));
  EXPECT_EQ(d.baseline.readings.size(), 6U);
  const auto heavier = std::find_if(d.effects.begin(), d.effects.end(), [](const NamedEffect& e) {
    return e.name == "component_mass" && e.place == "m2";
  });
  EXPECT_NE(heavier, d.effects.end()) << d.headline;
  EXPECT_NE(d.verdict, Verdict::unknown) << d.headline;
}

} // namespace
} // namespace plica
