// What a verdict says in one line, on fits made up for the purpose.
#include "tests/made_up_fits.hpp"

#include "diagnose/judge/headline.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace plica {
namespace {

// Of a specimen that leaves this much of ten readings each, most of it in its second mode.
JudgedFit specimen(double gap) {
  JudgedFit nominal = Fits().nominal(false);
  Fits::leave(nominal, gap);
  nominal.worst = {4, "frequency of mode 2"};
  return nominal;
}

TEST(Headline, of_a_healthy_specimen_says_that_nothing_is_needed) {
  Fits fits;
  EXPECT_EQ(headline(fits.nominal(true), fits.judgement(true)),
            "No effect: the nominal case explains the test within its uncertainties");
}

TEST(Headline, of_an_effect_says_its_odds_over_nothing_and_over_the_next) {
  Fits fits;
  fits.add("added_mass", std::log(500.));
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)),
            "added_mass at here (odds 500:1 over no effect)");
  fits.add("ply_slip", std::log(2.));
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)),
            "added_mass at here (odds 500:1 over no effect, odds 250:1 over ply_slip)");
  Fits far;
  far.add("added_mass", 14); // 1.2 million
  EXPECT_EQ(headline(specimen(1), far.judgement(false)),
            "added_mass at here (odds above a million to one over no effect)");
}

TEST(Headline, says_how_sure_the_place_is_where_it_is_not) {
  Fits fits;
  fits.add("added_mass", std::log(900.), true, "left");
  fits.add("added_mass", std::log(300.), true, "right");
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)),
            "added_mass at left (odds 900:1 over no effect); the place 75 %, right 25 %");
}

TEST(Headline, of_a_list_gives_each_its_share) {
  Fits fits;
  fits.add("added_mass", 10);
  fits.add("local_damage", 10);
  const std::string words = headline(specimen(1), fits.judgement(false));
  EXPECT_TRUE(words == "Ambiguous: added_mass at here 50 % or local_damage at here 50 %" ||
              words == "Ambiguous: local_damage at here 50 % or added_mass at here 50 %")
      << words;
}

// In a list odds of 2 to 1 count as 2^(ln 9 / 5) to 1.
TEST(Headline, of_a_list_says_where_else_each_may_be) {
  Fits fits;
  fits.add("added_mass", std::log(900.), true, "left");
  fits.add("added_mass", std::log(300.), true, "right");
  fits.add("local_damage", std::log(300.));
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)),
            "Ambiguous: added_mass at left 43 %, right 14 % or local_damage at here 42 %");
}

TEST(Headline, of_one_that_is_not_believed_says_perhaps_and_why) {
  Fits fits;
  fits.add_gap("added_mass", 1).adequate = true;
  const Referee strict{.to_all = [](const JudgedFit&) -> Objection { return {"it is so"}; }};
  EXPECT_EQ(headline(specimen(12), fits.judgement_of_gaps(12, strict)),
            "Perhaps added_mass at here 50 %; not identified: it is so");
}

TEST(Headline, of_sets_names_one_or_two_and_counts_more) {
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add_pair("added_mass", "ply_slip", 20);
  const std::string first = "Several effects: added_mass at here and ply_slip at here",
                    odds = " (odds above a million to one over no effect)";
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)), first + odds);
  fits.add_pair("added_mass", "ply_slip", 19);
  fits.move_last("there");
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)),
            first + "; or added_mass at here and ply_slip at there" + odds);
  fits.add_pair("added_mass", "ply_slip", 18);
  fits.move_last("elsewhere");
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)),
            first + odds + "; 2 other sets explain the test as well");
}

TEST(Headline, of_sets_of_different_effects_lists_them) {
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add_pair("added_mass", "ply_slip", 20);
  fits.add_pair("added_mass", "damping", 15.1);
  EXPECT_EQ(headline(specimen(1), fits.judgement(false)),
            "Ambiguous: added_mass at here and ply_slip at here; or added_mass at here and damping "
            "at here; 2 sets of effects explain the test alike");
}

// 1 - (2 / 6.8)^2 of the gap.
TEST(Headline, of_what_explains_most_says_how_much_is_closed) {
  Fits fits;
  fits.add_gap("ply_slip", 2);
  fits.add_gap("temperature", 6);
  EXPECT_EQ(headline(specimen(6.8), fits.judgement_of_gaps(6.8)),
            "Mostly ply_slip at here: 91 % of the gap is closed, the rest is not explained");
}

TEST(Headline, of_what_no_effect_explains_says_where_it_is_farthest_off_and_what_comes_nearest) {
  const std::string none =
      "None of the effects known here explains the test; it is farthest off in "
      "frequency of mode 2";
  Fits nothing;
  EXPECT_EQ(headline(specimen(6.8), nothing.judgement_of_gaps(6.8)), none);
  Fits fits;
  fits.add_gap("ply_slip", 2);
  fits.add_gap("temperature", 2.2);
  const std::string nearest = none + "; nearest comes ply_slip at here, which closes 91 % of the "
                                     "gap";
  EXPECT_EQ(headline(specimen(6.8), fits.judgement_of_gaps(6.8)), nearest);
  fits.singles.pop_back();
  fits.singles.front().absurd = true;
  EXPECT_EQ(headline(specimen(6.8), fits.judgement_of_gaps(6.8)),
            nearest + "; not named: only with a value far out of its prior");
}

TEST(Headline, says_last_what_is_no_effect_here_and_would_do_better) {
  Fits fits;
  fits.add_gap("ply_slip", 2);
  Judgement j = fits.judgement_of_gaps(6.8);
  ASSERT_EQ(j.verdict, Verdict::mostly);
  const std::string mostly = headline(specimen(6.8), j);
  const Hypothesis resonator{
      .effect = "resonator", .place = "beam.point[3]", .way = "", .parameters = {}};
  j.resonator = specimen(1);
  j.resonator->fit.together = {&resonator};
  j.resonator->fit.values = Eigen::Vector2d(0.015, 805);
  EXPECT_EQ(headline(specimen(6.8), j), mostly) << "it stood up to it";
  const std::string words =
      "; what is no effect here would do better: 15 g on a spring of its own, which resonates at "
      "805 Hz, at beam.point[3], which would leave a gap of 1 (2 as it is told)";
  j.verdict = Verdict::unknown;
  EXPECT_TRUE(headline(specimen(6.8), j).ends_with(words)) << headline(specimen(6.8), j);
  j.verdict = Verdict::ambiguous;
  EXPECT_TRUE(headline(specimen(6.8), j).ends_with(words)) << headline(specimen(6.8), j);
}

TEST(Headline, of_a_search_that_was_stopped_says_so) {
  const JudgedFit nominal = specimen(6.8);
  Fits fits;
  EXPECT_EQ(headline(nominal, nearest_so_far(nominal, Inclusion(nominal, {}, {}))),
            "Stopped before an effect was found that comes nearer than the nominal case");
  fits.add_gap("ply_slip", 2);
  const Inclusion inclusion(nominal, fits.singles, fits.sets);
  EXPECT_EQ(headline(nominal, nearest_so_far(nominal, inclusion)),
            "Stopped before all effects were tried; nearest so far comes ply_slip at here, which "
            "closes 91 % of the gap");
}

} // namespace
} // namespace plica
