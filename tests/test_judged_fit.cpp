// What a fit is worth beside others, and the rules of numbers below it, on values made up for the
// purpose.
#include "tests/gains.hpp"
#include "tests/made_up_fits.hpp"

#include "diagnose/weigh/weighted_line.hpp"
#include "words/sample_ranks.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace plica {
namespace {

JudgedFit counted(int free_parameters, int readings, int moved) {
  JudgedFit j;
  j.free_parameters = free_parameters;
  j.readings = readings;
  j.moved = moved;
  return j;
}

TEST(JudgedFit, stands_while_no_reading_refutes_it_and_is_credible_within_its_prior) {
  JudgedFit fit;
  EXPECT_FALSE(fit.stands()) << "not adequate";
  fit.adequate = true;
  EXPECT_TRUE(fit.stands() && fit.credible());
  JudgedFit absurd = fit, refuted = fit, idle = fit;
  absurd.absurd = true;
  EXPECT_TRUE(absurd.stands());
  EXPECT_FALSE(absurd.credible());
  refuted.fails_held_out = true;
  EXPECT_FALSE(refuted.stands() || refuted.credible());
  idle.explains_nothing = true;
  EXPECT_FALSE(idle.stands() || idle.credible());
}

TEST(JudgedFit, is_too_free_below_three_readings_for_each_free_parameter) {
  EXPECT_FALSE(counted(2, 6, 6).too_free());
  EXPECT_TRUE(counted(2, 5, 5).too_free());
  EXPECT_FALSE(counted(0, 1, 1).too_free());
  EXPECT_FALSE(counted(2, 0, 0).too_free()) << "readings are not counted";
}

TEST(JudgedFit, is_saturated_where_its_free_parameters_meet_any_readings) {
  EXPECT_EQ(counted(1, 1, 1).saturated(), "1 free parameters for 1 fitted readings");
  EXPECT_EQ(counted(3, 2, 2).saturated(), "3 free parameters for 2 fitted readings");
  EXPECT_EQ(counted(1, 2, 1).saturated(), "") << "a single one may move a single reading";
  EXPECT_EQ(counted(2, 9, 3).saturated(), "2 free parameters for 3 readings that they move");
  EXPECT_EQ(counted(2, 9, 4).saturated(), "");
  EXPECT_EQ(counted(2, 0, 0).saturated(), "") << "readings are not counted";
}

TEST(JudgedFit, evidence_is_that_of_markov_chains_where_they_were_followed) {
  HypothesisFit fit;
  fit.log_evidence = 7;
  EXPECT_EQ(evidence_of(fit), 7);
  fit.sampled_log_evidence = 5;
  EXPECT_EQ(evidence_of(fit), 5);
}

// Three hypotheses in two places: e^ln 3, 1 and 2 add up to 6, on average 2.
TEST(JudgedFit, places_of_an_effect_share_what_its_hypotheses_are_worth) {
  Fits fits;
  fits.add("added_mass", std::log(3.), true, "left");
  fits.add("added_mass", std::log(1.), true, "left");
  fits.add("added_mass", std::log(2.), true, "right");
  const std::vector<EffectFits> all = fits_by_effect(fits.singles);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].log_evidence, std::log(2.), 1e-12);
  ASSERT_EQ(all[0].places.size(), 2u);
  EXPECT_EQ(all[0].places[0].first, "left");
  EXPECT_NEAR(all[0].places[0].second, 4. / 6, 1e-12);
  EXPECT_NEAR(all[0].places[1].second, 2. / 6, 1e-12);
}

// Three more, of no weight: on average 1; of an effect without fits nothing is known.
TEST(JudgedFit, places_that_were_passed_over_count_as_the_others) {
  Fits fits;
  fits.add("added_mass", std::log(4.), true, "left");
  fits.add("added_mass", std::log(1.), true, "left");
  fits.add("added_mass", std::log(1.), true, "right");
  const PassedOver passed_over{{"added_mass", 3}, {"extra_support", 5}};
  const std::vector<EffectFits> all = fits_by_effect(fits.singles, passed_over);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].log_evidence, 0, 1e-12);
  EXPECT_NEAR(all[0].places[0].second, 5. / 6, 1e-12);
}

TEST(JudgedFit, effects_are_sorted_by_evidence_and_what_was_not_solved_is_left_out) {
  Fits fits;
  fits.add("added_mass", 4);
  fits.add("temperature", 9);
  fits.add("damping", 1).fit.sampled_log_evidence = 6;
  fits.add("ply_slip", 20).fit.solved = false;
  const std::vector<EffectFits> all = fits_by_effect(fits.singles);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].effect, "temperature");
  EXPECT_EQ(all[1].effect, "damping");
  EXPECT_NEAR(all[1].log_evidence, 6, 1e-12);
  EXPECT_EQ(all[2].effect, "added_mass");
}

// Of 25 in squares a place without a cause closes 16, a cause 9 or 4.75.
TEST(JudgedFit, a_place_without_a_cause_gives_way_to_a_cause_there_that_closes_half_as_much) {
  Hypothesis place_only, cause;
  place_only.place = "bellows.stretch[2]";
  place_only.names_place_only = true;
  JudgedFit nominal, left_open, caused;
  nominal.gap_after = 5;
  left_open.gap_after = 3;
  left_open.fit.together = {&place_only};
  caused.fit.together = {&cause};
  EXPECT_TRUE(left_open.leaves_cause_open());
  EXPECT_FALSE(caused.leaves_cause_open());
  const auto remain = [&](const std::string& place, double gap, bool absurd) {
    cause.place = place;
    caused.gap_after = gap;
    caused.absurd = absurd;
    std::vector<JudgedFit> fits{left_open, caused};
    drop_places_with_a_cause(fits, nominal);
    return fits.size();
  };
  EXPECT_EQ(remain("bellows.convolution[1]", 4, false), 1u);
  EXPECT_EQ(remain("bellows.convolution[1]", 4.5, false), 2u) << "too little";
  EXPECT_EQ(remain("bellows.convolution[1]", 4, true), 2u) << "far out of its prior";
  EXPECT_EQ(remain("pipe", 4, false), 2u) << "elsewhere";
  cause.free_numbers = 2;
  EXPECT_EQ(remain("bellows.spot[0][0][0]", 3.1, false), 2u) << "one of many, not all of it";
  EXPECT_EQ(remain("bellows.spot[0][0][0]", 3, false), 1u);
}

// Counted is what the readings know better than half of what was known, or that moves one of them
// by a tenth of its error: not a support so stiff that more of it changes nothing.
TEST(JudgedFit, counts_the_parameters_that_readings_move) {
  test::Gains gains(8);
  gains.add("told", "here", gains.along(0, 3));
  gains.add("told little", "here", gains.along(1, 0.2));
  gains.add("in its rigid limit", "here", gains.along(2, 0.05));
  gains.measure(gains.along(0, 3));
  const std::vector<JudgedFit> fits =
      gains.searched({}, [](const SetSearch& search) { return search.fits; });
  ASSERT_EQ(fits.size(), 3U);
  EXPECT_EQ(fits[0].free_parameters, 1);
  EXPECT_LT(fits[0].fit.covariance(0, 0), 0.5 * 0.5);
  EXPECT_EQ(fits[1].free_parameters, 1);
  EXPECT_GT(fits[1].fit.covariance(0, 0), 0.5 * 0.5) << "it moves a reading all the same";
  EXPECT_EQ(fits[2].free_parameters, 0);
}

// What no reading speaks of keeps its number, and is no explanation.
TEST(JudgedFit, stays_at_its_priors_where_nothing_is_known_of_it) {
  test::Gains gains(8);
  gains.add("mute", "here", Eigen::VectorXd::Zero(8));
  gains.add("told", "here", gains.along(0, 3));
  gains.measure(gains.along(0, 3));
  const std::vector<JudgedFit> fits =
      gains.searched({}, [](const SetSearch& search) { return search.fits; });
  ASSERT_EQ(fits.size(), 2U);
  EXPECT_TRUE(fits[0].stays_at_priors);
  EXPECT_FALSE(fits[0].stands());
  EXPECT_FALSE(fits[1].stays_at_priors);
}

TEST(WeightedLine, gives_back_a_line_whatever_the_errors) {
  WeightedLine line;
  for (const auto& [x, sigma] : {std::pair{0., 0.1}, {1., 0.2}, {4., 0.05}})
    line.add(x, 2 - 3 * x, sigma);
  ASSERT_TRUE(line.slope());
  EXPECT_NEAR(line.slope()->value, -3, 1e-12);
}

// (9 - 5) / (3 - 1), and the errors of both over that distance.
TEST(WeightedLine, of_two_points_has_the_errors_of_both) {
  WeightedLine line;
  line.add(1, 5, 0.3);
  line.add(3, 9, 0.4);
  ASSERT_TRUE(line.slope());
  EXPECT_NEAR(line.slope()->value, 2, 1e-12);
  EXPECT_NEAR(line.slope()->sigma, 0.25, 1e-12);
}

// Weights 1, 1 and 1/4 about the mean 2/3 of x: slope sum w (x - 2/3) y / sum w (x - 2/3)^2.
TEST(WeightedLine, counts_a_point_of_twice_the_error_a_quarter) {
  WeightedLine line;
  line.add(0, 0, 1);
  line.add(1, 1, 1);
  line.add(2, 0, 2);
  ASSERT_TRUE(line.slope());
  EXPECT_NEAR(line.slope()->value, (1. / 3) / (4. / 9 + 1. / 9 + 4. / 9), 1e-12);
  EXPECT_NEAR(line.slope()->sigma, 1, 1e-12);
}

TEST(WeightedLine, has_no_slope_where_all_points_have_one_x) {
  WeightedLine line;
  EXPECT_FALSE(line.slope()) << "no point";
  line.add(0.1, 1, 0.1);
  EXPECT_FALSE(line.slope()) << "one point";
  line.add(0.1, 2, 0.2);
  line.add(0.1, 3, 0.3);
  EXPECT_FALSE(line.slope());
  line.add(0.2, 3, 0.3);
  EXPECT_TRUE(line.slope());
}

TEST(NearestRank, runs_from_the_first_to_the_last_and_rounds_in_between) {
  EXPECT_EQ(nearest_rank(5, 0), 0u);
  EXPECT_EQ(nearest_rank(5, 1), 4u);
  EXPECT_EQ(nearest_rank(5, 0.5), 2u);
  EXPECT_EQ(nearest_rank(5, 0.12), 0u);
  EXPECT_EQ(nearest_rank(5, 0.13), 1u);
  EXPECT_EQ(nearest_rank(500, 0.99), 494u);
  EXPECT_EQ(nearest_rank(1, 0.95), 0u) << "of one there is but one";
}

TEST(NearestRank, gives_quantiles_and_the_upper_one_of_two_medians) {
  EXPECT_EQ(quantile({4, 1, 5, 2, 3}, 0.25), 2);
  EXPECT_EQ(quantile({4, 1, 5, 2, 3}, 1), 5);
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
  EXPECT_EQ(median({6, 1, 5, 2, 4, 3}), 4);
}

} // namespace
} // namespace plica
