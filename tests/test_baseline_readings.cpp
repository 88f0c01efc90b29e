// What readings of a baseline say, and what they do not say of the change.
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/weigh/baseline.hpp"
#include "tests/changed_beam.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
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

MeasuredMass weighing(double value, const std::string& state) {
  return {.value = value, .sigma = {}, .repeats = {}, .state = state};
}

constexpr double off_the_drawing = 1.004; // of the mass: nothing that an effect has to explain

Measured weighed_in(const std::string& state, const Case& as_it_was) {
  Measured m = before_and_after(with_masses(), with_a_heavier_one());
  m.weighings = {weighing(1, state)};
  m.weighings[0].value = off_the_drawing * std::exp(read_by(as_it_was, m)[0]);
  return m;
}

Measured weighed_twice() {
  Measured m = weighed_in("before", with_masses());
  m.weighings.push_back(weighed_in("after", with_a_heavier_one()).weighings[0]);
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
  m.weighings = {weighing(1, "loaded")};
  const Case c = with_masses();
  EXPECT_NEAR(std::exp(read_by(c, m)[0]), nominal_of(c, m).mass + 0.15 - 0.05, 1e-9);
}

// What the drawing has wrong of the mass it has wrong twice: of the 4 per mille that the specimen
// is heavier nothing is left, and what two readings of the scale scatter, 2 per mille each, counts.
TEST(Weighing, before_and_after_says_what_came_within_the_scatter_of_the_scale) {
  const Measured m = weighed_twice();
  const std::vector<Reading> all = readings_of({.data = m, .responses = {}}).readings;
  EXPECT_EQ(all.at(0).name, "mass, before");
  EXPECT_EQ(all.at(0).entry, "mass[0]");
  EXPECT_EQ(all.at(1).name, "mass, after");
  EXPECT_EQ(all.at(1).entry, "mass[1]");

  const auto [test, u] = of_the_change(m);
  ASSERT_EQ(test.readings.front().kind, ReadingKind::mass);
  EXPECT_EQ(test.readings.front().state, "after");
  EXPECT_EQ(std::count_if(test.readings.begin(), test.readings.end(),
                          [](const Reading& r) { return r.kind == ReadingKind::mass; }),
            1);
  const double drawn = nominal_of(with_masses(), m).mass;
  EXPECT_NEAR(test.readings.front().log_value - u.nominal[0] - u.bias[0],
              std::log((drawn + 0.04) / drawn), 1e-4);
  EXPECT_NEAR(std::sqrt(u.total()(0, 0)), 0.002 * std::sqrt(2), 2e-5);
}

TEST(Weighing, repeated_in_one_state_is_one_reading_known_as_well_as_it_repeats) {
  Measured m;
  m.states = before_and_after(with_masses(), with_masses()).states;
  m.weighings = {weighing(1.2, "before"), weighing(1.30, "after"), weighing(1.31, "after")};
  const TestReadings test = readings_of({.data = m, .responses = {}});
  const double apart = std::log(1.31 / 1.30);
  ASSERT_EQ(test.readings.size(), 2U);
  EXPECT_EQ(test.readings[1].name, "mass, after, mean of 2");
  EXPECT_NEAR(test.readings[1].value, std::sqrt(1.30 * 1.31), 1e-12);
  EXPECT_NEAR(test.readings[0].sigma, apart / std::sqrt(2), 1e-12) << "more than was assumed";
  EXPECT_NEAR(test.readings[1].sigma, apart / 2, 1e-12);
  ASSERT_EQ(test.warnings.size(), 1U);
  EXPECT_EQ(test.warnings[0].find("repeated measurements of a mass scatter by 0.54 %"), 0U)
      << test.warnings[0];

  for (MeasuredMass& w : m.weighings) w.sigma = 0.001;
  EXPECT_TRUE(readings_of({.data = m, .responses = {}}).warnings.empty()) << "it is stated";
}

// A cantilever before and after 50 g came to its end, in one plane. The curvature of its modes at
// the clamp is their motion at the end: every mode falls by a like share, as where the clamp, the
// whole beam or its mass gave way or grew.
Case plain_beam() {
  return beam_of(4, 0.6, 0.03, 0.01, true);
}
constexpr double came = 0.05; // kg

// By the scale, to a gram; `gained` between its two weighings.
Measured loaded_at_its_end(std::optional<double> gained) {
  Case loaded = plain_beam();
  PointMass mass;
  mass.at = "beam.point[5]";
  mass.mass = came;
  loaded.parts.push_back({"clamp", mass});
  Measured m = before_and_after(plain_beam(), loaded);
  std::erase_if(m.modes, [](const MeasuredMode& mode) { return mode.direction == Axis::x; });
  if (!gained) return m;
  const double before = off_the_drawing * nominal_of(plain_beam(), {}).mass;
  m.weighings = {weighing(before, "before"), weighing(before + *gained, "after")};
  for (MeasuredMass& w : m.weighings) w.sigma = 0.001;
  return m;
}

// How probable an effect is, wherever it sits; zero where it is not named.
double share_of(const char* effect, const Diagnosis& d) {
  for (const NamedEffect& e : d.effects)
    if (e.name == effect) return e.anywhere;
  return 0;
}

TEST(Weighing, before_and_after_tells_a_mass_from_lost_stiffness) {
  const Diagnosis alone = diagnosis_of(plain_beam(), loaded_at_its_end({}));
  EXPECT_LT(share_of("added_mass", alone), 0.8) << alone.headline;
  const Diagnosis d = diagnosis_of(plain_beam(), loaded_at_its_end(came));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  ASSERT_EQ(d.effects.front().name, "added_mass") << d.headline;
  EXPECT_GT(share_of("added_mass", d), share_of("added_mass", alone)) << d.headline;
  const std::array<double, 2> interval = d.effects.front().parameters.front().interval;
  EXPECT_LT(interval[0], came);
  EXPECT_GT(interval[1], came);
  EXPECT_LT(interval[1] - interval[0], 0.012) << "kg, of two weighings to a gram";
}

TEST(Weighing, before_and_after_that_agree_speak_against_a_mass) {
  const Diagnosis d = diagnosis_of(plain_beam(), loaded_at_its_end(0.));
  EXPECT_FALSE(d.effects.empty()) << d.headline;
  for (const char* effect : {"added_mass", "unweighed_mass"})
    EXPECT_LT(share_of(effect, d), 0.1) << effect << ": " << d.headline;
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

// What mesh and reduction miss of a mode, of a static stiffness or of a component of a shape they
// miss before and after; what is read of one mode says nothing of another's.
TEST(NumericError, of_one_thing_is_the_same_in_every_state) {
  Measured m = before_and_after(with_masses(), with_a_heavier_one()); // five modes, the five again
  for (const char* state : {"before", "after"}) {
    MeasuredStatic& k = m.statics.emplace_back();
    k.direction = StaticDirection::transverse_z;
    k.value = 1e5;
    k.state = state;
  }
  m.sensors = {{.name = "h1", .at = {0, 0.2, 0}}, {.name = "h2", .at = {0, 0.35, 0}}};
  for (MeasuredMode& mode : m.modes) {
    const std::string axis = mode.direction == Axis::x ? ".x" : ".z";
    mode.vector.emplace().channels = {"h1" + axis, "h2" + axis};
    mode.vector->real = {1, 0.4};
  }
  const Case nominal = with_masses();
  const TestReadings test = readings_of({.data = m, .responses = {}});
  const Uncertainty u = uncertainty_of(nominal, nominal_of(nominal, m), test, m, {});
  // Of each reading what it is of, whatever the state.
  const auto thing = [](const Reading& r) {
    std::string entry = r.entry;
    if (entry.starts_with("modes["))
      entry = "mode " + std::to_string(std::stoul(entry.substr(6)) % 5);
    else if (entry.starts_with("static"))
      entry = "static";
    return entry + ", " + std::to_string(int(r.kind)) + ", " + std::to_string(r.channel);
  };
  std::map<ReadingKind, int> twice;
  for (std::size_t i = 0; i < test.readings.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Reading &a = test.readings[i], &b = test.readings[j];
      const double shared = u.numeric(Index(i), Index(j)), own = u.numeric(Index(i), Index(i));
      EXPECT_GT(own, 0) << a.name;
      if (thing(a) == thing(b)) {
        ++twice[a.kind];
        EXPECT_NE(a.state, b.state);
        EXPECT_NEAR(shared, own, 1e-12) << a.name << ", " << b.name;
      } else {
        EXPECT_EQ(shared, 0) << a.name << ", " << b.name;
      }
    }
  EXPECT_EQ(twice[ReadingKind::frequency], 5);
  EXPECT_EQ(twice[ReadingKind::stiffness], 1);
  EXPECT_GE(twice[ReadingKind::component], 5);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(u.numeric);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-12) << "a covariance";
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
