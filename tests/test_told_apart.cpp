// What to measure to tell apart effects that stand for one another in the ledger.
#include "changed_beam.hpp"
#include "diagnose/account/told_apart.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

using Eigen::VectorXd;

// A cantilever with masses, of which three modes in z and two in x are known.
class ToldApart : public testing::Test {
protected:
  ToldApart() {
    changed_beam::add_masses(case_);
    changed_beam::add_modes(test_.data, "");
    changed_beam::take_readings(test_.data, changed_beam::read_by(case_, test_.data));
    problem_ = stated_gap(case_, test_, {});
  }

  // One effect of that size alone, as a set.
  HypothesisFit set(const std::string& effect, const std::string& place, double size) const {
    for (const Hypothesis& h : problem_->hypotheses)
      if (h.effect == effect && h.place == place) {
        HypothesisFit fit;
        fit.together = {&h};
        fit.values = VectorXd::Constant(Eigen::Index(h.parameters.size()), size);
        return fit;
      }
    throw std::out_of_range(effect + " at " + place);
  }
  // The row that stands for the effects of these sets.
  LedgerRow row_of(const std::vector<HypothesisFit>& told) const {
    LedgerRow row;
    for (const HypothesisFit& fit : told) {
      NamedEffect& e = row.effects.emplace_back();
      e.name = fit.together[0]->effect;
      e.place = fit.together[0]->place;
    }
    return row;
  }
  OfferedReadings menu() const {
    return offered_beside(case_, problem_->nominal, test_.data, problem_->readings,
                          problem_->predictors->models());
  }
  std::string told_apart_by(const std::vector<HypothesisFit>& told) const {
    Ledger ledger;
    ledger.rows = {row_of(told), {}};
    ledger.rows.back().left = Remainder::unexplained;
    EXPECT_EQ(say_what_tells_apart(*problem_, menu(), told, ledger), "");
    EXPECT_EQ(ledger.rows.back().told_apart_by, "");
    return ledger.rows.front().told_apart_by;
  }

  Case case_ = changed_beam::beam_of(3, 0.6, 0.03, 0.005, true);
  TestData test_;
  std::unique_ptr<GapProblem> problem_;
};

// The scale takes a fifth of an hour, a static test one.
TEST_F(ToldApart, a_mass_and_heat_are_by_the_scale) {
  EXPECT_EQ(told_apart_by({set("component_mass", "m3", 4), set("temperature", "all", 100)}),
            "weigh the specimen");
}

TEST_F(ToldApart, what_shows_alike_in_all_that_can_be_measured_is_by_what_its_effects_say) {
  const std::vector<HypothesisFit> alike{set("component_mass", "m3", 1),
                                         set("temperature", "all", 0)};
  EXPECT_EQ(told_apart_by(alike), "");
  const std::vector<HypothesisFit> masses{set("added_mass", "beam", 0),
                                          set("component_mass", "m3", 1)};
  EXPECT_EQ(told_apart_by(masses), "weigh the part");
}

TEST_F(ToldApart, one_effect_alone_is_told_apart_from_nothing) {
  EXPECT_EQ(told_apart_by({set("component_mass", "m3", 4)}), "");
}

TEST_F(ToldApart, says_where_it_looks_at_some_of_the_sets_only) {
  std::vector<HypothesisFit> told{set("component_mass", "m3", 4), set("temperature", "all", 100)};
  told.resize(most_told_apart + 1, told.front());
  Ledger ledger;
  ledger.rows = {row_of({told[0], told[1]})};
  EXPECT_EQ(say_what_tells_apart(*problem_, menu(), told, ledger),
            "what tells effects of a row apart is said of the best 8 of 9 sets that explain the "
            "test alike");
  EXPECT_EQ(ledger.rows.front().told_apart_by, "weigh the specimen");
  ledger.rows = {row_of({told[0]})};
  EXPECT_EQ(say_what_tells_apart(*problem_, menu(), told, ledger), "") << "nothing is asked";
}

} // namespace
} // namespace plica
