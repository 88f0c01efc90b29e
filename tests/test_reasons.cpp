// Why what leads must not be named, of numbers made up for the purpose: either side of every
// threshold.
#include "tests/made_up_fits.hpp"

#include "diagnose/judge/reasons.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace plica {
namespace {

JudgedFit leading(double gap_after, const Hypothesis& h) {
  JudgedFit j;
  j.gap_after = gap_after;
  j.fit.together = {&h};
  return j;
}

Hypothesis acting(const char* effect, const char* place = "here") {
  return {.effect = effect, .place = place, .way = "", .parameters = {}};
}

GapShrink foretold(double low) {
  return {.before = 1, .after = 0.8, .interval = {low, 0.4}, .readings = 10};
}

TEST(Reasons, ask_that_readings_are_foretold_better_than_by_no_effect) {
  EXPECT_EQ(in_turn_no_better(foretold(0.01)), "");
  EXPECT_EQ(in_turn_no_better(foretold(0)),
            "taken in turn, readings are foretold no better with it (shrink 20 % [0, 40])");
  EXPECT_EQ(held_out_no_better(foretold(0.01)), "");
  EXPECT_EQ(held_out_no_better(foretold(-0.1)),
            "held-out readings are foretold no better with it (shrink 20 % [-10, 40])");
}

TEST(Reasons, warn_only_where_fewer_than_four_readings_are_taken_in_turn) {
  const Hypothesis mass = acting("added_mass");
  const JudgedFit lead = leading(0.5, mass);
  const std::string words =
      "taken in turn, readings are foretold no better with it (shrink 20 % [-10, 40])";
  Objection found = foretells(lead, foretold(-0.1), 4);
  EXPECT_EQ(found.why, words);
  EXPECT_EQ(found.warning, "");
  ASSERT_TRUE(found.in_turn);
  found = foretells(lead, foretold(-0.1), 3);
  EXPECT_EQ(found.why, "");
  EXPECT_EQ(found.warning, "added_mass at here: " + words);
  ASSERT_TRUE(found.in_turn);
  EXPECT_EQ(found.in_turn->interval[0], -0.1);
  found = foretells(lead, foretold(0.1), 3);
  EXPECT_TRUE(found.why.empty() && found.warning.empty() && found.in_turn);
}

TEST(Reasons, ask_that_half_of_the_gap_is_closed_at_the_lower_end_of_the_interval) {
  Ledger ledger;
  ledger.explained = 0.7;
  ledger.explained_interval = {0.5, 0.8};
  EXPECT_EQ(closes_too_little(ledger), "");
  ledger.explained_interval[0] = 0.49;
  EXPECT_EQ(closes_too_little(ledger), "it closes 70 % of the gap [49, 80]");
  EXPECT_EQ(closes_too_little(ledger, " beside it"),
            "it closes 70 % of the gap [49, 80] beside it");
}

TEST(Reasons, name_the_members_that_close_less_than_a_tenth) {
  const Hypothesis mass = acting("added_mass"), gain = acting("sensor_gain", "tip");
  HypothesisFit fit;
  fit.together = {&mass, &gain};
  const auto of = [&](double first, double second) {
    Ledger ledger;
    ledger.rows = {
        {.share = first}, {.share = second}, {.left = Remainder::unexplained, .share = 0.1}};
    return members_of_little(ledger, fit);
  };
  EXPECT_EQ(of(0.8, 0.1).why, "");
  const Objection little = of(0.8, 0.03);
  EXPECT_EQ(little.why, "sensor_gain at tip closes 3.0 % of the gap only");
  EXPECT_EQ(little.small, std::vector<const Hypothesis*>{&gain});
  const Objection both = of(0.09, 0.03);
  EXPECT_FALSE(both.why.empty());
  EXPECT_TRUE(both.small.empty()) << "nothing would be left of the set";
  fit.together = {&mass};
  EXPECT_EQ(of(0.03, 0).why, "") << "one alone closes what it closes";
}

TEST(Reasons, hold_against_effects_that_together_they_open_ten_times_the_gap) {
  EXPECT_EQ(cancel(Eigen::Vector2d(11, -10)), "");
  EXPECT_EQ(cancel(Eigen::Vector3d(13.2, -6, -6.2)),
            "the effects cancel: some open 12.2 times the gap, which the others close");
  EXPECT_EQ(cancel(Eigen::Vector2d(20, 30)), "") << "none is opened";
}

TEST(Reasons, do_not_hold_a_factor_against_the_effect_that_is_one) {
  const auto like = [](FreeFactor factor, const char* effect, bool beside_baseline) {
    const Hypothesis h = acting(effect);
    return is_like({.on = factor, .name = "", .held_out_after = {}, .contradicted_by = ""},
                   leading(0, h).fit, beside_baseline);
  };
  for (bool beside : {false, true}) {
    EXPECT_TRUE(like(FreeFactor::damping, "damping", beside));
    EXPECT_TRUE(like(FreeFactor::modulus, "temperature", beside));
    EXPECT_FALSE(like(FreeFactor::density, "temperature", beside));
    EXPECT_FALSE(like(FreeFactor::modulus, "added_mass", beside));
  }
  // A drawing may be as wrong; the specimen was its own drawing.
  for (const char* effect : {"ply_slip", "component_stiffness", "forming_thinning"}) {
    EXPECT_TRUE(like(FreeFactor::modulus, effect, false)) << effect;
    EXPECT_FALSE(like(FreeFactor::modulus, effect, true)) << effect;
  }
  EXPECT_TRUE(like(FreeFactor::density, "unweighed_mass", false));
  EXPECT_FALSE(like(FreeFactor::density, "unweighed_mass", true));
}

TEST(Reasons, hold_a_factor_on_everything_against_what_leaves_no_less) {
  const Hypothesis mass = acting("added_mass"), hot = acting("temperature");
  const auto beside = [](double gap_after) {
    return std::vector<Compensator>{{.on = FreeFactor::modulus,
                                     .name = "Young's modulus",
                                     .factor = 0.9,
                                     .gap_after = gap_after,
                                     .held_out_after = {},
                                     .contradicted_by = ""}};
  };
  EXPECT_EQ(imitated(leading(2, mass), {}, false), "");
  EXPECT_EQ(imitated(leading(2, mass), beside(2.5), false), "") << "a fifth more, and a little";
  EXPECT_EQ(imitated(leading(2, mass), beside(2.3), false),
            "Young's modulus times 0.9 would leave no more of the gap (2.3, 2 with it)");
  EXPECT_EQ(imitated(leading(2, hot), beside(2.3), false), "");
}

// Of the gap its square.
TEST(Reasons, ask_that_what_explains_the_test_closes_half_of_it) {
  const Hypothesis mass = acting("added_mass");
  EXPECT_EQ(closes_less_than_half(leading(0.70, mass), 1), "");
  EXPECT_EQ(closes_less_than_half(leading(0.72, mass), 1), "it closes 48 % of the gap");
  EXPECT_EQ(closes_less_than_half(leading(1.2, mass), 1), "it closes -44 % of the gap");
}

TEST(Reasons, let_an_effect_beside_a_baseline_leave_three_tenths_of_the_change_or_what_is_allowed) {
  const Hypothesis mass = acting("added_mass");
  EXPECT_EQ(leaves_of_the_change(leading(1.4, mass), 2), "") << "allowed to any";
  EXPECT_EQ(leaves_of_the_change(leading(1.6, mass), 2), "it leaves 80 % of the change");
  EXPECT_EQ(leaves_of_the_change(leading(2.9, mass), 10), "");
  EXPECT_EQ(leaves_of_the_change(leading(3.1, mass), 10), "it leaves 31 % of the change");
}

// Of ten readings the mass leaves twice their errors, the resonator just these: with
// ln Z = -(4 + n) / 2 ln(1 + chi2 / 4) it is 7 ln(11 / 3.5) = 8.02 nats ahead.
class ResonatorExplains : public testing::Test {
protected:
  static JudgedFit fit_of(const Hypothesis& h, const Eigen::VectorXd& values, double error) {
    JudgedFit j;
    j.gap_after = error;
    j.readings = j.moved = 10;
    j.free_parameters = int(values.size());
    j.fit.together = {&h};
    j.fit.z = Eigen::VectorXd::Zero(values.size());
    j.fit.values = values;
    j.fit.error = Eigen::VectorXd::Constant(10, error);
    j.fit.J = Eigen::MatrixXd::Zero(10, values.size());
    j.fit.chi2 = j.fit.error.squaredNorm();
    return j;
  }
  static Hypothesis hanging() {
    Hypothesis h = acting("resonator", "beam.point[3]");
    h.parameters = {{"mass", "kg", {}}, {"frequency", "Hz", {}}};
    return h;
  }
  bool explains(const std::optional<std::array<double, 2>>& band, double nats = 8) const {
    return resonator_explains(lead_, rival_, band, nats);
  }

  const Hypothesis mass_ = acting("added_mass"), resonator_ = hanging();
  const JudgedFit lead_ = fit_of(mass_, Eigen::VectorXd::Constant(1, 0.01), 2);
  const std::array<double, 2> band_{100, 900}; // Hz
  JudgedFit rival_ = fit_of(resonator_, Eigen::Vector2d(0.015, 805), 1);
};

TEST_F(ResonatorExplains, what_leads_where_it_is_so_many_nats_ahead) {
  EXPECT_TRUE(explains(band_));
  EXPECT_FALSE(explains(band_, 8.1));
}

TEST_F(ResonatorExplains, is_said_with_its_mass_its_frequency_and_its_place) {
  EXPECT_EQ(words_of_last(rival_.fit),
            "15 g on a spring of its own, which resonates at 805 Hz, at beam.point[3]");
}

TEST_F(ResonatorExplains, what_leads_among_the_frequencies_that_were_measured) {
  EXPECT_FALSE(explains({{100, 800}})) << "a mass, for all that was measured";
  EXPECT_FALSE(explains({{810, 900}})) << "a spring";
  EXPECT_TRUE(explains(std::nullopt));
}

TEST_F(ResonatorExplains, nothing_where_it_is_not_believed_itself) {
  for (bool JudgedFit::*doubt : {&JudgedFit::absurd, &JudgedFit::fails_held_out}) {
    rival_.*doubt = true;
    EXPECT_FALSE(explains(band_));
    rival_.*doubt = false;
  }
  rival_.moved = 3;
  EXPECT_FALSE(explains(band_)) << "two free parameters for three readings that they move";
}

} // namespace
} // namespace plica
