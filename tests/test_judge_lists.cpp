// Lists of the verdict, what it hands on, and what it asks and does not ask: on fits made up for
// the purpose.
#include "tests/made_up_fits.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace plica {
namespace {

std::vector<std::string> effects_named(const Judgement& judgement) {
  std::vector<std::string> names;
  for (const JudgedFit* j : judgement.named)
    for (const std::string& effect : j->fit.effects()) names.push_back(effect);
  return names;
}

using Words = std::vector<std::string>;

bool is_over(const Judgement& j, Weighing::Over over, bool limited = false) {
  return j.weighing.over == over && j.weighing.limited == limited;
}

GapShrink shrunk_to(double after) {
  return {.before = 1, .after = after, .interval = {0.1, 0.9}, .readings = 10};
}

TEST(Judge, identifies_an_effect_of_a_test_that_the_nominal_case_explains_too) {
  Fits fits;
  fits.add("added_mass", 3.1);
  const Judgement j = fits.judgement(true);
  EXPECT_EQ(j.verdict, Verdict::identified);
  EXPECT_NEAR(probability(j, "added_mass"), std::exp(3.1) / (1 + std::exp(3.1)), 1e-12);
}

TEST(Judge, says_mostly_of_what_names_a_place_and_no_cause) {
  Fits fits;
  fits.add("component_stiffness", 10);
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::identified);
  fits.leave_cause_open();
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::mostly);
  EXPECT_EQ(effects_named(j), Words{"component_stiffness"});
  EXPECT_TRUE(j.is_settled());
  EXPECT_TRUE(is_over(j, Weighing::Over::singles));
  Fits sets;
  sets.add("added_mass", 10, false);
  sets.add_pair("added_mass", "component_stiffness", 20);
  EXPECT_EQ(sets.judgement(false).verdict, Verdict::several);
  sets.leave_cause_open();
  const Judgement of_sets = sets.judgement(false);
  EXPECT_EQ(of_sets.verdict, Verdict::mostly);
  EXPECT_EQ(of_sets.named.front()->fit.together.size(), 2u);
  EXPECT_TRUE(is_over(of_sets, Weighing::Over::standing_sets));
}

// Whatever the verdict: of one effect, of one that nobody believes, of sets, of what is nearest.
TEST(Judge, says_what_its_probabilities_are_of) {
  Fits one;
  one.add("added_mass", 10);
  EXPECT_TRUE(is_over(one.judgement(false), Weighing::Over::singles));
  const Referee strict{.to_all = [](const JudgedFit&) -> Objection { return {.why = "no"}; }};
  EXPECT_TRUE(is_over(one.judgement(false, strict), Weighing::Over::singles, true));
  Fits sets;
  sets.add("added_mass", 10, false);
  sets.add_pair("added_mass", "ply_slip", 30);
  EXPECT_TRUE(is_over(sets.judgement(false), Weighing::Over::standing_sets));
  sets.add_pair("added_mass", "temperature", 29);
  EXPECT_TRUE(is_over(sets.judgement(false), Weighing::Over::standing_sets, true));
  Fits many; // of which nothing leads
  for (const char* end : {"boundary_compliance", "local_damage"}) {
    many.add(end, 10, false);
    for (const char* warm : {"damping", "temperature"}) many.add_pair(end, warm, 20);
  }
  EXPECT_EQ(many.judgement(false).verdict, Verdict::ambiguous);
  EXPECT_TRUE(is_over(many.judgement(false), Weighing::Over::all_sets, true));
  Fits nearest;
  nearest.add_gap("ply_slip", 2);
  EXPECT_EQ(nearest.judgement_of_gaps(6.8).verdict, Verdict::mostly);
  EXPECT_TRUE(is_over(nearest.judgement_of_gaps(6.8), Weighing::Over::all_sets));
  nearest.add_gap("temperature", 2.2);
  EXPECT_EQ(nearest.judgement_of_gaps(6.8).verdict, Verdict::unknown);
  EXPECT_TRUE(is_over(nearest.judgement_of_gaps(6.8), Weighing::Over::all_sets, true));
}

TEST(Judge, lists_three_within_five_nats_and_a_fourth_within_three) {
  Fits fits;
  fits.add("added_mass", 20);
  fits.add("damping", 19);
  fits.add("ply_slip", 15.1);
  fits.add("temperature", 15.05);
  EXPECT_EQ(effects_named(fits.judgement(false)), (Words{"added_mass", "damping", "ply_slip"}));
  fits.singles[2].fit.log_evidence = 18;
  fits.singles[3].fit.log_evidence = 16.9; // 3.1 behind
  EXPECT_EQ(fits.judgement(false).named.size(), 3u);
  fits.singles[3].fit.log_evidence = 17.1;
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(effects_named(j), (Words{"added_mass", "damping", "ply_slip", "temperature"}));
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_TRUE(j.withheld.empty());
}

TEST(Judge, lists_rivals_far_out_of_their_priors_up_to_three_in_all) {
  Fits fits;
  fits.add("added_mass", 20);
  fits.add("damping", 19);
  fits.add("ply_slip", 21).absurd = true; // though it leads
  fits.add("temperature", 18).absurd = true;
  EXPECT_EQ(effects_named(fits.judgement(false)), (Words{"added_mass", "damping", "ply_slip"}));
  fits.singles[2].fit.log_evidence = 14.9; // told apart
  EXPECT_EQ(effects_named(fits.judgement(false)), (Words{"added_mass", "damping", "temperature"}));
  fits.add("local_damage", 18.5);
  EXPECT_EQ(effects_named(fits.judgement(false)), (Words{"added_mass", "damping", "local_damage"}));
}

// Within a list none is sure anyhow.
TEST(Judge, asks_of_an_effect_at_the_edge_only_where_it_stands_alone) {
  Fits fits;
  fits.add("added_mass", 20).at_the_edge = true;
  fits.add("damping", 18);
  int asked = 0;
  const Referee counting{.to_all = [&](const JudgedFit&) -> Objection {
    ++asked;
    return {};
  }};
  Judgement j = fits.judgement(false, counting);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_TRUE(j.withheld.empty());
  fits.singles[1].fit.log_evidence = 14;
  j = fits.judgement(false, counting);
  EXPECT_EQ(j.withheld, "nine of ten healthy specimens leave less");
  EXPECT_EQ(effects_named(j), (Words{"added_mass", "damping"})) << "6 nats behind";
  EXPECT_EQ(asked, 0) << "what is withheld takes no solution of its own";
  fits.singles[0].at_the_edge = false;
  EXPECT_EQ(fits.judgement(false, counting).verdict, Verdict::identified);
  EXPECT_EQ(asked, 1);
}

TEST(Judge, opens_the_list_to_eight_nats_where_what_leads_is_not_believed) {
  Fits fits;
  fits.add("added_mass", 20);
  fits.add("damping", 12.1);
  fits.add("temperature", 11.9);
  const JudgedFit* asked = nullptr;
  const Referee strict{.to_all = [&](const JudgedFit& lead) -> Objection {
    asked = &lead;
    return {.why = "it closes 40 % of the gap", .in_turn = shrunk_to(0.8)};
  }};
  Judgement j = fits.judgement(false, strict);
  EXPECT_EQ(asked, &fits.singles.front());
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.withheld, "it closes 40 % of the gap");
  EXPECT_FALSE(j.is_settled());
  EXPECT_EQ(effects_named(j), (Words{"added_mass", "damping"}));
  ASSERT_TRUE(j.in_turn);
  EXPECT_EQ(j.in_turn->after, 0.8);
  fits.add("ply_slip", 13);
  fits.add("local_damage", 12.5);
  EXPECT_EQ(effects_named(fits.judgement(false, strict)),
            (Words{"added_mass", "ply_slip", "local_damage"}))
      << "three of those";
}

TEST(Judge, hands_on_what_was_found_of_an_effect_that_nobody_objects_to) {
  Fits fits;
  fits.add("added_mass", 20);
  const Referee mild{.to_all = [](const JudgedFit&) -> Objection {
    return {.why = "", .in_turn = shrunk_to(0.3), .warning = "three readings"};
  }};
  const Judgement j = fits.judgement(false, mild);
  EXPECT_EQ(j.verdict, Verdict::identified);
  ASSERT_TRUE(j.in_turn);
  EXPECT_EQ(j.in_turn->after, 0.3);
  EXPECT_EQ(j.warning, "three readings");
}

TEST(Judge, drops_sets_five_nats_behind_the_best) {
  Fits fits;
  fits.add("added_mass", 8, false);
  fits.add_pair("added_mass", "ply_slip", 20);
  fits.add_pair("added_mass", "temperature", 15);
  EXPECT_EQ(fits.judgement(false).named.size(), 1u);
  fits.sets.back().fit.log_evidence = 15.1;
  EXPECT_EQ(fits.judgement(false).named.size(), 2u);
}

// Four sets that explain the test alike are too many, but not where they have the same effects.
TEST(Judge, counts_the_same_effects_elsewhere_once) {
  Fits fits;
  fits.add("added_mass", 8, false);
  for (double nats : {20., 19.5, 19., 18.5}) fits.add_pair("added_mass", "ply_slip", nats);
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::several);
  EXPECT_EQ(j.named.size(), 4u);
  const Referee strict{
      .to_sets = [](const JudgedFit&) -> Objection { return {"the effects cancel"}; }};
  j = fits.judgement(false, strict);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.named.size(), 1u) << "one of each choice of effects";
}

TEST(Judge, lists_no_set_of_which_a_member_is_not_needed) {
  Fits fits;
  fits.add("added_mass", 8, false);
  fits.add("temperature", 13.5, false);
  fits.add_pair("added_mass", "ply_slip", 20);
  fits.add_pair("temperature", "damping", 16); // 2.5 more than temperature alone
  fits.add_set({"added_mass", "ply_slip", "damping"}, 21);
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::several);
  EXPECT_EQ(effects_named(j), (Words{"added_mass", "ply_slip"}));
  fits.singles[1].fit.log_evidence = 12.9;
  EXPECT_EQ(fits.judgement(false).named.size(), 2u);
}

TEST(Judge, is_sure_beside_a_set_of_which_a_member_is_not_needed) {
  Fits fits;
  fits.add("fixture_flexibility", 20);
  fits.add("boundary_compliance", 15.5, false);
  fits.add_pair("boundary_compliance", "added_mass", 18); // 2.5 more
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::identified);
  fits.singles[1].fit.log_evidence = 14.9;
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::ambiguous);
}

// Of ten readings: of the 6.8^2 of the gap 2^2 are left, and an effect beside it is nearly as good.
TEST(Judge, claims_of_what_is_unknown_no_more_than_is_closed) {
  Fits fits;
  fits.add_gap("ply_slip", 2);
  fits.add_gap("temperature", 2.2);
  const Judgement j = fits.judgement_of_gaps(6.8);
  ASSERT_EQ(j.verdict, Verdict::unknown);
  EXPECT_TRUE(j.withheld.empty());
  JudgedFit nominal = fits.nominal(false);
  Fits::leave(nominal, 6.8);
  const Inclusion inclusion(nominal, fits.singles, fits.sets);
  const double closed = 1 - std::pow(2 / 6.8, 2);
  EXPECT_NEAR(j.probability_of("ply_slip"), closed * inclusion.of("ply_slip"), 1e-12);
  EXPECT_NEAR(j.probability_of("temperature"), closed * inclusion.of("temperature"), 1e-12);
  EXPECT_NEAR(j.probability_of("none"), inclusion.none(), 1e-12) << "as it was";
  const Judgement stopped = nearest_so_far(nominal, inclusion);
  EXPECT_NEAR(stopped.probability_of("ply_slip"), closed * inclusion.of("ply_slip") / 2, 1e-12);
}

// What explains nothing of a gap of 6.8 in ten readings, where mounting anew may.
TEST(Judge, says_none_of_a_change_that_mounting_anew_may_have_made_and_nothing_else) {
  Fits fits;
  fits.add_gap("added_mass", 6.8).explains_nothing = true;
  Judgement j = fits.judgement_of_gaps(6.8);
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_FALSE(j.mounted_anew);
  const Referee anew{.mounted_anew = true};
  j = fits.judgement_of_gaps(6.8, anew);
  EXPECT_EQ(j.verdict, Verdict::none);
  EXPECT_TRUE(j.mounted_anew);
  EXPECT_TRUE(j.named.empty());
  fits.add_gap("damping", 5); // comes nearer
  j = fits.judgement_of_gaps(6.8, anew);
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_FALSE(j.mounted_anew);
  EXPECT_FALSE(fits.judgement(true, anew).mounted_anew) << "the nominal case explains the test";
}

// A pair that leaves 1.8 of a gap of 20, its first effect alone 4.
class MostOfThePair : public testing::Test {
protected:
  MostOfThePair() {
    fits_.add_gap("added_mass", 4);
    fits_.add_gap("sensor_gain", 19);
    Fits::leave(fits_.add_set({"added_mass", "sensor_gain"}, 0, false), 1.8);
  }
  // The members are those that were tried alone.
  void share_members() {
    for (std::size_t i : {std::size_t{0}, std::size_t{1}})
      fits_.sets.front().fit.together[i] = fits_.singles[i].fit.together[0];
  }
  // The pair is objected to for its second member.
  Judgement without_the_second() {
    const Referee strict{.to_most = [](const JudgedFit& lead) -> Objection {
      if (lead.fit.together.size() == 1) return {};
      return {.why = "sensor_gain closes 3 %",
              .in_turn = {},
              .sampled = lead.fit,
              .small = {lead.fit.together[1]}};
    }};
    return fits_.judgement_of_gaps(20, strict);
  }
  Fits fits_;
};

TEST_F(MostOfThePair, is_handed_on_with_what_was_solved_for_it) {
  const Referee mild{.to_most = [](const JudgedFit& lead) -> Objection {
    return {.why = "", .in_turn = shrunk_to(0.4), .sampled = lead.fit};
  }};
  const Judgement j = fits_.judgement_of_gaps(20, mild);
  EXPECT_EQ(j.verdict, Verdict::mostly);
  EXPECT_EQ(effects_named(j), (Words{"added_mass", "sensor_gain"}));
  ASSERT_TRUE(j.sampled && j.in_turn);
  EXPECT_EQ(j.sampled->together.size(), 2u);
  EXPECT_EQ(j.in_turn->after, 0.4);
}

TEST_F(MostOfThePair, hands_on_the_resonator_that_it_was_not_named_for) {
  JudgedFit hanging = fits_.singles.front();
  hanging.gap_after = 0.7;
  const Referee strict{.to_most = [&](const JudgedFit&) -> Objection {
    return {.why = "it may hang on a spring", .resonator = hanging};
  }};
  const Judgement j = fits_.judgement_of_gaps(20, strict);
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_EQ(j.withheld, "it may hang on a spring");
  ASSERT_TRUE(j.resonator);
  EXPECT_EQ(j.resonator->gap_after, 0.7);
}

TEST_F(MostOfThePair, is_unknown_where_what_is_left_of_it_was_not_tried) {
  const Judgement j = without_the_second(); // its first member is another hypothesis
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_EQ(j.withheld, "sensor_gain closes 3 %");
  EXPECT_EQ(j.nearest, &fits_.sets.front());
  EXPECT_TRUE(j.sampled) << "of what comes nearest";
  EXPECT_NEAR(j.probability_of("added_mass"), 0.5, 0.01);
}

TEST_F(MostOfThePair, does_not_lend_its_draws_to_what_is_left_of_it) {
  share_members();
  fits_.singles.front().absurd = true;
  const Judgement j = without_the_second();
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_EQ(j.withheld, "only with a value far out of its prior");
  EXPECT_EQ(j.nearest, &fits_.singles.front());
  EXPECT_FALSE(j.sampled);
  fits_.singles.front().absurd = false;
  EXPECT_EQ(without_the_second().verdict, Verdict::mostly);
}

} // namespace
} // namespace plica
