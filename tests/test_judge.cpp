// The verdict by its published rules (docs/diagnosis.md, judge.hpp), on fits made up for the
// purpose.
#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judge.hpp"

#include <cmath>
#include <deque>
#include <gtest/gtest.h>

namespace plica {
namespace {

// Fits by effect and evidence; the nominal case has evidence 0.
class Fits {
public:
  JudgedFit nominal(bool adequate) const {
    JudgedFit j;
    j.fit.solved = true;
    j.adequate = adequate;
    return j;
  }
  JudgedFit& add(const std::string& effect, double log_evidence, bool adequate = true,
                 const std::string& place = "here") {
    singles.push_back(fit_of({hypothesis(effect, place)}, log_evidence, adequate));
    return singles.back();
  }
  JudgedFit& add_set(const std::vector<std::string>& effects, double log_evidence,
                     bool adequate = true) {
    std::vector<const Hypothesis*> together;
    for (const std::string& effect : effects) together.push_back(hypothesis(effect, "here"));
    sets.push_back(fit_of(std::move(together), log_evidence, adequate));
    sets.back().held_out_met = true;
    sets.back().held_out_shrink = 0.5;
    return sets.back();
  }
  JudgedFit& add_pair(const std::string& a, const std::string& b, double log_evidence) {
    return add_set({a, b}, log_evidence);
  }
  Judgement judgement(bool nominal_adequate, const Referee& referee = {}) {
    nominal_ = nominal(nominal_adequate);
    effects_ = fits_by_effect(singles);
    return judge(nominal_, effects_, sets, Inclusion(nominal_, singles, sets), {}, referee);
  }
  // Fits of ten readings that leave this gap each, as log evidences are without their dispersion.
  Judgement judgement_of_gaps(double nominal_gap, const Referee& referee = {}) {
    nominal_ = nominal(false);
    leave(nominal_, nominal_gap);
    effects_ = fits_by_effect(singles);
    return judge(nominal_, effects_, sets, Inclusion(nominal_, singles, sets), {}, referee);
  }
  static void leave(JudgedFit& j, double gap) {
    constexpr int readings = 10;
    j.gap_after = gap;
    j.fit.error = Eigen::VectorXd::Constant(readings, gap);
    j.fit.J = Eigen::MatrixXd::Zero(readings, j.fit.z.size());
    j.fit.chi2 = j.fit.error.squaredNorm();
    j.readings = readings;
    j.fit.log_evidence = -j.fit.chi2 / 2;
  }
  JudgedFit& add_gap(const std::string& effect, double gap, const std::string& place = "here") {
    leave(add(effect, 0, false, place), gap);
    return singles.back();
  }

  std::vector<JudgedFit> singles, sets;

private:
  const Hypothesis* hypothesis(const std::string& effect, const std::string& place) {
    hypotheses_.emplace_back();
    hypotheses_.back().effect = effect;
    hypotheses_.back().place = place;
    return &hypotheses_.back();
  }
  static JudgedFit fit_of(std::vector<const Hypothesis*> together, double log_evidence,
                          bool adequate) {
    JudgedFit j;
    j.fit.together = std::move(together);
    j.fit.solved = true;
    j.fit.log_evidence = log_evidence;
    j.log_bayes_factor = log_evidence;
    j.adequate = adequate;
    return j;
  }
  std::deque<Hypothesis> hypotheses_;
  JudgedFit nominal_;
  std::vector<EffectFits> effects_;
};

double probability(const Judgement& j, const std::string& effect) {
  for (const auto& [name, p] : j.probabilities)
    if (name == effect) return p;
  return 0;
}

TEST(Judge, says_none_while_no_effect_is_worth_the_threshold) {
  Fits fits;
  fits.add("added_mass", 2.9);
  const Judgement j = fits.judgement(true);
  EXPECT_EQ(j.verdict, Verdict::none);
  EXPECT_TRUE(j.named.empty());
  // exp(2.9) to 1 among two credible answers
  EXPECT_NEAR(probability(j, "added_mass"), std::exp(2.9) / (1 + std::exp(2.9)), 1e-12);
}

TEST(Judge, identifies_an_effect_that_is_five_nats_ahead) {
  Fits fits;
  fits.add("added_mass", 10);
  fits.add("ply_slip", 4.9);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::identified);
  ASSERT_EQ(j.named.size(), 1u);
  EXPECT_EQ(j.named[0]->fit.together[0]->effect, "added_mass");
}

TEST(Judge, names_all_that_lie_within_five_nats) {
  Fits fits;
  fits.add("added_mass", 10);
  fits.add("ply_slip", 5.1);
  fits.add("temperature", 4.9);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.named.size(), 2u);
}

// A mass at the free end and damage at the clamp of a cantilever move its frequencies alike.
TEST(Judge, is_sure_of_none_of_a_list) {
  Fits fits;
  fits.add("added_mass", 10);
  fits.add("local_damage", 5.1);
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_LT(probability(j, "added_mass"), 0.9);
  EXPECT_GT(probability(j, "added_mass"), 0.85);
  fits.singles.back().fit.log_evidence = 10;
  j = fits.judgement(false);
  EXPECT_NEAR(probability(j, "added_mass"), 0.5, 1e-12);
  fits.singles.back().fit.log_evidence = 4.9;
  EXPECT_GT(probability(fits.judgement(false), "added_mass"), 0.99) << "told apart";
}

TEST(Judge, passes_over_what_is_inadequate_or_not_met_by_what_was_held_out) {
  Fits fits;
  fits.add("added_mass", 30, false);
  fits.add("temperature", 20).fails_held_out = true;
  fits.add("local_damage", 10);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::identified);
  ASSERT_EQ(j.named.size(), 1u);
  EXPECT_EQ(j.named[0]->fit.together[0]->effect, "local_damage");
  EXPECT_EQ(probability(j, "added_mass"), 0) << "only what stands has a share";
}

// A clamp softer than its prior lets it be explains a test: a fixture that explains it less well is
// not the cause for that.
TEST(Judge, tells_an_effect_apart_from_what_is_too_far_out_of_its_prior) {
  Fits fits;
  fits.add("boundary_compliance", 12).absurd = true;
  fits.add("fixture_flexibility", 10);
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  ASSERT_EQ(j.named.size(), 2u);
  EXPECT_EQ(j.named[0]->fit.together[0]->effect, "fixture_flexibility");
  EXPECT_EQ(j.named[1]->fit.together[0]->effect, "boundary_compliance");
  EXPECT_GT(probability(j, "boundary_compliance"), 0.5);
  fits.singles.front().fit.log_evidence = 4.9;
  j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::identified);
}

TEST(Judge, lists_sets_that_are_too_far_out_of_a_prior_behind_one_that_is_not) {
  Fits fits;
  fits.add("added_mass", 10, false);
  fits.add("ply_slip", 4, false);
  fits.add_pair("added_mass", "ply_slip", 20);
  fits.add_pair("added_mass", "temperature", 22).absurd = true;
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::several);
  ASSERT_EQ(j.named.size(), 2u);
  EXPECT_EQ(j.named[0]->fit.together[1]->effect, "ply_slip");
  fits.sets.front().absurd = true;
  EXPECT_NE(fits.judgement(false).verdict, Verdict::several) << "none is left that may be named";
}

// An effect may be allowed to be off by more than it explains: A1 of cases/ had "joint_friction,
// which closes -47 % of the gap" at the head of its list.
TEST(Judge, names_nothing_that_closes_none_of_the_gap) {
  Fits fits;
  fits.add("joint_friction", 12).explains_nothing = true;
  Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_TRUE(j.named.empty());
  EXPECT_EQ(j.nearest, nullptr);
  fits.add("damping", 16.9); // is not sure then
  j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.withheld, "joint_friction at here explains as much, and closes none of the gap");
  fits.singles.back().fit.log_evidence = 17.1;
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::identified);
}

// A mass that was weighed says nothing of a spring: two frequencies and a spring somewhere.
TEST(Judge, counts_the_readings_that_several_free_parameters_move) {
  Fits fits;
  JudgedFit& j = fits.add("extra_support", 40);
  j.free_parameters = 2;
  j.readings = 4;
  j.moved = 2;
  EXPECT_EQ(j.saturated(), "2 free parameters for 2 readings that they move");
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::ambiguous);
  // One reading more is met by chance: two of three frequencies say how heavy and where.
  fits.singles.front().moved = 3;
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::ambiguous);
  fits.singles.front().moved = 4;
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::identified);
  fits.singles.front().free_parameters = 4;
  const Judgement none_left = fits.judgement(false);
  EXPECT_EQ(none_left.verdict, Verdict::ambiguous);
  EXPECT_EQ(none_left.withheld, "4 free parameters for 4 fitted readings");
}

TEST(Judge, says_unknown_where_nothing_is_credible) {
  Fits fits;
  fits.add("added_mass", 30, false);
  EXPECT_EQ(fits.judgement(false).verdict, Verdict::unknown);
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

TEST(Judge, says_of_a_search_that_was_stopped_what_came_nearest) {
  Fits fits;
  JudgedFit nominal = fits.nominal(false);
  Fits::leave(nominal, 5);
  fits.add_gap("added_mass", 2);
  const Judgement j = nearest_so_far(Inclusion(nominal, fits.singles, fits.sets));
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_TRUE(j.stopped);
  EXPECT_TRUE(j.named.empty());
  ASSERT_NE(j.nearest, nullptr);
  EXPECT_EQ(j.nearest->fit.together[0]->effect, "added_mass");
}

TEST(Judge, says_mostly_where_an_effect_far_ahead_closes_half_of_the_gap) {
  Fits fits; // of ten readings: 10 ln(6.8 / 2) = 12 nats, the next 4.4 behind
  fits.add_gap("ply_slip", 2);
  fits.add_gap("temperature", 6);
  Judgement j = fits.judgement_of_gaps(6.8);
  EXPECT_EQ(j.verdict, Verdict::mostly);
  ASSERT_EQ(j.named.size(), 1u);
  EXPECT_EQ(j.named[0]->fit.together[0]->effect, "ply_slip");
  EXPECT_GT(j.probability_of("ply_slip"), 0.9);
  Fits close; // 10 ln(2.2 / 2) = 1 nat apart
  close.add_gap("ply_slip", 2);
  close.add_gap("temperature", 2.2);
  j = close.judgement_of_gaps(6.8);
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_TRUE(j.named.empty());
  ASSERT_TRUE(j.nearest);
  EXPECT_EQ(j.nearest->fit.together[0]->effect, "ply_slip");
}

TEST(Judge, does_not_say_mostly_of_less_than_half_of_the_gap) {
  Fits fits; // (1.43 / 2)^2 = 0.51 of G is left
  fits.add_gap("ply_slip", 2 * std::sqrt(0.51));
  EXPECT_EQ(fits.judgement_of_gaps(2).verdict, Verdict::unknown);
  Fits most;
  most.add_gap("ply_slip", 20 * std::sqrt(0.49));
  most.add_gap("temperature", 19.9);
  EXPECT_EQ(most.judgement_of_gaps(20).verdict, Verdict::mostly);
  most.singles.front().absurd = true;
  EXPECT_EQ(most.judgement_of_gaps(20).withheld, "only with a value far out of its prior");
  most.singles.front().absurd = false;
  most.singles.front().held_out_shrink = 0.29;
  EXPECT_EQ(most.judgement_of_gaps(20).verdict, Verdict::unknown);
  most.singles.front().held_out_shrink = {};
  most.singles.front().free_parameters = 4; // of ten readings
  EXPECT_EQ(most.judgement_of_gaps(20).verdict, Verdict::unknown);
  most.singles.front().free_parameters = 3;
  const Referee against{
      .to_all = {}, .to_most = [](const JudgedFit&) -> Objection { return {"readings in turn"}; }};
  const Judgement j = most.judgement_of_gaps(20, against);
  EXPECT_EQ(j.verdict, Verdict::unknown);
  EXPECT_EQ(j.withheld, "readings in turn");
}

TEST(Inclusion, is_the_share_of_all_sets_that_hold_an_effect) {
  Fits fits;
  fits.add("a", std::log(8.));
  fits.add("b", std::log(4.), true, "left");
  fits.add("b", std::log(4.), true, "right");
  fits.add_set({"a", "b"}, std::log(64.));
  // Two effects: each costs a half, a place of b another half. The evidences of these fits without
  // readings are zero but for the penalty, which holds them here.
  for (std::vector<JudgedFit>* list : {&fits.singles, &fits.sets})
    for (JudgedFit& j : *list) j.fit.penalty = -j.fit.log_evidence;
  const JudgedFit nominal = fits.nominal(false);
  const Inclusion inclusion(nominal, fits.singles, fits.sets);
  const double none = 1, a = 8 / 2., b = 2 * 4 / 4., both = 64 / 8., all = none + a + b + both;
  EXPECT_NEAR(inclusion.of("a"), (a + both) / all, 1e-12);
  EXPECT_NEAR(inclusion.of("b"), (b + both) / all, 1e-12);
  EXPECT_NEAR(inclusion.at("b", "left"), 1 / all, 1e-12);
  EXPECT_NEAR(inclusion.at("b", "here"), both / all, 1e-12);
  EXPECT_EQ(inclusion.leading()->fit.together.size(), 2u);
  EXPECT_EQ(inclusion.leading_with(0.75)->fit.together[0]->effect, "a");
  EXPECT_EQ(inclusion.leading_with(0.9), nullptr);
}

TEST(Judge, averages_the_evidence_of_an_effect_over_its_places) {
  Fits fits;
  fits.add("added_mass", std::log(3.), true, "left");
  fits.add("added_mass", std::log(1.), true, "right");
  const std::vector<EffectFits> all = fits_by_effect(fits.singles);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].log_evidence, std::log(2.), 1e-12);
  EXPECT_EQ(all[0].best->fit.together[0]->place, "left");
}

TEST(Judge, prefers_a_place_that_stands_up_to_one_that_does_not_by_two_nats) {
  Fits fits;
  fits.add("added_mass", 5, false, "left");
  fits.add("added_mass", 3.1, true, "right");
  EXPECT_EQ(fits_by_effect(fits.singles)[0].best->fit.together[0]->place, "right");
}

} // namespace
} // namespace plica
