// A frame whose feet stand on one mounted cap: which of them is loose, of modes before and after.
#include "io/tables/effect_words.hpp"
#include "tests/bellows_case.hpp"
#include "tests/bolted_plate.hpp"
#include "tests/changed_beam.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using namespace changed_beam;

// Two legs of unlike length and a bar across, 20 x 8 mm of steel.
Case portal(std::vector<SprungEnd> feet = {}) {
  Case c = beam_of(1, 0.4, 0.02, 0.008, false);
  const BeamPart drawn = std::get<BeamPart>(c.parts[0].body);
  c.name = "portal";
  c.parts.clear();
  const auto add = [&](const char* name, std::vector<Triple> points, const Triple& up) {
    BeamPart beam = drawn;
    beam.points = std::move(points);
    beam.elements = 4;
    beam.up = up;
    c.parts.push_back({name, beam});
  };
  add("left", {{0, 0, 0}, {0, 0, 0.25}}, {1, 0, 0});
  add("bar", {{0, 0, 0.25}, {0, 0.25, 0.25}, {0, 0.4, 0.25}}, {0, 0, 1});
  add("right", {{0, 0.4, 0.05}, {0, 0.4, 0.25}}, {1, 0, 0});
  Cap table, first, second;
  table.name = "table";
  table.of = {"left.start", "right.start"};
  table.ends = std::move(feet);
  first.name = "first";
  first.of = {"left.end", "bar.start"};
  second.name = "second";
  second.of = {"right.end", "bar.end"};
  c.caps = {table, first, second};
  c.mount = {{.cap = "table"}};
  return c;
}

// Modes by their number; each some percents off those of the model, near ones alike, and once
// mounted anew some thousandths off itself.
Measured by_number(const Case& before, const Case& after, std::size_t modes,
                   const std::array<double, 8>& model_error) {
  constexpr std::array mounted_anew{0.002, -0.003, 0.001, 0.003, -0.002, 0.001, -0.002, 0.};
  const Results first = test::run_silently(before), second = test::run_silently(after);
  Measured m;
  m.specimen = "portal";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  for (const auto& [state, results] : {std::pair{"before", &first}, {"after", &second}})
    for (std::size_t i = 0; i < modes; ++i) {
      const double error = model_error[i] + (results == &second ? mounted_anew[i] : 0);
      m.modes.push_back(
          bending(Axis::z, int(i) + 1, state, results->modes.at(i).frequency * std::exp(error)));
      m.modes.back().shape = MeasuredShape::other;
    }
  return m;
}

Measured portal_before_and_after(const Case& before, const Case& after) {
  return by_number(before, after, 8, {0.031, -0.024, 0.017, -0.035, 0.012, -0.02, -0.01, 0.008});
}

void expect_found(const std::string& foot, double loose) {
  const Case after = portal({{.end = foot, .stiffness = {1e11, 1e11, 1e11, loose, 1e9, loose}}});
  const Diagnosis d = diagnosis_of(portal(), portal_before_and_after(portal(), after));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "joint_stiffness") << d.headline;
  EXPECT_EQ(e.place, "caps.table." + foot) << d.headline;
  EXPECT_EQ(e.way, "bending") << d.headline;
  EXPECT_LE(e.parameters.front().interval[0], loose) << d.headline;
  EXPECT_GE(e.parameters.front().interval[1], loose) << d.headline;
  EXPECT_FALSE(e.nodes.empty()) << "the report shows where";
}

TEST(LooseFeet, the_one_that_turns_is_named) {
  expect_found("right.start", 1500);
}

TEST(LooseFeetSlow, either_is_named) {
  expect_found("left.start", 1500);
  expect_found("right.start", 6000);
}

TEST(LooseFeet, that_hold_are_not_named) {
  const Diagnosis same = diagnosis_of(portal(), portal_before_and_after(portal(), portal()));
  EXPECT_EQ(same.verdict, Verdict::none) << same.headline;
}

// A beam that one cap holds at both ends is let go at one: as a cantilever it has a sixth of its
// frequency.
TEST(LooseFeet, a_lost_end_of_a_beam_is_named) {
  Case drawn = beam_of(4, 0.6, 0.025, 0.012, false);
  Cap table;
  table.name = "table";
  table.of = {"beam.start", "beam.end"};
  drawn.caps.push_back(table);
  drawn.mount.push_back({.cap = "table"});
  Case lost = drawn;
  lost.caps[0].of.pop_back();
  const Measured m = changed_beam::before_and_after(drawn, lost);
  const Diagnosis d = diagnosis_of(drawn, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "joint_stiffness") << d.headline;
  EXPECT_EQ(e.way, "all directions") << d.headline;
  EXPECT_TRUE(e.place.starts_with("caps.table.beam.")) << d.headline; // either, by symmetry
  EXPECT_EQ(e.parameters.front().interval[0], 0) << "nothing is left, as far as readings tell";
}

// A bolt of four is lost, which stand nearly alike: that one lets go in all directions is sure,
// which one is not.
TEST(LooseFeetSlow, a_lost_bolt_is_named_as_far_as_symmetry_lets) {
  const Case drawn = test::bolted_plate(4);
  const Diagnosis d =
      diagnosis_of(drawn, by_number(drawn, test::bolted_plate(3), 6,
                                    {0.031, -0.024, 0.017, 0.02, 0.012, 0.016, 0, 0}));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "joint_stiffness") << d.headline;
  EXPECT_EQ(e.way, "all directions") << d.headline;
  EXPECT_TRUE(e.place.starts_with("caps.table.plate.bolt")) << d.headline;
  std::vector<std::string> places = e.other_places;
  places.push_back(e.place);
  EXPECT_NE(std::find(places.begin(), places.end(), "caps.table.plate.bolt4"), places.end())
      << d.headline;
  EXPECT_EQ(places.size(), 4U) << d.headline;
  EXPECT_GT(e.anywhere, 0.9);
  EXPECT_LT(e.probability, 0.5);
  EXPECT_NE(plain_at_place(e).find("or one of 3 other places"), std::string::npos);
}

TEST(LooseFeetSlow, are_not_a_mass_on_the_bar) {
  Case heavier = portal();
  PointMass weight;
  weight.at = "bar.point[2]";
  weight.mass = 0.05;
  heavier.parts.push_back({"weight", weight});
  const Diagnosis d = diagnosis_of(portal(), portal_before_and_after(portal(), heavier));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "added_mass") << d.headline;
  EXPECT_EQ(d.effects.front().place, "bar") << d.headline;
}

} // namespace
} // namespace plica
