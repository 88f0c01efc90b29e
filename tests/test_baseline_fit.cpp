// The nominal case adjusted to the baseline before the change from it is looked at.
#include "diagnose/fit_baseline.hpp"
#include "tests/changed_beam.hpp"
#include "tests/fit_parameter.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using namespace changed_beam;

constexpr double true_modulus = 200e9, drawn_modulus = 185e9;

// Drawn too soft by 8 %, its modulus free in the fit.
Case drawn_too_soft() {
  Case c = held_beam();
  c.materials.at("steel").E = drawn_modulus;
  c.fit.emplace();
  c.fit->parameters = {test::fit_parameter("materials.steel.E", 150e9, 250e9)};
  return c;
}

// The true beam, each mode off by some percent more, before and after it got 120 g.
Measured of_the_true_beam() {
  return before_and_after(held_beam(), with_a_clamp(held_beam()));
}

FittedBaseline fitted_to(const Measured& m) {
  return fitted_to_baseline(drawn_too_soft(), {.data = m, .responses = {}}, {});
}

// Root mean square of what the model is off the baseline.
double off_the_baseline(const Diagnosis& d) {
  double sum = 0;
  for (const auto& r : d.baseline.readings) sum += std::pow(std::log(r.measured / r.nominal), 2);
  return std::sqrt(sum / double(d.baseline.readings.size()));
}

TEST(FitBaseline, gives_the_modulus_what_all_modes_of_the_baseline_are_off) {
  Measured m = of_the_true_beam();
  const FittedBaseline fitted = fitted_to(m);
  EXPECT_NEAR(fitted.data.materials.at("steel").E, true_modulus, 0.01 * true_modulus);
  ASSERT_EQ(fitted.edits.size(), 1U);
  EXPECT_EQ(fitted.edits[0].path, "materials.steel.E");
  ASSERT_EQ(fitted.words.size(), 1U);
  EXPECT_EQ(fitted.words[0].find("fitted to the baseline: materials.steel.E from 1.85e+11 to "), 0U)
      << fitted.words[0];
  // What came after has no say.
  for (MeasuredMode& mode : m.modes)
    if (mode.state == "after") mode.frequency *= 0.9;
  EXPECT_EQ(fitted_to(m).data.materials.at("steel").E, fitted.data.materials.at("steel").E);
}

TEST(FitBaseline, leaves_in_the_error_what_it_does_not_meet_and_the_change_is_found) {
  const Measured m = of_the_true_beam();
  const Diagnosis d = diagnosis_of(fitted_to(m).data, m);
  // The modulus does not follow what each mode is off for itself (changed_beam.hpp), 2.5 %.
  EXPECT_NEAR(off_the_baseline(d), 0.0253, 5e-4);
  EXPECT_TRUE(
      std::any_of(d.baseline.words.begin(), d.baseline.words.end(), [](const std::string& w) {
        return w.find("model error of frequencies: 2.5 %, as the baseline shows") == 0;
      }));
  EXPECT_EQ(d.baseline.readings.size(), 5U);
  ASSERT_EQ(d.readings.size(), 5U) << "what was fitted is not counted again";
  for (const auto& r : d.readings) EXPECT_NE(r.name.find(", after"), std::string::npos) << r.name;
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "added_mass") << d.headline;
  EXPECT_NEAR(d.effects.front().parameters.back().value, 0.3, 0.02) << "m along";
}

TEST(FitBaseline, asks_for_what_to_fit_and_for_a_baseline_as_it_is_drawn) {
  const auto key = [](const Case& data, const Measured& m) {
    return test::first_problem_of(
        [&] { fitted_to_baseline(data, {.data = m, .responses = {}}, {}); });
  };
  Measured m = of_the_true_beam();
  EXPECT_EQ(key(held_beam(), m), "diagnose.fit_baseline: needs a section `fit`");
  m.states[0].set = {{"materials.steel.E", "190 GPa"}};
  EXPECT_EQ(key(drawn_too_soft(), m), "diagnose.fit_baseline: needs a baseline that differs from "
                                      "the case by no known change");
}

} // namespace
} // namespace plica
