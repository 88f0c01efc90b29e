// Sets of effects before the verdict, on fits made up for the purpose.
#include "tests/made_up_fits.hpp"

#include "diagnose/judge/headline.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace plica {
namespace {

TEST(Judge, lists_sets_that_are_too_far_out_of_a_prior_behind_one_that_is_not) {
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add("ply_slip", 4, false);
  fits.add_pair("added_mass", "ply_slip", 20);
  fits.add_pair("added_mass", "temperature", 22).absurd = true;
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  ASSERT_EQ(j.named.size(), 2u);
  EXPECT_EQ(j.named[0]->fit.together[1]->effect, "ply_slip");
  fits.sets.front().absurd = true;
  EXPECT_NE(fits.judgement(false).verdict, Verdict::several) << "none is left that may be named";
}

TEST(Judge, takes_a_pair_only_when_each_half_is_needed) {
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add("ply_slip", 4, false);
  fits.add_pair("added_mass", "ply_slip", 15.1);
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::several);
  EXPECT_NEAR(probability(j, "added_mass"), 1, 1e-12);
  EXPECT_NEAR(probability(j, "ply_slip"), 1, 1e-12);
  Fits little; // 4.9 more than the best single one
  little.add("added_mass", 10, false);
  little.add_pair("added_mass", "ply_slip", 14.9);
  EXPECT_EQ(little.judgement(false).verdict, Verdict::unknown);
  Fits unmet;
  unmet.add("added_mass", 10, false);
  unmet.add_pair("added_mass", "ply_slip", 20).held_out_met = false;
  EXPECT_EQ(unmet.judgement(false).verdict, Verdict::unknown);
  Fits unshrunk;
  unshrunk.add("added_mass", 10, false);
  unshrunk.add_pair("added_mass", "ply_slip", 20).held_out_shrink = 0.29;
  EXPECT_EQ(unshrunk.judgement(false).verdict, Verdict::unknown);
}

// As single effects are told apart by five nats, so are sets. What they share is as sure as a list
// is.
TEST(Judge, lists_sets_of_different_effects_within_five_nats) {
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add_pair("added_mass", "ply_slip", 30);
  fits.add_pair("added_mass", "damping", 25.1);
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.named.size(), 2u);
  EXPECT_TRUE(j.names_sets());
  EXPECT_NEAR(probability(j, "added_mass"), threshold::shared_odds, 1e-12);
  EXPECT_NEAR(probability(j, "ply_slip"), threshold::shared_odds / (1 + std::exp(-4.9)), 1e-12);
  fits.sets.back().fit.log_evidence = 24.9;
  j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::several);
  EXPECT_EQ(j.named.size(), 1u);
  EXPECT_NEAR(probability(j, "added_mass"), 1, 1e-12);
}

// Of an effect at two places, one of which holds in a set a nat behind.
TEST(Judge, weighs_places_over_the_sets_that_explain_the_test) {
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add_pair("added_mass", "ply_slip", 30);
  fits.add_pair("added_mass", "ply_slip", 29);
  fits.move_last("there");
  const Judgement j = fits.judgement(false);
  ASSERT_EQ(j.verdict, Verdict::several);
  const double here = 1 / (1 + std::exp(-1));
  EXPECT_NEAR(j.probability_of("ply_slip"), 1, 1e-12);
  EXPECT_NEAR(j.share_of("ply_slip", "here"), here, 1e-12);
  EXPECT_NEAR(j.share_of("ply_slip", "there"), 1 - here, 1e-12);
  EXPECT_NEAR(j.share_of("added_mass", "here"), 1, 1e-12);
}

TEST(Judge, takes_a_larger_set_only_when_each_of_it_is_needed) {
  const std::vector<std::string> three{"added_mass", "ply_slip", "damping"};
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add_set({"added_mass", "ply_slip"}, 20, false);
  fits.add_set(three, 25.1);
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::several);
  ASSERT_EQ(j.named.size(), 1u);
  EXPECT_EQ(j.named[0]->fit.together.size(), 3u);
  Fits little; // 4.9 more than the best smaller one
  little.add("added_mass", 10, false);
  little.add_set({"added_mass", "ply_slip"}, 20.2, false);
  little.add_set(three, 25.1);
  EXPECT_EQ(little.judgement(false).verdict, Verdict::unknown);
  Fits free; // two readings for each free parameter
  free.add("added_mass", 10, false);
  JudgedFit& set = free.add_set(three, 40);
  set.readings = 6;
  set.free_parameters = 3;
  EXPECT_EQ(free.judgement(false).verdict, Verdict::unknown);
  set.readings = 9;
  EXPECT_EQ(free.judgement(false).verdict, Verdict::several);
}

TEST(Judge, takes_a_set_beside_what_explains_the_test_only_beyond_chance) {
  Fits fits;
  fits.add("added_mass", 10);
  fits.add_set({"added_mass", "ply_slip"}, 16.9);
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::identified);
  fits.sets.back().fit.log_evidence = 17.1;
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::several);
}

// Ten effects would do beside damping: one just met the held-out readings and was named.
TEST(Judge, names_no_set_of_which_too_many_are_as_good) {
  Fits fits;
  fits.add("damping", 10, false);
  fits.add_set({"damping", "local_damage"}, 20);
  fits.add_set({"damping", "forming_thinning"}, 22).held_out_shrink = 0.29;
  fits.add_set({"damping", "ply_slip"}, 21).held_out_shrink = 0.29;
  Judgement j = fits.judgement(false);
  ASSERT_EQ(j.named.size(), 3u) << "rivals are listed whatever they foretell";
  EXPECT_EQ(j.named[0]->fit.together[1]->effect, "local_damage");
  EXPECT_LT(probability(j, "local_damage"), 0.1);
  Fits flat; // what they share is left
  flat.add_gap("damping", 1.3);
  for (const char* other : {"local_damage", "forming_thinning", "ply_slip", "temperature"})
    Fits::leave(flat.add_pair("damping", other, 0), 0.3);
  j = flat.judgement_of_gaps(5);
  ASSERT_EQ(j.verdict, Verdict::mostly);
  EXPECT_EQ(j.named[0]->fit.effects(), std::vector<std::string>{"damping"});
}

// An effect that explains the test is not sure beside sets with it that are far ahead, however
// many.
TEST(Judge, is_not_sure_of_an_effect_that_many_sets_share) {
  Fits fits;
  fits.add("added_mass", 10);
  for (const char* other : {"local_damage", "forming_thinning", "ply_slip", "temperature"}) {
    fits.add_pair("added_mass", other, 20);
    const Judgement j = fits.judgement(false);
    EXPECT_EQ(j.verdict, fits.sets.size() == 1 ? Verdict::several : Verdict::ambiguous);
    if (fits.sets.size() > 1) {
      EXPECT_LE(probability(j, "added_mass"), threshold::shared_odds) << other;
      EXPECT_NE(j.withheld, "") << other;
    }
  }
}

// What was solved for what they share, which was refused, is not of these sets: a diagnosis that
// took it for theirs ended in a crash.
TEST(Judge, lists_sets_without_what_was_asked_of_what_they_share) {
  Fits flat;
  flat.add_gap("damping", 1.3);
  for (const char* other : {"local_damage", "forming_thinning", "ply_slip", "temperature"})
    Fits::leave(flat.add_pair("damping", other, 0), 0.3);
  const Referee strict{.to_most = [](const JudgedFit& lead) -> Objection {
    return {.why = "it closes 40 % of the gap", .in_turn = GapShrink{}, .sampled = lead.fit};
  }};
  const Judgement j = flat.judgement_of_gaps(5, strict);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_LT(probability(j, "damping"), threshold::even_odds) << "it failed a test of its own";
  EXPECT_EQ(j.named.size(), 3u);
  EXPECT_FALSE(j.sampled);
  EXPECT_FALSE(j.in_turn);
}

// Ten pairs explain the test, and nothing that they share leads: none is named, and none is
// unknown.
TEST(Judge, lists_sets_where_too_many_explain_the_test) {
  Fits fits;
  for (const char* end : {"boundary_compliance", "local_damage"}) fits.add(end, 10, false);
  for (const char* end : {"boundary_compliance", "local_damage"})
    for (const char* warm : {"damping", "temperature"}) fits.add_pair(end, warm, 20);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  ASSERT_EQ(j.named.size(), 3u);
  EXPECT_TRUE(j.names_sets());
  EXPECT_EQ(j.withheld, "4 sets of effects explain the test alike");
  EXPECT_EQ(headline(fits.nominal(false), j),
            "Ambiguous: boundary_compliance at here and damping at here; or boundary_compliance at "
            "here and temperature at here; or local_damage at here and damping at here; 4 sets of "
            "effects explain the test alike");
}

// Springs under a beam and a mass on it read as a fixture of four numbers, and were called one.
TEST(Judge, is_not_sure_of_an_effect_beside_a_set_without_it) {
  Fits fits;
  fits.add("fixture_flexibility", 20);
  fits.add("boundary_compliance", 12, false);
  fits.add_pair("boundary_compliance", "added_mass", 17.1);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.withheld, "boundary_compliance at here and added_mass at here explain as much");
  EXPECT_EQ(headline(fits.nominal(false), j).rfind("Perhaps fixture_flexibility at here", 0), 0u);
  fits.sets.back().fit.log_evidence = 16.9;
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::identified);
  Fits with_it; // whatever else there is
  with_it.add("fixture_flexibility", 20);
  with_it.add_pair("fixture_flexibility", "added_mass", 20);
  EXPECT_EQ(with_it.judgement(false).verdict, Verdict::identified);
}

// A friction and a dent were called the cause where a mass was missing: the law of slip was allowed
// to be off by what the mass did.
TEST(Judge, does_not_say_several_where_a_law_of_slip_leaves_a_tenth_of_the_gap) {
  Fits fits;
  fits.add_gap("joint_friction", 4);
  fits.add_gap("local_damage", 11);
  JudgedFit& set = fits.add_pair("joint_friction", "local_damage", 0);
  Fits::leave(set, 3);
  EXPECT_EQ(fits.judgement_of_gaps(12).verdict, Verdict::several) << "a sixteenth";
  Fits::leave(set, 3.9);
  EXPECT_EQ(fits.judgement_of_gaps(12).verdict, Verdict::mostly);
  const Referee strict{.to_all = {}, .to_most = [](const JudgedFit& lead) -> Objection {
                         if (lead.fit.together.size() == 1) return {};
                         return {.why = "closes 1 %", .small = {lead.fit.together[1]}};
                       }};
  fits.sets.back().fit.together[0] = fits.singles[0].fit.together[0];
  const Judgement j = fits.judgement_of_gaps(12, strict);
  EXPECT_EQ(j.verdict, Verdict::mostly);
  ASSERT_EQ(j.named.size(), 1u);
  EXPECT_EQ(j.named[0]->fit.effects(), std::vector<std::string>{"joint_friction"});
}

// A mass of the liner was named where a mass of a cap and one spread over the wall explain the test
// as well: another place of the same effect is another cause.
TEST(Judge, is_not_sure_of_a_place_beside_a_set_with_another) {
  Fits fits;
  fits.add("component_mass", 20, true, "interlock");
  fits.add("component_mass", 2, false, "cap");
  fits.add("unweighed_mass", 12, false);
  JudgedFit& set = fits.add_pair("component_mass", "unweighed_mass", 18);
  set.fit.together[0] = fits.singles[1].fit.together[0];
  set.fit.together[1] = fits.singles[2].fit.together[0];
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.withheld, "component_mass at cap and unweighed_mass at here explain as much");
  fits.singles[2].fit.log_evidence = 15.5; // explains nearly as much without the cap
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::identified);
}

// What a stranger does is imitated to the edge of what is adequate, where few that are healthy lie.
TEST(Judge, is_not_sure_of_what_leaves_more_than_nine_of_ten_healthy_specimens) {
  Fits single;
  JudgedFit& mass = single.add_gap("added_mass", 1);
  mass.adequate = mass.at_the_edge = true;
  Judgement j = single.judgement_of_gaps(12);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.withheld, "nine of ten healthy specimens leave less");
  EXPECT_NEAR(j.probability_of("added_mass"), 0.5, 0.01);
  Fits fits;
  fits.add_gap("added_mass", 4);
  fits.add_gap("sensor_gain", 11);
  JudgedFit& set = fits.add_pair("added_mass", "sensor_gain", 0);
  Fits::leave(set, 1);
  set.at_the_edge = true;
  j = fits.judgement_of_gaps(12);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_TRUE(j.names_sets());
  EXPECT_NEAR(j.probability_of("added_mass"), 0.5, 0.01);
  EXPECT_EQ(headline(fits.nominal(false), j),
            "Ambiguous: added_mass at here and sensor_gain at here; nine of ten healthy specimens "
            "leave less");
  fits.sets.back().at_the_edge = false;
  EXPECT_EQ(fits.judgement_of_gaps(12).verdict, Verdict::several);
}

// Slip of the plies was named with 1,375 % of the gap, beside a mass and a support that open it
// again: neither was there.
TEST(Judge, is_not_sure_of_effects_that_cancel) {
  Fits fits;
  fits.add_gap("added_mass", 4);
  fits.add_gap("sensor_gain", 11);
  Fits::leave(fits.add_pair("added_mass", "sensor_gain", 0), 1);
  const JudgedFit* asked = nullptr;
  const Referee cancelling{.to_sets = [&](const JudgedFit& lead) -> Objection {
    asked = &lead;
    return {"the effects cancel"};
  }};
  Judgement j = fits.judgement_of_gaps(12, cancelling);
  EXPECT_EQ(asked, &fits.sets.front());
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_TRUE(j.names_sets());
  EXPECT_NEAR(j.probability_of("added_mass"), 0.5, 0.01);
  EXPECT_EQ(headline(fits.nominal(false), j),
            "Ambiguous: added_mass at here and sensor_gain at here; the effects cancel");
}

// Of pairs that explain the test none is five nats ahead of one of its halves.
TEST(Judge, says_not_settled_of_what_explains_the_test_but_is_not_far_ahead) {
  Fits fits;
  for (const char* end : {"boundary_compliance", "local_damage"}) fits.add_gap(end, 1);
  for (const char* end : {"boundary_compliance", "local_damage"})
    for (const char* warm : {"damping", "temperature"})
      Fits::leave(fits.add_pair(end, warm, 0), 0.5);
  const Judgement j = fits.judgement_of_gaps(5);
  EXPECT_EQ(j.verdict, Verdict::unknown);
  ASSERT_TRUE(j.nearest);
  JudgedFit nominal = fits.nominal(false);
  Fits::leave(nominal, 5);
  EXPECT_EQ(
      headline(nominal, j),
      "Not settled: boundary_compliance at here and damping at here would explain the test and "
      "close 99 % of the gap, not far enough ahead of what else would");
}

} // namespace
} // namespace plica
