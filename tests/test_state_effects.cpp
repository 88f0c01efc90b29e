// States of a specimen that its case does not say, found by the diagnosis.
#include "compare/fit/fit.hpp"
#include "model/description/steels.hpp"
#include "run/analyses/run.hpp"
#include "tests/bellows_case.hpp"
#include "tests/changed_beam.hpp"
#include "tests/fit_parameter.hpp"

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

// Of a part before and after, as `plica run` has them; each mode of the specimen is some percents
// off those of the model, and once mounted anew some thousandths off itself.
Measured measured_before_and_after(const Case& first, const Case& then) {
  constexpr std::array model_error{0.021, -0.014, 0.017, -0.025, 0.012};
  constexpr std::array mounted_anew{0.002, -0.003, 0.001, 0.003, -0.002};
  const Results before = run_silently(first), after = run_silently(then);
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

// At rest, and in the state.
Measured measured_in(const Case& in_state) {
  Case at_rest = in_state;
  at_rest.state.reset();
  return measured_before_and_after(at_rest, in_state);
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

// A strip of a steel with tables, held at both ends: 6 K do to it what a small offset does.
TEST(StateEffects, a_strip_that_is_warm_between_its_ends) {
  constexpr double warmer = 6;
  Case nominal = strip();
  std::get<BeamPart>(nominal.parts[0].body).section.material = "1.4301";
  add_known_steels(nominal.parts, nominal.materials);
  nominal.diagnose.priors = {
      {.effect = "temperature", .parameter = "delta_T", .between = {-15, 15}, .widening = {}}};
  Case truth = nominal;
  truth.state.emplace();
  truth.state->temperature = {{.part = "beam", .at = 20 + warmer}};
  const Measured m = measured_in(truth);
  // Clamped, mode 1: f^2 / f0^2 - 1 = -12.30 N L^2 / (500.6 EI), N = EA alpha dT.
  const double loss = m.modes[5].frequency / m.modes[0].frequency / std::exp(0.002);
  const double N_over_EI = 12 / std::pow(0.006, 2) * 16e-6 * warmer;
  EXPECT_NEAR(1 - loss * loss, 12.30 * N_over_EI * 0.36 / 500.6, 0.03 * (1 - loss * loss));
  const Diagnosis d = changed_beam::diagnosis_of(nominal, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "temperature") << d.headline;
  EXPECT_LE(e.parameters.front().interval[0], warmer);
  EXPECT_GE(e.parameters.front().interval[1], warmer);
}

// The case says its state, and the effect is another: 30 g on a strip that is pulled.
TEST(StateEffects, something_else_in_a_part_that_is_in_a_state) {
  Case pulled = strip();
  pulled.state.emplace();
  pulled.state->offset = {{.cap = "head", .move = {0, 1e-4, 0}}};
  Case loaded = pulled;
  PointMass mass;
  mass.at = "beam.point[2]";
  mass.mass = 0.03;
  loaded.parts.push_back({"weight", mass});
  const Measured m = measured_before_and_after(pulled, loaded);
  Case nominal = pulled;
  nominal.sensors = {{.name = "quarter", .at = {0, 0.15, 0}}};
  const Diagnosis d = changed_beam::diagnosis_of(nominal, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "added_mass") << d.headline;
  EXPECT_LE(e.parameters.front().interval[0], 0.03);
  EXPECT_GE(e.parameters.front().interval[1], 0.03);
}

// The reduced model of a case in its state has the frequencies of `plica run`, with springs on a
// table and a part that something is bolted to, too.
TEST(StateEffects, the_nominal_model_is_in_the_state_of_the_case) {
  Case pulled = strip();
  pulled.mount[1] = {
      .cap = "head", .kind = MountKind::springs, .stiffness = {1e7, 5e7, 1e7, 1e5, 1e5, 1e5}};
  pulled.state.emplace();
  pulled.state->offset = {{.cap = "head", .move = {0, 2e-4, 0}}};
  const Measured m = measured_in(pulled);
  const Nominal nominal = nominal_of(pulled, m);
  const Results results = run_silently(pulled), at_rest = run_silently(strip());
  const auto y =
      *Predictor(nominal, readings_of({.data = m, .responses = {}}), {})(Eigen::VectorXd());
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(std::exp(y[Eigen::Index(k)]) / frequency_of(results, m.modes[k]), 1, 1e-3) << k;
  EXPECT_GT(frequency_of(results, m.modes[0]), 1.02 * frequency_of(at_rest, m.modes[0]));
}

// A convoluted bellows under 3 bar, its frequencies those of `plica run`.
TEST(StateEffects, pressure_in_a_bellows) {
  constexpr double inside = 3e5;
  Case nominal = verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2}, 12);
  nominal.mount = {{.cap = "left"}, {.cap = "right"}};
  nominal.analyses.statics = false;
  nominal.analyses.error_bars = false;
  nominal.diagnose.priors = {
      {.effect = "pressure", .parameter = "pressure", .between = {0, 5e5}, .widening = {}}};
  Case truth = nominal;
  truth.state.emplace();
  truth.state->pressure = inside;
  const Results before = run_silently(nominal), after = run_silently(truth);
  Measured m;
  m.specimen = "bellows";
  m.states = {{.name = "vented", .baseline = true, .set = {}, .numbers = {}},
              {.name = "closed", .baseline = false, .set = {}, .numbers = {}}};
  constexpr std::array off{0.001, -0.002, 0.001};
  for (const auto& [state, results] : {std::pair{"vented", &before}, std::pair{"closed", &after}}) {
    int k = 0;
    for (const auto& [shape, word, direction, order] :
         {std::tuple{MeasuredShape::transverse, "transverse", Axis::x, 1},
          std::tuple{MeasuredShape::transverse, "transverse", Axis::x, 2},
          std::tuple{MeasuredShape::axial, "axial", Axis::y, 1}})
      for (const ModeResult& r : results->modes)
        if (r.shape == word && r.order == order &&
            (shape == MeasuredShape::axial || r.direction == "x")) {
          MeasuredMode mode = changed_beam::bending(direction, order, state, r.frequency);
          mode.shape = shape;
          if (state == std::string("closed")) mode.frequency *= std::exp(off[std::size_t(k)]);
          m.modes.push_back(mode);
          ++k;
        }
  }
  ASSERT_EQ(m.modes.size(), 6);
  const Diagnosis d = changed_beam::diagnosis_of(nominal, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const auto found = std::find_if(d.effects.begin(), d.effects.end(),
                                  [](const NamedEffect& e) { return e.name == "pressure"; });
  ASSERT_NE(found, d.effects.end()) << d.headline;
  EXPECT_LE(found->parameters.front().interval[0], inside);
  EXPECT_GE(found->parameters.front().interval[1], inside);
}

// Frequencies of a strip that is pulled give back by how much.
TEST(StateEffects, a_fit_of_the_state_itself) {
  Case truth = strip();
  truth.state.emplace();
  truth.state->offset = {{.cap = "head", .move = {0, 1e-4, 0}}};
  Measured m;
  m.specimen = "strip";
  changed_beam::add_modes(m, "");
  const Results results = run_silently(truth);
  for (MeasuredMode& mode : m.modes) mode.frequency = frequency_of(results, mode);
  Case start = truth;
  start.state->offset[0].move[1] = 3e-5;
  FitRequest request;
  request.parameters = {fit_parameter("state.offset.head.move[1]", 0, 3e-4)};
  const FitResult fit = fit_case(start, request, {m, {}}, {});
  ASSERT_TRUE(fit.converged) << fit.reason;
  EXPECT_NEAR(fit.parameters.front().value / 1e-4, 1, 1e-3);
}

} // namespace
} // namespace plica::test
