// What is asked of effects that lead, on a problem in closed form (gains.hpp): which of the reasons
// (test_reasons.cpp) holds, and in which order they are asked for.
#include "tests/gains.hpp"

#include "diagnose/objections.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using test::Gains;

constexpr int readings = 8;

// A referee about the set of all effects that were added but for those to be beside them.
class ObjectionsTo : public testing::Test {
protected:
  enum class Asked { all, sets, most };

  VectorXd along(Index reading, double deviations) const {
    return gains_.along(reading, deviations);
  }
  static VectorXd everywhere(double deviations) { return VectorXd::Constant(readings, deviations); }
  Hypothesis& leads(const char* effect, const VectorXd& g) {
    Hypothesis& h = gains_.add(effect, "here", g);
    leading_.push_back(&h);
    return h;
  }
  void measure(const VectorXd& r) { gains_.measure(r); }

  // What `ask` says of the objections to what leads.
  template <class Ask> auto asked_of(const Ask& ask) {
    return gains_.searched({}, [&](const SetSearch& search) {
      GapProblem problem{.data = case_, .test = nothing_};
      problem.held_out.emplace(search.held_out);
      if (beside_baseline_) problem.baseline.readings.emplace_back();
      const HypothesisFit plain = nominal_fit(search.context);
      const Inclusion inclusion(search.nominal, search.fits, {});
      Objections objections(
          problem, search, plain, tempting_, [&] { return resonators_; }, inclusion);
      const JudgedFit lead = judged(fit_of(search.context, leading_), plain, search.context,
                                    search.held_out, search.scores, search.standards);
      return ask(objections, lead);
    });
  }
  Objection objection(Asked asked) {
    return asked_of([&](Objections& objections, const JudgedFit& lead) {
      const Referee referee = objections.referee();
      Objection found = asked == Asked::all    ? referee.to_all(lead)
                        : asked == Asked::sets ? referee.to_sets(lead)
                                               : referee.to_most(lead);
      beside_.clear();
      for (const JudgedFit& j : objections.beside()) beside_.push_back(j.fit.effects());
      return found;
    });
  }
  // Effects of what would do better where this is the verdict; empty = nothing would.
  std::vector<std::string> beyond(Verdict verdict) {
    return asked_of([&](Objections& objections, const JudgedFit& lead) {
      Judgement judgement;
      judgement.verdict = verdict;
      judgement.nearest = &lead;
      const std::optional<JudgedFit> found = objections.resonator_beyond(judgement);
      return found ? found->fit.effects() : std::vector<std::string>{};
    });
  }
  std::string why(Asked asked) { return objection(asked).why; }

  // A factor on everything that leaves this gap.
  void tempt(double gap_after) {
    Compensator& factor = tempting_.emplace_back();
    factor.on = FreeFactor::density;
    factor.name = "density";
    factor.factor = 1.1;
    factor.gap_after = gap_after;
  }

  // A mass on a spring of its own; what it does grows with the mass.
  void hang(const VectorXd& g) {
    Hypothesis h = gains_.add("resonator", "tip", g);
    gains_.take_away();
    h.parameters.push_back({"frequency", "Hz", {PriorKind::normal, 80, 1}});
    resonators_.push_back(std::move(h));
  }

  Gains gains_{readings};
  bool beside_baseline_ = false;
  std::vector<Compensator> tempting_;
  std::vector<Hypothesis> resonators_;
  std::vector<std::vector<std::string>> beside_; // effects of sets that were tried beside it

private:
  Case case_;
  TestData nothing_;
  std::vector<const Hypothesis*> leading_;
};

constexpr const char* on_a_spring = "a mass on a spring of its own explains it";
constexpr const char* in_turn_words = "taken in turn, readings are foretold no better with it";

TEST_F(ObjectionsTo, what_would_explain_all_are_none_where_readings_foretell_each_other) {
  leads("mass", everywhere(3));
  measure(everywhere(3));
  const Objection found = objection(Asked::all);
  EXPECT_EQ(found.why, "");
  ASSERT_TRUE(found.in_turn);
  EXPECT_GT(found.in_turn->interval[0], 0);
  EXPECT_GT(found.in_turn->shrink(), 0.8);
}

TEST_F(ObjectionsTo, what_would_explain_all_ask_for_readings_in_turn_where_none_is_held_out) {
  leads("mass", along(0, 6));
  measure(along(0, 6));
  EXPECT_TRUE(why(Asked::all).starts_with(in_turn_words)) << why(Asked::all);
  gains_.hold_out(readings - 1);
  const Objection found = objection(Asked::all);
  EXPECT_EQ(found.why, "");
  EXPECT_FALSE(found.in_turn);
}

TEST_F(ObjectionsTo, what_would_explain_all_begin_with_what_it_leaves) {
  leads("mass", along(0, 4));
  measure(along(0, 4) + along(1, 6));
  const Objection found = objection(Asked::all); // 16 of 52
  EXPECT_EQ(found.why, "it closes 31 % of the gap");
  EXPECT_FALSE(found.in_turn) << "not asked for any more";
}

// Six of a change of 7.2 standard deviations are left.
TEST_F(ObjectionsTo, a_change_ask_for_what_is_left_of_it_and_for_one_factor_on_everything) {
  beside_baseline_ = true;
  leads("mass", along(0, 4));
  measure(along(0, 4) + along(1, 6));
  EXPECT_EQ(why(Asked::all), "it leaves 83 % of the change");
  tempt(2.5); // 6 / sqrt(8) = 2.1, times 1.2
  EXPECT_TRUE(why(Asked::all).starts_with("density times 1.1 would leave no more"))
      << why(Asked::all);
  tempting_.front().gap_after = 2.6;
  EXPECT_EQ(why(Asked::all), "it leaves 83 % of the change");
}

// share_i = c_i (2 r - sum c) / r^2 of contributions c_i = z_i g_i, z = (I + G'G)^-1 G'r.
TEST_F(ObjectionsTo, sets_are_that_they_cancel) {
  const VectorXd r = along(1, 9);
  leads("a", along(1, -180) + along(2, 90));
  leads("b", along(1, 189) + along(2, -90));
  measure(r);
  EXPECT_TRUE(why(Asked::sets).starts_with("the effects cancel: some open 17.7 times"))
      << why(Asked::sets);
}

TEST_F(ObjectionsTo, sets_are_none_where_each_closes_its_part) {
  leads("a", along(1, 5));
  leads("b", along(2, 5));
  measure(along(1, 5) + along(2, 5));
  EXPECT_EQ(why(Asked::sets), "");
}

TEST_F(ObjectionsTo, what_would_explain_most_begin_with_one_factor_on_everything) {
  leads("mass", everywhere(3));
  measure(everywhere(3) + along(0, 6));
  tempt(0.1);
  const Objection found = objection(Asked::most);
  EXPECT_TRUE(found.why.starts_with("density times 1.1 would leave no more")) << found.why;
  EXPECT_FALSE(found.sampled) << "nothing was solved for it";
}

// It closes 100 of 200 at its best number.
TEST_F(ObjectionsTo, what_would_explain_most_count_the_lower_end_of_what_it_closes) {
  leads("mass", along(0, 10));
  measure(along(0, 10) + along(1, 10));
  const Objection found = objection(Asked::most);
  EXPECT_TRUE(found.why.starts_with("it closes ")) << found.why;
  ASSERT_TRUE(found.sampled);
  EXPECT_GT(found.sampled->draws.cols(), 0);
  EXPECT_FALSE(found.in_turn);
}

TEST_F(ObjectionsTo, what_would_explain_most_name_members_that_close_little) {
  leads("mass", along(0, 20));
  leads("gain", along(1, 2));
  measure(along(0, 20) + along(1, 2) + along(2, 4));
  const Objection found = objection(Asked::most);
  EXPECT_TRUE(found.why.starts_with("gain at here closes 0.")) << found.why; // 4 of 420
  ASSERT_EQ(found.small.size(), 1U);
  EXPECT_EQ(found.small.front()->effect, "gain");
  EXPECT_TRUE(found.sampled);
}

TEST_F(ObjectionsTo, what_would_explain_most_take_readings_in_turn_or_those_held_out) {
  leads("mass", along(0, 12));
  measure(along(0, 12) + along(1, 3));
  const Objection turn = objection(Asked::most);
  EXPECT_TRUE(turn.why.starts_with(in_turn_words)) << turn.why;
  EXPECT_TRUE(turn.in_turn);
  gains_.hold_out(1);
  const Objection held_out = objection(Asked::most);
  EXPECT_TRUE(held_out.why.starts_with("held-out readings are foretold no better with it"))
      << held_out.why;
  EXPECT_FALSE(held_out.in_turn);
}

// What is left of it asks for one reading more, which takes nothing from it.
TEST_F(ObjectionsTo, what_would_explain_most_are_none_beside_what_takes_nothing_from_it) {
  leads("mass", everywhere(6));
  gains_.add("gain", "here", along(0, 8));
  measure(everywhere(6) + along(0, 8));
  const Objection found = objection(Asked::most);
  EXPECT_EQ(found.why, "");
  ASSERT_TRUE(found.in_turn);
  EXPECT_GT(found.in_turn->interval[0], 0);
  ASSERT_EQ(beside_.size(), 1U);
  EXPECT_EQ(beside_.front(), (std::vector<std::string>{"gain", "mass"}));
}

// What is left asks for an effect that looks like it, and with which it may close nothing.
TEST_F(ObjectionsTo, what_would_explain_most_ask_what_it_closes_where_others_act_beside_it) {
  leads("mass", everywhere(6));
  gains_.add("stiffness", "here", everywhere(6) + along(0, 8));
  measure(everywhere(6) + along(0, 8));
  const Objection found = objection(Asked::most);
  EXPECT_TRUE(found.why.ends_with(" where others may act beside it")) << found.why;
  ASSERT_EQ(beside_.size(), 1U);
}

TEST_F(ObjectionsTo, what_resonates_and_would_explain_all_is_a_mass_on_a_spring_that_is_far_ahead) {
  Hypothesis& fixture = leads("fixture", along(0, 6) + along(1, 6));
  fixture.resonates = true;
  measure(along(0, 6) + along(1, 6) + along(2, 4));
  gains_.hold_out(readings - 1);
  EXPECT_EQ(why(Asked::all), "");
  hang(along(0, 6) + along(1, 6));
  EXPECT_EQ(why(Asked::all), "") << "no more than the fixture";
  hang(along(0, 6) + along(1, 6) + along(2, 4));
  EXPECT_EQ(why(Asked::all), on_a_spring);
  fixture.resonates = false;
  EXPECT_EQ(why(Asked::all), "") << "only what resonates itself is asked";
}

TEST_F(ObjectionsTo, sets_are_a_mass_on_a_spring_that_explains_far_more) {
  leads("a", along(1, 5));
  leads("b", along(2, 5));
  measure(along(1, 5) + along(2, 5) + along(0, 3));
  hang(along(1, 5));
  EXPECT_EQ(why(Asked::sets), "") << "no more than what it stands for";
  hang(2 * along(1, 5) + 2 * along(0, 8));
  measure(along(1, 5) + along(2, 5) + along(0, 8));
  EXPECT_EQ(why(Asked::sets), on_a_spring);
}

// Below its own resonance it looks like a mass, and then it explains the rest as well.
TEST_F(ObjectionsTo, what_would_explain_most_are_a_mass_on_a_spring_that_explains_as_much) {
  leads("mass", everywhere(6));
  measure(everywhere(6) + along(0, 8));
  EXPECT_EQ(why(Asked::most), "");
  hang(along(1, 6)); // explains little
  EXPECT_EQ(why(Asked::most), "");
  hang(everywhere(6) + along(0, 7));
  const Objection found = objection(Asked::most);
  EXPECT_EQ(found.why, on_a_spring);
  ASSERT_TRUE(found.resonator);
  EXPECT_EQ(found.resonator->fit.effects(), std::vector<std::string>{"resonator"});
}

// In place of the member that it looks like, beside the other.
TEST_F(ObjectionsTo, several_that_would_explain_most_are_a_mass_on_a_spring_beside_the_others) {
  leads("mass", everywhere(8));
  leads("gain", along(1, 14));
  measure(everywhere(8) + along(1, 14) + along(0, 8));
  EXPECT_EQ(why(Asked::most), "");
  hang(everywhere(8) + along(0, 8));
  EXPECT_EQ(why(Asked::most), on_a_spring);
}

TEST_F(ObjectionsTo, what_is_not_known_may_be_a_mass_on_a_spring) {
  leads("mass", everywhere(2));
  measure(everywhere(6) + along(0, 30));
  hang(everywhere(6) + along(0, 30));
  EXPECT_TRUE(beyond(Verdict::mostly).empty());
  EXPECT_EQ(beyond(Verdict::unknown), std::vector<std::string>{"resonator"});
  resonators_.clear();
  hang(everywhere(1)); // no better than what leads
  EXPECT_TRUE(beyond(Verdict::unknown).empty());
}

} // namespace
} // namespace plica
