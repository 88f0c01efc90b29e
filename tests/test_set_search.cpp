// The search for sets of effects, on a problem in closed form (gains.hpp).
#include "diagnose/judge/added_up.hpp"
#include "diagnose/judge/places_fitted.hpp"
#include "tests/gains.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Gains;
using Effects = std::vector<std::string>;

double log_evidence_of(const std::vector<VectorXd>& effects, const VectorXd& r) {
  MatrixXd C = MatrixXd::Identity(r.size(), r.size());
  for (const VectorXd& g : effects) C += g * g.transpose();
  return -r.dot(C.llt().solve(r)) / 2 - std::log(C.determinant()) / 2;
}

const JudgedFit* find(const std::vector<JudgedFit>& sets, const Effects& effects) {
  const auto found = std::find_if(sets.begin(), sets.end(),
                                  [&](const JudgedFit& j) { return j.fit.effects() == effects; });
  return found == sets.end() ? nullptr : &*found;
}

// Each half does much that the other takes back: alone it explains nothing, and sets do not grow
// from it. What imitates what is left of both leads, and nothing beside it helps. Eight readings
// carry no three.
TEST(SetSearch, exchanges_members_for_what_growth_does_not_meet) {
  Gains gains(8);
  const VectorXd half = gains.along(0, 30) + gains.along(1, 4.5),
                 other = gains.along(0, 30) - gains.along(1, 4.5),
                 decoy = gains.along(1, 4) + gains.along(2, 4), r = half - other;
  gains.add("half", "here", half);
  gains.add("other_half", "here", other);
  gains.add("decoy", "here", decoy);
  gains.measure(r);
  for (const VectorXd& g : {half, other})
    EXPECT_LT(log_evidence_of({g}, r), log_evidence_of({}, r)) << "the nominal case";
  const std::vector<JudgedFit> sets = gains.sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().fit.effects(), (Effects{"half", "other_half"}));
  EXPECT_NEAR(sets.front().fit.log_evidence, log_evidence_of({half, other}, r), 1e-2);
  const JudgedFit* grown = find(sets, {"decoy", "half"});
  ASSERT_NE(grown, nullptr);
  EXPECT_NEAR(grown->fit.log_evidence, log_evidence_of({decoy, half}, r), 1e-2);
}

// The halves are asked for beside a mass that leads, and then without it.
TEST(SetSearch, tries_a_larger_set_without_each_of_its_members) {
  Gains gains(12);
  const VectorXd half = gains.along(0, 30) + gains.along(1, 4.5),
                 other = gains.along(0, 30) - gains.along(1, 4.5), mass = gains.along(2, 10);
  gains.add("half", "here", half);
  gains.add("other_half", "here", other);
  gains.add("mass", "here", mass);
  gains.measure(mass + half - other);
  const std::vector<JudgedFit> sets = gains.sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().fit.effects(), (Effects{"half", "mass", "other_half"}));
  EXPECT_TRUE(sets.front().credible());
  for (const Effects& two :
       {Effects{"half", "mass"}, Effects{"mass", "other_half"}, Effects{"half", "other_half"}})
    EXPECT_NE(find(sets, two), nullptr) << two[0] << " and " << two[1];
}

// One place in two ways, one end let go by two, what gave way to a cause, what slips in a test at
// one level: none of them joins.
TEST(SetSearch, joins_only_what_can_act_together) {
  Gains gains(8);
  constexpr double size = 8;
  gains.add("gain", "tip", gains.along(0, size)).way = "x";
  gains.add("gain", "tip", gains.along(1, size)).way = "y";
  constexpr int end = 100000; // a node that is not there
  gains.add("clamp", "left", gains.along(2, size)).released = {end};
  gains.add("fixture", "left", gains.along(3, size)).released = {end};
  gains.add("mass", "tip", gains.along(4, size));
  gains.add("part", "part", gains.along(5, size)).names_place_only = true;
  gains.leave_out_alone();
  gains.add("slip", "joint", gains.along(6, size)).softening = [](const VectorXd&) {
    return Softening();
  };
  gains.leave_out_alone();
  VectorXd r = VectorXd::Constant(8, size);
  r[7] = 0;
  gains.measure(r);
  const std::vector<JudgedFit> sets = gains.sets();
  for (const Effects& two : {Effects{"clamp", "gain"}, Effects{"gain", "mass"},
                             Effects{"clamp", "mass"}, Effects{"fixture", "gain"}})
    EXPECT_NE(find(sets, two), nullptr) << two[0] << " and " << two[1];
  for (const JudgedFit& j : sets) {
    const Effects effects = j.fit.effects();
    const auto count = [&](const char* name) {
      return std::count(effects.begin(), effects.end(), name);
    };
    EXPECT_LE(count("gain"), 1);
    EXPECT_LE(count("clamp") + count("fixture"), 1);
    EXPECT_EQ(count("part") + count("slip"), 0);
  }
}

// Of one effect at six places, each worth one more though errors were as large as what is left.
TEST(SetSearch, ends_at_five_effects) {
  Gains gains(15); // three for each of five parameters
  VectorXd r = VectorXd::Zero(15);
  constexpr std::array<double, 6> sizes{300, 120, 50, 20, 12, 12};
  for (Index k = 0; k < 6; ++k) {
    const VectorXd g = gains.along(k, sizes[std::size_t(k)]);
    gains.add("mass", "place" + std::to_string(k), g);
    r += g;
  }
  gains.measure(r);
  const std::vector<JudgedFit> sets = gains.sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().fit.together.size(), 5u);
  for (const JudgedFit& j : sets) EXPECT_LE(j.fit.together.size(), 5u);
}

TEST(SetSearch, finds_beside_what_leads_what_its_residual_asks_for) {
  Gains gains(8);
  const VectorXd mass = gains.along(0, 10), gain = gains.along(1, 5), idle = gains.along(2, 5);
  gains.add("mass", "here", mass);
  gains.add("gain", "here", gain);
  gains.add("idle", "here", idle);
  gains.measure(mass + gain);
  const std::vector<JudgedFit> beside = gains.beside_the_best();
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_EQ(beside.front().fit.effects(), (Effects{"gain", "mass"}));
  EXPECT_NEAR(beside.front().fit.log_evidence, log_evidence_of({mass, gain}, mass + gain), 1e-2);
}

// Of sets a nat apart, all but the first so many added up, those within eight nats of the best.
TEST(SetSearch, warns_of_sets_that_may_count_and_are_not_solved_anew) {
  const auto warning = [](std::size_t solved) {
    std::vector<JudgedFit> sets(12);
    for (std::size_t k = 0; k < sets.size(); ++k) {
      sets[k].fit.log_evidence = -double(k);
      sets[k].added_up = k >= solved;
    }
    return warning_of_added_up(sets);
  };
  EXPECT_EQ(warning(12), "");
  EXPECT_EQ(warning(9), "") << "the tenth lies nine nats behind";
  EXPECT_EQ(warning(7).find("2 more sets of effects come within 8 nats"), 0U) << warning(7);
}

// Two that change the model are added up, unless they are solved anew; what changes the test alone
// is exact either way.
TEST(SetSearch, says_of_which_sets_the_changes_are_added_up) {
  for (const bool changes : {true, false}) {
    Gains gains(8);
    const auto add = [&](const std::string& effect, const VectorXd& g) {
      Hypothesis& h = gains.add(effect, "here", g);
      if (!changes) return;
      h.changes = {{.apply = [](Model& model) { model.beams.front().section.EI_y *= 2; }}};
      h.coefficients = [](const VectorXd&) { return VectorXd(VectorXd::Zero(1)); };
    };
    add("mass", gains.along(0, 10));
    for (int k = 0; k < 4; ++k) add("gain" + std::to_string(k), gains.along(1, 10));
    gains.measure(gains.along(0, 10) + gains.along(1, 10));
    std::size_t added_up = 0;
    for (const JudgedFit& j : gains.sets()) {
      if (j.credible()) {
        EXPECT_FALSE(j.added_up) << "the best are solved anew";
      }
      added_up += j.added_up;
    }
    EXPECT_EQ(added_up > 0, changes);
  }
}

// Of four effects that all act, eleven readings carry three, twelve all.
TEST(SetSearch, has_three_readings_for_each_effect) {
  for (const int readings : {11, 12}) {
    Gains gains(readings);
    VectorXd r = VectorXd::Zero(readings);
    for (int k = 0; k < 4; ++k) {
      const VectorXd g = gains.along(k, 20);
      gains.add("effect " + std::to_string(k), "here", g);
      r += g;
    }
    gains.measure(r);
    std::size_t most = 0;
    for (const JudgedFit& j : gains.sets()) most = std::max(most, j.fit.together.size());
    EXPECT_EQ(most, std::size_t(readings / 3));
  }
}

// Alone a mass is best at its third place; beside a clamp it sits at the fourth, which lies between
// that and the fifth and was not worth a fit alone.
TEST(SetSearch, moves_members_of_the_best_sets_to_places_between_in_the_end) {
  Gains gains(12);
  const VectorXd third = gains.along(0, 10) + gains.along(1, 4),
                 fourth = gains.along(0, 10) + gains.along(1, 8),
                 fifth = gains.along(0, 10) + gains.along(1, 14), clamp = gains.along(2, 15);
  gains.add("mass", "third", third);
  gains.add("mass", "fifth", fifth);
  gains.add("clamp", "here", clamp);
  gains.add("mass", "fourth", fourth).between = {{"third", 0.5}, {"fifth", 0.5}};
  gains.leave_out_alone();
  gains.measure(fourth + clamp);
  const std::vector<JudgedFit> sets = gains.sets();
  ASSERT_FALSE(sets.empty());
  ASSERT_EQ(sets.front().fit.effects(), (Effects{"clamp", "mass"}));
  std::set<std::string> places;
  for (const Hypothesis* h : sets.front().fit.together) places.insert(h->place);
  EXPECT_EQ(places, (std::set<std::string>{"fourth", "here"}));
}

TEST(PlacesFitted, are_those_next_to_good_ones) {
  Gains gains(12);
  const auto add = [&](const std::string& effect, int place, const VectorXd& g) {
    Hypothesis& h = gains.add(effect, std::to_string(place), g);
    if (place % 2 == 0)
      h.between = {{std::to_string(place - 1), 0.5}, {std::to_string(place + 1), 0.5}};
  };
  // The farther from the eighth place, the less a mass explains; a support explains little
  // anywhere.
  for (const int parity : {1, 0})
    for (int place = 2 - parity; place <= 17; place += 2) {
      add("mass", place, gains.along(0, 30) + gains.along(1, 3. * (place - 8)));
      add("support", place, gains.along(2, 1) + gains.along(3, 0.01 * place));
    }
  gains.measure(gains.along(0, 30));
  const auto fitted = gains.searched({}, [](const SetSearch& search) {
    std::vector<const Hypothesis*> all;
    for (const Signature& s : search.all) all.push_back(s.hypothesis);
    const PlacesFitted places = fit_places(search.context, all, [&](const Hypothesis& h) {
      return judged(fit_of(search.context, {&h}), search.nominal.fit, search.context,
                    search.held_out, search.scores, search.standards);
    });
    std::map<std::string, std::set<int>> found;
    for (const JudgedFit& j : places.fits)
      found[j.fit.together[0]->effect].insert(std::stoi(j.fit.together[0]->place));
    double passed_over = 0;
    for (const auto& [effect, weight] : places.passed_over) passed_over += weight;
    EXPECT_EQ(places.fits.size() + std::size_t(passed_over), all.size());
    return found;
  });
  EXPECT_TRUE(fitted.at("mass").contains(8));
  EXPECT_FALSE(fitted.at("mass").contains(2)) << "far from the best";
  EXPECT_FALSE(fitted.at("mass").contains(16));
  std::size_t between = 0;
  for (const int place : fitted.at("support")) between += place % 2 == 0;
  EXPECT_LE(between, 5U) << "all are alike, but far behind the mass: three and what lies next";
  EXPECT_GE(between, 1U);
}

TEST(SetSearch, finds_nothing_where_it_is_stopped_at_once) {
  Gains gains(8);
  gains.add("mass", "here", gains.along(0, 10));
  gains.add("gain", "here", gains.along(1, 10));
  gains.measure(gains.along(0, 10) + gains.along(1, 10));
  DiagnosisSettings settings;
  settings.stop = [] { return true; };
  EXPECT_TRUE(gains.sets(settings).empty());
  EXPECT_FALSE(gains.sets().empty());
}

} // namespace
} // namespace plica
