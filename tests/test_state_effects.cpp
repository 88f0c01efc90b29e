// States of a specimen that its case does not say, found by the diagnosis.
#include "run/analyses/run.hpp"
#include "tests/bellows_case.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plica::test {
namespace {

// A strip held at both ends, 25 by 6 by 600 mm.
Case strip() {
  Case c = changed_beam::beam_of(4, 0.6, 0.025, 0.006, true);
  Cap head;
  head.name = "head";
  head.of = {"beam.end"};
  c.caps.push_back(head);
  c.mount.push_back({.cap = "head"});
  c.analyses.statics = false;
  c.analyses.error_bars = false;
  return c;
}

double frequency_of(const Results& results, const MeasuredMode& mode) {
  const char* direction = mode.direction == Axis::x ? "x" : "z";
  for (const ModeResult& m : results.modes)
    if (m.shape == "transverse" && m.direction == direction && m.order == mode.order)
      return m.frequency;
  throw std::out_of_range(direction + std::to_string(mode.order));
}

// Of a part at rest and in the state, as `plica run` has them; each mode of the specimen is some
// percents off those of the model, and once mounted anew some thousandths off itself.
Measured measured_in(const Case& in_state) {
  constexpr std::array model_error{0.021, -0.014, 0.017, -0.025, 0.012};
  constexpr std::array mounted_anew{0.002, -0.003, 0.001, 0.003, -0.002};
  Case at_rest = in_state;
  at_rest.state.reset();
  const Results before = run_silently(at_rest), after = run_silently(in_state);
  Measured m;
  m.specimen = "strip";
  m.states = {{.name = "loose", .baseline = true, .set = {}, .numbers = {}},
              {.name = "installed", .baseline = false, .set = {}, .numbers = {}}};
  changed_beam::add_modes(m, "loose");
  changed_beam::add_modes(m, "installed");
  for (std::size_t k = 0; k < 5; ++k) {
    m.modes[k].frequency = frequency_of(before, m.modes[k]) * std::exp(model_error[k]);
    m.modes[5 + k].frequency =
        frequency_of(after, m.modes[5 + k]) * std::exp(model_error[k] + mounted_anew[k]);
  }
  return m;
}

// Pulled by 0.1 mm a strip is a string, too: N = EA 1/6000 raises each mode by N int w'^2.
TEST(StateEffects, a_strip_that_is_pulled) {
  constexpr double pulled = 1e-4;
  Case truth = strip();
  truth.state.emplace();
  truth.state->offset = {{.cap = "head", .move = {0, pulled, 0}}};
  const Measured m = measured_in(truth);
  // Clamped, mode 1: f^2 / f0^2 - 1 = 12.30 N L^2 / (500.6 EI) (Rayleigh's quotient).
  const double gain = m.modes[5].frequency / m.modes[0].frequency / std::exp(0.002);
  const double N_over_EI = 12 / std::pow(0.006, 2) * pulled / 0.6;
  EXPECT_NEAR(gain * gain - 1, 12.30 * N_over_EI * 0.36 / 500.6, 0.03 * (gain * gain - 1));
  Case nominal = strip();
  nominal.diagnose.priors = {{.effect = "installation_offset",
                              .parameter = "offset",
                              .between = {-5e-4, 5e-4},
                              .widening = {}}};
  const Diagnosis d = changed_beam::diagnosis_of(nominal, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "installation_offset") << d.headline;
  EXPECT_EQ(e.way, "axial");
  EXPECT_LE(e.parameters.front().interval[0], pulled);
  EXPECT_GE(e.parameters.front().interval[1], pulled);
}

// Nobody asks: a laboratory's part is at rest, and no state is solved.
TEST(StateEffects, are_tried_where_the_case_names_them) {
  const Case plain = strip();
  const Measured any = measured_in([&] {
    Case c = strip();
    c.state.emplace();
    return c;
  }());
  const Nominal nominal = nominal_of(plain, any);
  EXPECT_TRUE(installation_offset().hypotheses(nominal.structure(any)).empty());
  EXPECT_TRUE(pressure().hypotheses(nominal.structure(any)).empty());
}

// What the reduced model makes of an offset against the state itself.
TEST(StateEffects, between_their_samples_they_are_the_state) {
  Case asked = strip();
  asked.diagnose.effects = {"installation_offset"};
  Case in_state = strip();
  in_state.state.emplace();
  in_state.state->offset = {{.cap = "head", .move = {0, 7e-5, 0}}};
  Measured m = measured_in(in_state);
  const Nominal nominal = nominal_of(asked, m);
  const std::vector<Hypothesis> all = installation_offset().hypotheses(nominal.structure(m));
  ASSERT_EQ(all.size(), 3);
  const TestReadings test = readings_of({.data = m, .responses = {}});
  const Eigen::VectorXd y =
      *Predictor(nominal, test, {&all.front()})(Eigen::VectorXd::Constant(1, 7e-5));
  const Results results = run_silently(in_state);
  for (std::size_t k = 5; k < 10; ++k)
    EXPECT_NEAR(std::exp(y[Eigen::Index(k)]) / frequency_of(results, m.modes[k]), 1, 5e-3) << k;
}

} // namespace
} // namespace plica::test
