// The verdict by its published rules (docs/diagnosis.md, judge.hpp), on fits made up for the
// purpose.
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
  JudgedFit& add_pair(const std::string& a, const std::string& b, double log_evidence) {
    pairs.push_back(fit_of({hypothesis(a, "here"), hypothesis(b, "here")}, log_evidence, true));
    pairs.back().held_out_met = true;
    pairs.back().held_out_shrink = 0.5;
    return pairs.back();
  }
  Judgement judgement(bool nominal_adequate) {
    nominal_ = nominal(nominal_adequate);
    families_ = families(singles);
    return judge(nominal_, families_, pairs, {});
  }

  std::vector<JudgedFit> singles, pairs;

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
  std::vector<Family> families_;
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

TEST(Judge, identifies_an_effect_that_is_three_nats_ahead) {
  Fits fits;
  fits.add("added_mass", 10);
  fits.add("ply_slip", 6.9);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::identified);
  ASSERT_EQ(j.named.size(), 1u);
  EXPECT_EQ(j.named[0]->fit.together[0]->effect, "added_mass");
}

TEST(Judge, names_all_that_lie_within_three_nats) {
  Fits fits;
  fits.add("added_mass", 10);
  fits.add("ply_slip", 7.1);
  fits.add("temperature", 6.9);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::ambiguous);
  EXPECT_EQ(j.named.size(), 2u);
}

TEST(Judge, passes_over_what_is_inadequate_absurd_or_not_met_by_what_was_held_out) {
  Fits fits;
  fits.add("added_mass", 30, false);
  fits.add("ply_slip", 25).absurd = true;
  fits.add("temperature", 20).fails_held_out = true;
  fits.add("local_damage", 10);
  const Judgement j = fits.judgement(false);
  EXPECT_EQ(j.verdict, Verdict::identified);
  ASSERT_EQ(j.named.size(), 1u);
  EXPECT_EQ(j.named[0]->fit.together[0]->effect, "local_damage");
  EXPECT_EQ(probability(j, "added_mass"), 0) << "only what is credible has a share";
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
  EXPECT_EQ(j.verdict, Verdict::pair);
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

TEST(Judge, averages_the_evidence_of_an_effect_over_its_places) {
  Fits fits;
  fits.add("added_mass", std::log(3.), true, "left");
  fits.add("added_mass", std::log(1.), true, "right");
  const std::vector<Family> all = families(fits.singles);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].log_evidence, std::log(2.), 1e-12);
  EXPECT_EQ(all[0].best->fit.together[0]->place, "left");
}

TEST(Judge, prefers_a_place_that_stands_up_to_one_that_does_not_by_two_nats) {
  Fits fits;
  fits.add("added_mass", 5, false, "left");
  fits.add("added_mass", 3.1, true, "right");
  EXPECT_EQ(families(fits.singles)[0].best->fit.together[0]->place, "right");
}

} // namespace
} // namespace plica
