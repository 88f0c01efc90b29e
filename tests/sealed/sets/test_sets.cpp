// The suite of sets: its plan, its truth in the library's words, and its marks.
#include "../files.hpp"
#include "marked_set.hpp"
#include "sets.hpp"

#include <gtest/gtest.h>
#include <set>

using namespace sealed;
using nlohmann::json;

namespace {

json truth_with(const std::string& kind, const json& effects, const std::string& structure) {
  return {{"id", "001"},    {"structure", structure}, {"kind", kind},
          {"class", "any"}, {"strength", "strong"},   {"effects", effects}};
}

json effect(const std::string& name, const std::string& place, const json& value = json::object()) {
  return {{"name", name}, {"place", place}, {"value", value}};
}

json row(json said, double anywhere, double low = 0, double high = 1) {
  said["anywhere"] = anywhere;
  return {{"effects", json::array({said})}, {"share", 0.5}, {"interval", {low, high}}};
}

Scored scored(const json& truth, const std::string& verdict, const json& effects,
              const json& rows = json::array()) {
  Scored s;
  s.kind = truth["kind"];
  s.verdict = verdict;
  s.truth = truth;
  s.diagnosis = {{"verdict", verdict}, {"effects", effects}, {"ledger", {{"rows", rows}}}};
  return s;
}

const json mass = effect("added_mass", "sensor.mid"), gain = effect("sensor_gain", "sensor.mid"),
           hot = effect("temperature", "all");

} // namespace

TEST(SealedSets, the_plan_has_the_promised_specimens) {
  const Suite suite = plan_sets({.seed = 1});
  std::map<std::string, int> kinds, structures, left_out;
  std::set<std::string> walls;
  for (const Specimen& s : suite.specimens) {
    ++kinds[s.kind];
    ++structures[s.structure];
    if (!s.without.empty()) {
      ++left_out[s.kind];
      EXPECT_EQ(s.effects.back().name, s.without);
    }
    EXPECT_EQ(s.wall.empty(), s.structure != "short_bellows");
    if (!s.wall.empty()) walls.insert(s.wall);
    EXPECT_LE(std::count_if(s.effects.begin(), s.effects.end(), needs_wall), 1);
    for (std::size_t i = 0; i < s.effects.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_TRUE(told_apart(s.structure, s.effects[i], s.effects[j])) << s.cls;
    const std::size_t known = known_effects(truth_of(s, {})).size();
    EXPECT_EQ(known, s.kind == "triple"                                     ? 3u
                     : s.kind == "pair"                                     ? 2u
                     : s.kind == "effect" || s.kind == "known_and_stranger" ? 1u
                                                                            : 0u)
        << s.cls;
  }
  EXPECT_EQ(kinds, (std::map<std::string, int>{{"triple", 60},
                                               {"pair", 60},
                                               {"effect", 60},
                                               {"none", 40},
                                               {"stranger", 40},
                                               {"known_and_stranger", 40}}));
  EXPECT_EQ(structures["short_bellows"], 120);
  EXPECT_EQ(structures["bolted_lap"], 90);
  EXPECT_GE(left_out["stranger"], 10);
  EXPECT_GE(left_out["known_and_stranger"], 10);
  EXPECT_LE(walls.size(), 10u);
}

TEST(SealedSets, the_plan_is_the_same_for_the_same_seed) {
  const auto print = [](const Suite& suite) {
    std::string text;
    for (const Specimen& s : suite.specimens) text += truth_of(s, {}).dump();
    return text;
  };
  EXPECT_EQ(print(plan_sets({.seed = 3, .rounds = 2})), print(plan_sets({.seed = 3, .rounds = 2})));
  EXPECT_NE(print(plan_sets({.seed = 3, .rounds = 2})), print(plan_sets({.seed = 4, .rounds = 2})));
}

TEST(SealedSets, what_looks_alike_is_in_no_set) {
  const auto apart = [](const char* structure, const Effect& a, const Effect& b) {
    return told_apart(structure, a, b) && told_apart(structure, b, a);
  };
  EXPECT_FALSE(
      apart("short_bellows", {"temperature", "all", {}}, {"joint_stiffness", "interlock", {}}));
  EXPECT_FALSE(apart("short_bellows", {"added_mass", "bellows.convolution[4]", {}},
                     {"extra_support", "bellows.convolution[5]", {}})); // mirror images
  EXPECT_FALSE(apart("cantilever_masses", {"component_mass", "m2", {}},
                     {"added_mass", "beam.point[3]", {}}));
  EXPECT_TRUE(apart("cantilever_masses", {"added_mass", "beam.point[2]", {}},
                    {"added_mass", "beam.point[4]", {}}));
  EXPECT_FALSE(apart("bolted_lap", {"damping", "all", {}}, {"damping", "all", {}}));
}

// Places, ways and parameters of diagnose/effects/.
TEST(SealedSets, a_truth_is_said_in_the_words_of_the_library) {
  const auto said = [](const std::string& structure, const Effect& e) {
    Specimen s{.structure = structure, .kind = "effect", .effects = {e}};
    const json own = (*supposed(truth_of(s, {})))["effects"][0];
    std::string text = std::string(own["effect"]) + "@" + std::string(own["place"]) + " (" +
                       own.value("way", "") + ")";
    for (const auto& [key, value] : own["value"].items()) text += " " + key;
    return text;
  };
  const auto of = [&](const std::string& structure, const std::string& name, int variant = 0) {
    return said(structure, graded(structure, name, 1, variant).front());
  };
  const std::string bellows = "short_bellows", beam = "cantilever_masses", lap = "bolted_lap";
  EXPECT_EQ(of(bellows, "added_mass"), "added_mass@sensor.mid () mass");
  EXPECT_EQ(of(bellows, "added_mass", 1),
            "added_mass@bellows.convolution[6] (on the mean motion) mass");
  EXPECT_EQ(of(bellows, "extra_support"),
            "extra_support@bellows.convolution[3] (on the mean motion) k");
  EXPECT_EQ(of(beam, "added_mass"), "added_mass@beam () at mass");
  EXPECT_EQ(of(beam, "extra_support"), "extra_support@beam (all round) at k");
  EXPECT_EQ(of(beam, "component_mass"), "component_mass@m2 () ratio");
  EXPECT_EQ(of(bellows, "component_mass"), "component_mass@interlock () ratio");
  EXPECT_EQ(of(bellows, "ply_slip"), "ply_slip@bellows () bond");
  EXPECT_EQ(of(bellows, "forming_thinning"), "forming_thinning@bellows () exponent");
  EXPECT_EQ(of(bellows, "joint_stiffness"), "joint_stiffness@interlock () ratio");
  EXPECT_EQ(of(lap, "joint_stiffness"), "joint_stiffness@caps.lap () ratio");
  EXPECT_EQ(of(bellows, "fixture_flexibility"),
            "fixture_flexibility@mount.left () frequency mass rocking spread");
  EXPECT_EQ(of(lap, "boundary_compliance"),
            "boundary_compliance@mount.left () k_rotation k_translation");
  EXPECT_EQ(of(bellows, "cross_axis_base_motion"),
            "cross_axis_base_motion@base (x and y alike) fraction");
  EXPECT_EQ(of(lap, "cross_axis_base_motion"), "cross_axis_base_motion@base (z to x) fraction");
  EXPECT_EQ(of(bellows, "rotated_sensor"), "rotated_sensor@sensor.mid (about z) angle");
  EXPECT_EQ(of(bellows, "rotated_sensor", 1), "rotated_sensor@sensor.quarter (about x) angle");
  EXPECT_EQ(of(bellows, "sensor_gain"), "sensor_gain@sensor.mid () gain");
  EXPECT_EQ(of(bellows, "unweighed_mass"), "unweighed_mass@bellows () ratio");
  EXPECT_EQ(of(bellows, "damping"), "damping@all () ratio");
  EXPECT_EQ(of(bellows, "temperature"), "temperature@all () delta_T");
  EXPECT_EQ(
      said(bellows, {"local_damage", "bellows.convolution[3]", {{"loss", 0.5}, {"angle", 1.18}}}),
      "local_damage@bellows.convolution[3] (67.5 degrees) loss");
  const json at =
      (*supposed(truth_with("effect", json::array({effect("added_mass", "beam.point[3]")}), beam)));
  EXPECT_DOUBLE_EQ(at["effects"][0]["value"]["at"], 0.3);
}

TEST(SealedSets, strangers_are_not_supposed_and_slip_cannot_be) {
  json truth = truth_with("known_and_stranger", {mass, effect("clearance", "sensor.joint")}, "x");
  EXPECT_EQ((*supposed(truth))["effects"].size(), 1u);
  truth = truth_with("stranger", json::array({hot}), "short_bellows");
  truth["left_out"] = "temperature";
  EXPECT_TRUE((*supposed(truth))["effects"].empty());
  truth = truth_with("effect", json::array({effect("joint_friction", "caps.lap")}), "bolted_lap");
  EXPECT_FALSE(supposed(truth));
}

TEST(SealedSets, confident_and_wrong_by_verdict_place_and_inclusion) {
  const json truth = truth_with("pair", {mass, gain}, "short_bellows");
  const auto wrong = [&](const std::string& verdict, const json& effects, const json& rows) {
    return mark_set(scored(truth, verdict, effects, rows), {}).wrong;
  };
  EXPECT_FALSE(wrong("several", {mass, gain}, {row(mass, 1), row(gain, 1)}));
  EXPECT_TRUE(wrong("several", {mass, hot}, {row(mass, 1), row(hot, 1)}));
  EXPECT_FALSE(
      wrong("mostly", json::array({mass}), json::array({row(mass, 0.95)}))); // a part of the truth
  EXPECT_FALSE(wrong("unknown", json::array(), json::array({row(hot, 0.89)})));
  EXPECT_TRUE(wrong("unknown", json::array(), json::array({row(hot, 0.9)})));
  json elsewhere = effect("added_mass", "sensor.quarter");
  EXPECT_TRUE(wrong("identified", json::array({elsewhere}), json::array({row(elsewhere, 1)})));
  elsewhere["other_places"] = {"sensor.mid"};
  EXPECT_FALSE(wrong("identified", json::array({elsewhere}), json::array({row(elsewhere, 1)})));
  EXPECT_FALSE(wrong("ambiguous", json::array({hot}), json::array()));
}

// What cannot be told apart is one row.
TEST(SealedSets, a_row_of_alternatives_is_wrong_where_none_of_them_is_true) {
  const json truth = truth_with("pair", {mass, gain}, "short_bellows");
  const json other = effect("damping", "all");
  const auto either = [](const json& a, const json& b, double anywhere) {
    json both = row(a, anywhere);
    both["effects"].push_back(row(b, anywhere)["effects"][0]);
    return both;
  };
  const auto wrong = [&](const std::string& verdict, const json& effects, const json& rows) {
    return mark_set(scored(truth, verdict, effects, rows), {}).wrong;
  };
  EXPECT_TRUE(wrong("several", {mass, hot, other}, {row(mass, 1), either(hot, other, 0.5)}));
  EXPECT_FALSE(wrong("several", {mass, hot, gain}, {row(mass, 1), either(hot, gain, 0.5)}));
  // The one true effect stands for one row only.
  EXPECT_TRUE(wrong("several", {mass, hot}, {row(mass, 1), either(hot, mass, 0.5)}));
  EXPECT_FALSE(wrong("several", {mass, gain}, {either(mass, gain, 1), row(mass, 1)}));
  EXPECT_TRUE(wrong("unknown", json::array(), json::array({either(hot, other, 0.9)})));
  EXPECT_FALSE(wrong("unknown", json::array(), json::array({either(hot, other, 0.89)})));
  EXPECT_FALSE(wrong("unknown", json::array(), json::array({either(hot, gain, 0.9)})));
}

// Another set that is listed explains the test as well.
TEST(SealedSets, an_effect_of_another_set_stands_in) {
  const json truth = truth_with("pair", {mass, gain}, "short_bellows");
  const json rows{row(mass, 1), row(hot, 0.6)};
  const MarkedSet m = mark_set(scored(truth, "several", {mass, hot, gain}, rows), {});
  EXPECT_FALSE(m.wrong);
  EXPECT_TRUE(m.all_named);
  EXPECT_TRUE(mark_set(scored(truth, "several", {mass, hot}, rows), {}).wrong);
}

// An absorber below its frequency is a mass; the truth says so before anything is diagnosed.
TEST(SealedSets, a_stranger_may_be_told_as_what_is_stated_to_look_alike) {
  json truth =
      truth_with("stranger", json::array({effect("absorber", "sensor.mid")}), "short_bellows");
  const auto wrong = [&](const json& said) {
    return mark_set(scored(truth, "mostly", json::array({said}), json::array({row(said, 1)})), {})
        .wrong;
  };
  EXPECT_TRUE(wrong(mass)); // nothing is stated
  truth["look_alikes"] = {"added_mass", "fixture_flexibility"};
  EXPECT_FALSE(wrong(mass));
  EXPECT_TRUE(wrong(effect("added_mass", "sensor.quarter")));
  EXPECT_TRUE(wrong(hot));
  EXPECT_FALSE(wrong(effect("fixture_flexibility", "mount.left")));
}

TEST(SealedSets, a_place_along_the_beam_is_right_in_its_interval) {
  const json truth = truth_with("effect", json::array({effect("added_mass", "beam.point[3]")}),
                                "cantilever_masses");
  json said = effect("added_mass", "beam");
  said["interval"] = {{"at", {0.28, 0.31}}};
  EXPECT_FALSE(
      mark_set(scored(truth, "identified", json::array({said}), json::array({row(said, 1)})), {})
          .wrong);
  said["interval"] = {{"at", {0.31, 0.33}}};
  EXPECT_TRUE(
      mark_set(scored(truth, "identified", json::array({said}), json::array({row(said, 1)})), {})
          .wrong);
}

TEST(SealedSets, an_ambiguous_list_counts_up_to_three) {
  const json truth = truth_with("effect", json::array({mass}), "short_bellows");
  const json other = effect("damping", "all"), third = effect("unweighed_mass", "bellows");
  const MarkedSet three = mark_set(scored(truth, "ambiguous", {hot, other, mass}), {});
  EXPECT_TRUE(three.ambiguous_right && three.first_right && three.found == 1);
  const MarkedSet four = mark_set(scored(truth, "ambiguous", {hot, other, third, mass}), {});
  EXPECT_FALSE(four.ambiguous_right || four.first_right || four.found > 0);
  EXPECT_FALSE(mark_set(scored(truth, "ambiguous", {hot, other}), {}).ambiguous_right);
}

TEST(SealedSets, an_ambiguous_answer_is_right_where_one_of_its_sets_holds_all_of_the_truth) {
  const json truth = truth_with("pair", {mass, gain}, "short_bellows");
  const auto marked = [&](const json& effects, const json& rows) {
    return mark_set(scored(truth, "ambiguous", effects, rows), {});
  };
  json either = row(gain, 0.5);
  either["effects"].push_back(hot);
  const MarkedSet sets = marked({mass, gain, hot}, {row(mass, 0.5), either});
  EXPECT_TRUE(sets.ambiguous_right && sets.all_named);
  // A list of single effects: each alone.
  json list = row(mass, 0.5);
  list["effects"].push_back(gain);
  const MarkedSet singles = marked({mass, gain}, json::array({list}));
  EXPECT_FALSE(singles.ambiguous_right || singles.all_named);
  EXPECT_EQ(singles.found, 1);
  EXPECT_EQ(marked({mass, gain}, json::array()).found, 1) << "without rows it is such a list";
  const MarkedSet half = marked({mass, hot}, {row(mass, 0.5), row(hot, 0.5)});
  EXPECT_FALSE(half.ambiguous_right);
  EXPECT_EQ(half.found, 1);
}

TEST(SealedSets, intervals_of_shares_are_held_against_the_true_ones) {
  const json truth = truth_with("known_and_stranger", {mass, effect("absorber", "x")}, "any");
  const json left{{"left", "unexplained"},
                  {"effects", json::array()},
                  {"share", 0.3},
                  {"interval", {0.2, 0.4}}};
  const json own{{"rows",
                  {{{"effects", json::array({mass})}, {"share", 0.61}},
                   {{"left", "measurement"}, {"share", 0.1}},
                   {{"left", "unexplained"}, {"share", 0.29}}}}};
  MarkedSet m =
      mark_set(scored(truth, "mostly", json::array({mass}), {row(mass, 1, 0.5, 0.7), left}), own);
  EXPECT_EQ(m.shares, 1);
  EXPECT_EQ(m.shares_held, 1);
  EXPECT_TRUE(m.unexplained.value_or(false));
  m = mark_set(scored(truth, "mostly", json::array({mass}), {row(mass, 1, 0.62, 0.7), left}), own);
  EXPECT_EQ(m.shares_held, 0);
  m = mark_set(scored(truth, "mostly", json::array({hot}), {row(hot, 1), left}), own);
  EXPECT_EQ(m.shares, 0);
}
