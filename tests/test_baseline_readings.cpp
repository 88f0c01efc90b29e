// What readings of a baseline say, and what they do not say of the change.
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/weigh/baseline.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plica {
namespace {

using namespace changed_beam;
using Eigen::Index;
using Eigen::VectorXd;

// A held beam with three masses, the second of which, 50 g, gains 40 g.
Case with_masses() {
  Case c = held_beam();
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

// The readings of the change and how open they are, once the baseline is known.
std::pair<TestReadings, Uncertainty> of_the_change(const Measured& m,
                                                   const DiagnosisRequest& request = {}) {
  const Case nominal = with_masses();
  TestReadings test = readings_of({.data = m, .responses = {}});
  const Nominal model = nominal_of(nominal, m);
  Uncertainty u = uncertainty_of(nominal, model, test, m, {}, remounting_of(test, m, request));
  given_baselines(m, request, test, u);
  return {std::move(test), std::move(u)};
}

TEST(Weighing, belongs_to_the_state_it_was_made_in) {
  const Measured before = weighed_in("before", with_masses());
  const TestReadings readings = readings_of({.data = before, .responses = {}});
  ASSERT_EQ(readings.readings.front().kind, ReadingKind::mass);
  EXPECT_EQ(readings.readings.front().state, "before");
  EXPECT_EQ(readings.readings.front().name, "mass, before");
  EXPECT_FALSE(has_mass(of_the_change(before).first)) << "it says nothing of the change";
  EXPECT_TRUE(has_mass(of_the_change(weighed_in("after", with_a_heavier_one())).first));
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

// `correlation` of the case: how much of the model's error is the same in a baseline and after.
// Where none is, all of it stays open after the baseline: 2 % of a frequency at least.
TEST(Correlation, of_the_model_error_is_what_a_baseline_tells_of_it) {
  const Measured m = before_and_after(with_masses(), with_a_heavier_one());
  std::vector<VectorXd> sigma;
  for (const double correlation : {1., 0.5, 0.}) {
    DiagnosisRequest request;
    request.correlation = correlation;
    sigma.emplace_back(of_the_change(m, request).second.total().diagonal().cwiseSqrt());
  }
  for (Index i = 0; i < 5; ++i) {
    EXPECT_LT(sigma[0][i], sigma[1][i]) << i;
    EXPECT_LT(sigma[1][i], sigma[2][i]) << i;
    EXPECT_LT(sigma[0][i], 0.01) << i;
    EXPECT_GT(sigma[2][i], 0.02) << i;
  }
}

// Fault 6: a level beside a mode that nothing says the excitation of was dropped without a word.
TEST(Readings, a_level_without_a_base_is_warned_of) {
  Measured m;
  m.modes = {bending(Axis::z, 1, "", 30), bending(Axis::z, 2, "", 190),
             bending(Axis::z, 3, "", 530)};
  const auto warnings = [&] { return readings_of({.data = m, .responses = {}}).warnings; };
  EXPECT_TRUE(warnings().empty());
  m.modes[0].level = 10;
  m.modes[2].level = 20;
  ASSERT_EQ(warnings().size(), 1U);
  EXPECT_EQ(warnings()[0].find("the levels of modes[0], modes[2] say nothing without `base`"), 0U)
      << warnings()[0];
  m.modes[0].base = m.modes[2].base = Axis::z;
  EXPECT_TRUE(warnings().empty());
}

// Fault 8: -191 K in a laboratory, 35 kg on a beam of 1.85 kg.
TEST(DefaultPriors, are_those_of_a_laboratory_and_of_what_nobody_would_miss) {
  const Nominal model = nominal_of(with_masses(), {});
  const std::vector<Hypothesis> tried = chosen_effects(model.structure({})).hypotheses;
  int temperatures = 0, masses = 0;
  for (const Hypothesis& h : tried)
    for (const EffectParameter& p : h.parameters) {
      if (h.effect == "temperature" && p.name == "delta_T") {
        ++temperatures;
        EXPECT_EQ(p.prior.low, -10);
        EXPECT_EQ(p.prior.high, 10);
      }
      if (h.effect == "added_mass" && p.name == "mass") {
        ++masses;
        EXPECT_NEAR(p.prior.high, model.mass / 5, 1e-12) << h.place;
        EXPECT_LE(value_of(p.prior, 6), (1 + 1e-9) * model.mass / 5) << h.place;
      }
    }
  EXPECT_GT(temperatures, 0);
  EXPECT_GT(masses, 0);
}

} // namespace
} // namespace plica
