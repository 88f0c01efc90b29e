// What one state of a specimen answers to the readings of a test, on a mass at the end of a beam
// that weighs nothing.
#include "changed_beam.hpp"
#include "diagnose/account/gap_problem.hpp"
#include "diagnose/predict/menu.hpp"
#include "diagnose/predict/passed_over.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXd;

constexpr double length = 0.5, width = 0.02, depth = 0.01, mass = 2, damping = 0.02;

// Bending in z over `depth`, in x over `width`; one sensor on the mass.
Case mass_on_a_beam() {
  Case c = changed_beam::beam_of(1, length, width, depth, true);
  c.materials.at("steel").rho = 1e-3;
  PointMass end;
  end.at = "beam.end";
  end.mass = mass;
  c.parts.push_back({"m", end});
  Sensor tip;
  tip.name = "tip";
  tip.at = {0, length, 0};
  c.sensors.push_back(tip);
  c.analyses.modes = Modes{.count = 2};
  c.analyses.damping.modal = damping;
  return c;
}

// sqrt(3 E I / (L^3 m)), without the shear of the beam: 4e-4 of it.
double hertz_of_bending(double across, double along) {
  const double I = across * std::pow(along, 3) / 12;
  return std::sqrt(3 * 200e9 * I / (std::pow(length, 3) * mass)) / (2 * std::numbers::pi);
}

class AnswersOfAMass : public testing::Test {
protected:
  AnswersOfAMass() {
    TestRun run;
    run.input.base = run.axis = 2;
    run.level = 1;
    run.sensor = "tip";
    run.peaks = {0};
    run.first = true;
    sweep_.runs = {run};
    for (ReadingKind kind :
         {ReadingKind::frequency, ReadingKind::damping, ReadingKind::amplitude, ReadingKind::mass})
      sweep_.readings.push_back(reading(kind, "tip"));
  }

  static Reading reading(ReadingKind kind, const std::string& sensor) {
    Reading r;
    r.kind = kind;
    r.sensor = sensor;
    r.run = 0;
    r.axis = 2;
    return r;
  }

  // exp of the answers, not a number where the model has none; none where there is no stable
  // structure.
  std::optional<std::vector<double>> answers(const Acting& acting,
                                             const std::vector<const Hypothesis*>& together = {}) {
    StateAnswers state(models_.of(0, together), sweep_, acting, 1);
    std::vector<double> all;
    for (const Reading& r : sweep_.readings) {
      const std::optional<double> value = state.answer(r);
      if (!state.is_stable()) return std::nullopt;
      all.push_back(value ? std::exp(*value) : std::numeric_limits<double>::quiet_NaN());
    }
    return all;
  }

  Nominal nominal_ = nominal_of(mass_on_a_beam(), Measured());
  StateModels models_{nominal_};
  TestReadings sweep_;
};

TEST_F(AnswersOfAMass, is_a_resonance_of_one_degree_of_freedom) {
  const auto y = answers({});
  ASSERT_TRUE(y);
  EXPECT_NEAR((*y)[0], hertz_of_bending(width, depth), 2e-3 * (*y)[0]);
  EXPECT_NEAR((*y)[1], damping, 1e-9);
  // Of the motion of the base the mass makes sqrt(1 + 1 / (2 zeta)^2) at resonance.
  EXPECT_NEAR((*y)[2], std::sqrt(1 + 1 / std::pow(2 * damping, 2)), 5e-3 * (*y)[2]);
  EXPECT_NEAR((*y)[3], mass, 1e-3);
}

TEST_F(AnswersOfAMass, halves_its_peak_where_damping_doubles) {
  const auto once = answers({});
  Acting acting;
  acting.setup.damping = 2;
  const auto twice = answers(acting);
  ASSERT_TRUE(once && twice);
  EXPECT_NEAR((*twice)[1], 2 * damping, 1e-9);
  EXPECT_NEAR((*twice)[2] / (*once)[2], 0.5, 5e-3);
}

TEST_F(AnswersOfAMass, shows_along_its_axis_what_the_table_moves_there) {
  Acting acting;
  acting.setup.base.col(2) = Eigen::Vector3d(0.5, 0, 0); // along x in place of z
  sweep_.runs[0].axis = 0;
  for (Reading& r : sweep_.readings) r.axis = 0;
  const auto y = answers(acting);
  ASSERT_TRUE(y);
  EXPECT_NEAR((*y)[0], hertz_of_bending(depth, width), 2e-3 * (*y)[0]);
}

TEST_F(AnswersOfAMass, falls_with_a_change_by_its_coefficient) {
  Hypothesis heavier{.effect = "mass", .place = "tip", .way = "", .parameters = {}};
  heavier.changes = {{[](Model& model) { model.masses.front().body.mass *= 2; }}};
  Acting acting;
  acting.all = acting.rig =
      VectorXd::Constant(1, 3.); // three times the change: four times the mass
  const auto one = answers({}), four = answers(acting, {&heavier});
  ASSERT_TRUE(one && four);
  EXPECT_NEAR((*four)[0] / (*one)[0], 0.5, 1e-3);
  EXPECT_NEAR((*four)[3], 4 * mass, 1e-2);
}

TEST_F(AnswersOfAMass, has_none_where_the_structure_is_not_stable) {
  Hypothesis softer{.effect = "stiffness", .place = "beam", .way = "", .parameters = {}};
  softer.changes = {{[](Model& model) {
    for (BeamElement& b : model.beams)
      for (double* n : {&b.section.EA, &b.section.EI_y, &b.section.EI_z, &b.section.GJ,
                        &b.section.GA_y, &b.section.GA_z})
        *n *= 0.5;
  }}};
  Acting acting;
  acting.all = acting.rig = VectorXd::Constant(1, 3.); // 1 - 1.5 of the stiffness
  EXPECT_FALSE(answers(acting, {&softer}));
}

TEST_F(AnswersOfAMass, is_not_a_number_for_a_place_that_nobody_sees) {
  sweep_.readings = {reading(ReadingKind::amplitude, "elsewhere")};
  const auto y = answers({});
  ASSERT_TRUE(y);
  EXPECT_TRUE(std::isnan((*y)[0]));
}

std::vector<std::string> offered(const Case& data, const Measured& m,
                                 const std::vector<std::string>& further = {}) {
  const TestReadings test = readings_of({.data = m, .responses = {}});
  std::vector<std::string> all;
  for (const Offer& offer : menu(data, m, test, further)) {
    all.push_back(offer.what);
    EXPECT_GT(offer.cost, 0) << offer.what;
    EXPECT_FALSE(offer.readings.readings.empty()) << offer.what;
  }
  return all;
}

using Words = std::vector<std::string>;

TEST(Menu, offers_the_scale_and_a_sweep_along_every_axis_where_only_modes_are_known) {
  Measured m;
  changed_beam::add_modes(m, "");
  EXPECT_EQ(offered(mass_on_a_beam(), m),
            (Words{"weigh the specimen", "a sweep along x (1 m/s2)", "a sweep along y (1 m/s2)",
                   "a sweep along z (1 m/s2)"}));
}

// What was weighed in a baseline says nothing of what came after it.
TEST(Menu, offers_the_scale_until_a_later_state_was_weighed) {
  Measured m;
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  for (const MeasuredState& s : m.states) changed_beam::add_modes(m, s.name);
  const auto offers_scale = [&] {
    return offered(mass_on_a_beam(), m).front() == "weigh the specimen";
  };
  for (const char* state : {"before", "after"}) {
    EXPECT_TRUE(offers_scale()) << "before it was weighed " << state;
    m.weighings.emplace_back().value = 2;
    m.weighings.back().state = state;
  }
  EXPECT_FALSE(offers_scale());
}

// One end is held: nothing can be pulled between two. What was weighed is not weighed again.
TEST(Menu, offers_other_levels_and_further_sensors_where_a_sweep_was_run) {
  Measured m;
  m.weighings.emplace_back().value = 2;
  m.peaks.emplace_back();
  m.peaks.back().base = m.peaks.back().direction = Axis::z;
  m.peaks.back().sensor = "tip";
  m.peaks.back().level = {1, 10};
  m.peaks.back().frequency = {50, 49.9};
  EXPECT_EQ(offered(mass_on_a_beam(), m, {"beam.end"}),
            (Words{"a sweep along x (1 m/s2)", "a sweep along y (1 m/s2)",
                   "a sweep along z at a tenth of the lowest level (0.1 m/s2)",
                   "a sweep along z at three times the highest level (30 m/s2)",
                   "an accelerometer at beam.end, sweep along z"}));
}

// The first and the third mode of a beam in z; between them lie its second, and one in x.
TEST(PassedOver, is_what_lies_between_two_modes_of_no_kind_and_is_not_said_to_be_missed) {
  const Case beam = changed_beam::held_beam();
  Measured m;
  for (const int order : {1, 3}) m.modes.push_back(changed_beam::bending(Axis::z, order, ""));
  const VectorXd y = changed_beam::read_by(beam, m);
  for (std::size_t k = 0; k < 2; ++k) {
    m.modes[k].frequency = std::exp(y[Eigen::Index(k)]);
    m.modes[k].shape = MeasuredShape::other;
  }
  const Nominal nominal = nominal_of(beam, m);
  const auto words = [&] {
    return words_of_passed_over(nominal, readings_of({.data = m, .responses = {}}));
  };
  EXPECT_TRUE(words().empty()) << "orders 1 and 3";
  m.modes[1].order = 2;
  ASSERT_EQ(words().size(), 1U);
  EXPECT_EQ(words()[0].find("modes[0] and modes[1] are paired with the model's modes at "), 0U)
      << words()[0];
  const std::string past = words()[0].substr(words()[0].find("past "));
  EXPECT_EQ(past.substr(0, past.find(':')).find(','), std::string::npos) << "one in z: " << past;
}

TEST(PassedOver, an_order_beyond_all_modes_of_the_model_is_refused) {
  Measured m;
  m.modes = {changed_beam::bending(Axis::z, 1, "", 30),
             changed_beam::bending(Axis::z, 900, "", 3e6)};
  const std::string error = test::error_of(
      [&] { stated_gap(changed_beam::held_beam(), {.data = m, .responses = {}}, {}); });
  EXPECT_NE(error.find("modes[1].order: is 900, and the model has "), std::string::npos) << error;
}

} // namespace
} // namespace plica
