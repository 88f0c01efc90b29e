// What others built and measured: cases/ says whose it is.
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/tables/effect_words.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace plica {
namespace {

using namespace changed_beam;

const std::string cases_folder = PLICA_SOURCE_DIR "/cases";

// Brake-Reuss beam: cases/lap_beam says whose measurement it is. The lap lies in the third of five
// stretches.
TEST(Baseline, finds_the_lap_of_a_free_beam_that_others_measured) {
  const CaseFile file = read_case(cases_folder + "/lap_beam/lap_beam.yaml");
  const Measured m = read_measured(cases_folder + "/lap_beam/measured.yaml");
  const Diagnosis d = diagnosis_of(file.data, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "local_damage") << d.headline;
  EXPECT_EQ(d.effects.front().place, "beam.stretch[3]") << d.headline;
  EXPECT_GT(d.gap.shrink(), 0.7);
}

// In three pieces that rigid clamps join it is still the middle one, and no clamp.
TEST(Baseline, finds_the_lap_beside_rigid_clamps) {
  Case pieces = read_case(cases_folder + "/lap_beam/lap_beam.yaml").data;
  const Part whole = pieces.parts.at(0);
  pieces.parts.clear();
  for (const auto& [name, from, to] :
       {std::tuple{"left", 0., 0.288}, {"lap", 0.288, 0.432}, {"right", 0.432, 0.72}}) {
    Part piece = whole;
    piece.name = name;
    std::get<BeamPart>(piece.body).points = {{0, from, 0}, {0, to, 0}};
    pieces.parts.push_back(piece);
  }
  Cap first, second;
  first.name = "first";
  first.of = {"left.end", "lap.start"};
  second.name = "second";
  second.of = {"lap.end", "right.start"};
  pieces.caps = {first, second};
  const Diagnosis d = diagnosis_of(pieces, read_measured(cases_folder + "/lap_beam/measured.yaml"));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  EXPECT_EQ(d.effects.front().name, "local_damage") << d.headline;
  EXPECT_TRUE(d.effects.front().place.starts_with("lap")) << d.headline;
}

// The points of a beam say nothing of where it gave way: none near the lap, one in its middle, or
// two within.
TEST(BaselineSlow, finds_the_lap_whatever_the_points_of_the_beam) {
  const CaseFile file = read_case(cases_folder + "/lap_beam/lap_beam.yaml");
  const Measured m = read_measured(cases_folder + "/lap_beam/measured.yaml");
  constexpr double length = 0.72, from = 0.288, to = 0.432;
  for (const int stretches : {1, 2, 9}) {
    Case data = file.data;
    auto& beam = std::get<BeamPart>(data.parts[0].body);
    beam.points.clear();
    for (int i = 0; i <= stretches; ++i) beam.points.push_back({0, length * i / stretches, 0});
    beam.elements = stretches == 1 ? 20 : 6;
    const Diagnosis d = diagnosis_of(data, m);
    ASSERT_FALSE(d.effects.empty()) << stretches << ": " << d.headline;
    const NamedEffect& e = d.effects.front();
    EXPECT_EQ(e.name, "local_damage") << stretches << ": " << d.headline;
    ASSERT_EQ(e.place, "beam") << stretches << ": " << d.headline;
    EXPECT_EQ(e.parameters[1].name, "at");
    EXPECT_GT(e.parameters[1].value, from) << stretches << ": " << d.headline;
    EXPECT_LT(e.parameters[1].value, to) << stretches << ": " << d.headline;
  }
}

// A frame that others built twice from one drawing: cases/two_builds. Nobody knows why the builds
// differ, and all modes rise alike.
TEST(Baseline, two_builds_of_a_frame_differ_by_nothing_that_is_sure) {
  const CaseFile file = read_case(cases_folder + "/two_builds/two_builds.yaml");
  const Measured m = read_measured(cases_folder + "/two_builds/measured.yaml");
  const Diagnosis d = diagnosis_of(file.data, m);
  EXPECT_EQ(d.verdict, Verdict::ambiguous) << d.headline;
  constexpr double sure = 0.9;
  for (const EffectInclusion& e : d.inclusion) EXPECT_LT(e.probability, sure) << e.effect;
}

// The same frame hit at each of its floors in turn (`plica identify` of its public responses): one
// against another nothing has changed.
TEST(ThreeStoreyFrame, hit_at_three_places_has_not_changed) {
  const Case data = read_case(cases_folder + "/three_storey_frame/three_storey_frame.yaml").data;
  constexpr double hertz[3][3] = {
      {6.5125, 17.4623, 26.5048}, {6.5126, 17.4624, 26.5047}, {6.5117, 17.4624, 26.5053}};
  constexpr double damping[3][3] = {{0.001603, 0.002347, 0.002173},
                                    {0.001581, 0.002309, 0.002179},
                                    {0.001632, 0.002354, 0.002183}};
  // Shapes as identified, in 1/sqrt(kg), with the signs that they came with.
  constexpr double shapes[3][3][3] = {
      {{0.1557, 0.2680, 0.3245}, {0.3341, 0.1196, -0.2613}, {0.2390, -0.3303, 0.1583}},
      {{0.1608, 0.2773, 0.3358}, {0.3335, 0.1193, -0.2608}, {-0.2424, 0.3357, -0.1611}},
      {{0.1615, 0.2786, 0.3370}, {-0.3356, -0.1201, 0.2630}, {0.2400, -0.3320, 0.1595}}};
  for (int pair = 0; pair < 18; ++pair) {
    const int before = pair % 3, after = pair / 3 % 3;
    const bool with_shapes = pair >= 9;
    if (before == after) continue;
    Measured m;
    m.specimen = data.name;
    m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
                {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
    for (const auto& [state, hit] : {std::pair{"before", before}, {"after", after}})
      for (int k = 0; k < 3; ++k) {
        MeasuredMode mode = bending(Axis::x, k + 1, state, hertz[hit][k]);
        mode.shape = MeasuredShape::other;
        mode.damping = damping[hit][k];
        if (with_shapes)
          mode.vector = {.channels = {"floor1.x", "floor2.x", "floor3.x"},
                         .real = {shapes[hit][k], shapes[hit][k] + 3},
                         .imaginary = {}};
        m.modes.push_back(mode);
      }
    const Diagnosis d = diagnosis_of(data, m);
    EXPECT_EQ(d.verdict, Verdict::none) << before << " against " << after << ": " << d.headline;
  }
}

// A frame on rails that others measured in states of a known cause: cases/sliding_frame. It is its
// own mirror image, nearly, so that its first and third storey are hardly told apart, nor its two
// inner plates; three frequencies and modes of up to 7 % of damping leave lists.
class SlidingFrame : public testing::Test {
protected:
  Measured measured(int state) const {
    return read_measured(folder + "/state_" + std::to_string(state) + "/measured.yaml");
  }
  Diagnosis of_state(int state) const { return diagnosis_of(drawn, measured(state)); }

  // Whether what leads is lost stiffness in one of these storeys.
  static bool leads(const Diagnosis& d, const std::vector<int>& storeys) {
    return !d.effects.empty() && d.effects.front().name == "local_damage" &&
           std::any_of(storeys.begin(), storeys.end(), [&](int storey) {
             return d.effects.front().place == "columns.stretch[" + std::to_string(storey) + "]";
           });
  }

  const std::string folder = cases_folder + "/sliding_frame";
  const Case drawn = read_case(folder + "/sliding_frame.yaml").data;
};

// Of one or two of the four columns of a storey seven eighths are lost.
TEST_F(SlidingFrame, storeys_that_became_softer) {
  for (const auto& [state, storeys, columns] :
       {std::tuple{5, std::vector{1, 3}, 2}, std::tuple{6, std::vector{2}, 1},
        std::tuple{7, std::vector{2}, 2}, std::tuple{8, std::vector{1, 3}, 1},
        std::tuple{9, std::vector{1, 3}, 2}}) {
    const Diagnosis d = of_state(state);
    ASSERT_TRUE(leads(d, storeys)) << state << ": " << d.headline;
    const EstimatedParameter& loss = d.effects.front().parameters.front();
    EXPECT_LE(loss.interval[0], columns * 7. / 32) << state;
    EXPECT_GE(loss.interval[1], columns * 7. / 32) << state;
  }
  // The second mode rose by 0.7 %, which nothing that is softer does.
  EXPECT_TRUE(leads(of_state(4), {1, 3}));
}

TEST_F(SlidingFrame, mass_on_a_plate) {
  const Diagnosis d = of_state(3);
  ASSERT_EQ(d.verdict, Verdict::ambiguous) << d.headline;
  for (const NamedEffect& e : d.effects) {
    EXPECT_TRUE(e.name == "added_mass" || e.name == "component_mass") << d.headline;
    EXPECT_TRUE(e.place.ends_with("floor1") || e.place.ends_with("floor2")) << e.place;
  }
}

// Too little changed, or what no hypothesis knows: a bumper, which knocks.
TEST_F(SlidingFrame, nothing_is_sure_that_is_not_so) {
  for (int state : {2, 10}) EXPECT_EQ(of_state(state).verdict, Verdict::none) << state;
  for (int state : {4, 14}) {
    const Diagnosis d = of_state(state);
    EXPECT_TRUE(d.verdict == Verdict::ambiguous || d.verdict == Verdict::unknown) << d.headline;
  }
}

// Supports may leave a part free to slide: it is a rigid motion, and no mode. What they take away
// at every node is no motion at all.
TEST_F(SlidingFrame, on_rails_that_hold_nothing) {
  Case free = drawn;
  free.mount.clear();
  free.caps.clear();
  free.supports.push_back({.set = "columns.start", .dofs = {1, 2, 3, 4, 5}});
  Measured m = measured(9);
  for (MeasuredMode& mode : m.modes) --mode.order;
  for (const int elements : {2, 1}) { // of a storey: 1 leaves no node without a support
    std::get<BeamPart>(free.parts[0].body).elements = elements;
    const Diagnosis d = diagnosis_of(free, m);
    EXPECT_TRUE(leads(d, {1, 3})) << elements << ": " << d.headline;
  }
}

// The roller beam (cases/roller_beam): its measured stations, and the ways in which it may be
// drawn.
class RollerBeamCase : public testing::Test {
protected:
  // `points` of the case along the beam, m; none = as drawn. Held by a mount, or by supports.
  Case beam(const std::vector<double>& points, bool on_supports) const {
    Case data = drawn_;
    if (!points.empty()) {
      auto& beam = std::get<BeamPart>(data.parts[0].body);
      beam.points.clear();
      for (double y : points) beam.points.push_back({0, y, 0});
      std::get<PointMass>(data.parts[1].body).at =
          "beam.point[" + std::to_string(points.size() - 1) + "]";
    }
    if (on_supports) {
      data.mount.clear();
      data.caps.clear();
      data.supports = {{.set = "beam.start", .dofs = {0, 1, 2, 3, 4, 5}}};
    }
    return data;
  }

  // The place by the roller's voltage, mm. At the first the second frequency is 2 % below that of
  // any stiff roller there, which a soft one farther out would have; there are more stiff ones.
  void expect_found(const Case& data, int number) const {
    constexpr std::array place{63.9, 86.7, 110.3, 133.0, 156.4, 179.8};
    const double truth = place.at(std::size_t(number));
    const std::string station = "station_" + std::to_string(number + 1);
    const Diagnosis d = diagnosis_of(data, read_measured(folder_ + station + "/measured.yaml"));
    ASSERT_TRUE(d.verdict == Verdict::identified || d.verdict == Verdict::ambiguous)
        << station << ": " << d.headline;
    const NamedEffect& e = d.effects.front();
    ASSERT_EQ(e.name, "extra_support") << station << ": " << d.headline;
    EXPECT_EQ(e.way, "z");
    ASSERT_EQ(e.parameters.back().name, "at");
    const double mm = 1e3 * e.parameters.back().value;
    EXPECT_NEAR(mm, truth, 10) << station;
    EXPECT_LE(1e3 * e.parameters.back().interval[0], truth) << station;
    EXPECT_GE(1e3 * e.parameters.back().interval[1], truth) << station;
  }

  static constexpr int stations = 6;
  const std::vector<double> other_points{0, 0.1, 0.2, 0.343, 0.501},
      many_points{0, 0.055, 0.12, 0.19, 0.26, 0.343, 0.42, 0.501};

private:
  const std::string folder_ = cases_folder + "/roller_beam/";
  const Case drawn_ = read_case(folder_ + "roller_beam.yaml").data;
};

using RollerBeam = RollerBeamCase;
TEST_F(RollerBeam, something_supports_it_and_where) {
  for (int number : {1, 3}) expect_found(beam({}, false), number); // all: RollerBeamSlow
}

TEST_F(RollerBeam, is_held_and_drawn_as_one_likes) {
  expect_found(beam(other_points, true), 5);
}

using RollerBeamSlow = RollerBeamCase;
TEST_F(RollerBeamSlow, at_every_station_however_it_is_held_and_drawn) {
  for (const std::vector<double>& points : {std::vector<double>(), other_points, many_points})
    for (const bool on_supports : {false, true})
      for (int number = 0; number < stations; ++number)
        expect_found(beam(points, on_supports), number);
}

// Cuts of 6 mm in a clamped beam of 20 mm, of two frequencies (cases/cracked_cantilever): their
// place is held, and nothing is sure, as a mass explains two readings as well.
TEST(CrackedCantilever, cuts_are_listed_at_their_place_and_nothing_is_sure) {
  const std::string folder = cases_folder + "/cracked_cantilever";
  const Case whole = read_case(folder + "/cracked_cantilever.yaml").data;
  for (const auto& [cut, at] :
       {std::pair{"cut_80_6", 0.08}, {"cut_140_6", 0.14}, {"cut_200_6", 0.2}}) {
    const Diagnosis d = diagnosis_of(whole, read_measured(folder + "/" + cut + "/measured.yaml"));
    EXPECT_EQ(d.verdict, Verdict::ambiguous) << cut << ": " << d.headline;
    EXPECT_LE(d.effects.size(), 3U) << cut << ": " << d.headline;
    const auto damage = std::find_if(d.effects.begin(), d.effects.end(),
                                     [](const NamedEffect& e) { return e.name == "local_damage"; });
    ASSERT_NE(damage, d.effects.end()) << cut << ": " << d.headline;
    const auto advised = [&](const char* what) {
      return std::find(d.advice.begin(), d.advice.end(), what) != d.advice.end();
    };
    EXPECT_NE(advised("local_damage or added_mass: weigh the part"),
              advised("added_mass or local_damage: weigh the part"))
        << cut;
    EXPECT_FALSE(advised("local_damage or rotated_sensor: turn the sensor")) << "there is none";
    const EstimatedParameter& place = damage->parameters.at(1);
    EXPECT_LE(place.interval[0], at) << cut;
    EXPECT_GE(place.interval[1], at) << cut;
  }
}

// Between which stress holds a cut of a share of the depth open, Nm/rad: an edge crack in bending,
// H. Tada, P. Paris, G. Irwin, The Stress Analysis of Cracks Handbook, in plane stress and strain.
std::array<double, 2> hinge_of_crack(double share) {
  constexpr double E = 206e9, nu = 0.3, depth = 0.02, width = 0.02;
  const double open = share / (1 - share);
  const double S =
      open * open * (5.93 + share * (-19.69 + share * (37.14 + share * (-35.84 + share * 13.12))));
  const double stress = E * depth * depth * width / (24 * S);
  return {stress, stress / (1 - nu * nu)};
}

// The same beam in four pieces that rigid clamps join, where it was cut and where not; joints alone
// may have changed. The cuts are of one depth, and so are the hinges that they make.
TEST(CrackedCantilever, cuts_are_rigid_clamps_that_give_way) {
  const std::string folder = cases_folder + "/cracked_cantilever";
  Case pieces = read_case(folder + "/cracked_cantilever.yaml").data;
  const Part whole = pieces.parts.at(0);
  const std::array<double, 5> ends{0, 0.08, 0.14, 0.2, 0.3};
  pieces.parts.clear();
  for (std::size_t i = 1; i < ends.size(); ++i) {
    Part piece = whole;
    piece.name = "piece" + std::to_string(i);
    auto& beam = std::get<BeamPart>(piece.body);
    beam.points = {{0, ends[i - 1], 0}, {0, ends[i], 0}};
    beam.elements = 4;
    pieces.parts.push_back(piece);
  }
  pieces.caps.at(0).of = {"piece1.start"};
  for (const char* joint : {"at_80", "at_140", "at_200"}) {
    Cap cap;
    cap.name = joint;
    const std::size_t i = pieces.caps.size();
    cap.of = {"piece" + std::to_string(i) + ".end", "piece" + std::to_string(i + 1) + ".start"};
    pieces.caps.push_back(cap);
  }
  pieces.diagnose.effects = {"joint_stiffness"};
  const auto [stress, strain] = hinge_of_crack(0.3);
  EXPECT_NEAR(stress, 149e3, 1e3);
  double softest = 1e300, stiffest = 0;
  for (const char* cut : {"80", "140", "200"}) {
    const Diagnosis d =
        diagnosis_of(pieces, read_measured(folder + "/cut_" + cut + "_6/measured.yaml"));
    ASSERT_FALSE(d.effects.empty()) << cut << ": " << d.headline;
    const NamedEffect& e = d.effects.front();
    EXPECT_EQ(e.name, "joint_stiffness") << cut << ": " << d.headline;
    EXPECT_EQ(e.place, std::string("caps.at_") + cut) << d.headline;
    EXPECT_EQ(e.way, "bending") << cut << ": " << d.headline;
    const EstimatedParameter& k = e.parameters.front();
    EXPECT_LE(k.interval[0], stress) << cut;
    EXPECT_GE(k.interval[1], strain) << cut;
    if (e.place == "caps.at_140") { // of two frequencies
      EXPECT_NE(plain_at_place(e).find("at caps.at_140 or one of 2 other places"),
                std::string::npos)
          << plain_at_place(e);
    }
    softest = std::min(softest, k.value);
    stiffest = std::max(stiffest, k.value);
  }
  EXPECT_LT(stiffest / softest, 1.15);
}

// Of 2 mm they lie within what mounting anew may do.
TEST(CrackedCantilever, shallow_cuts_are_not_seen) {
  const std::string folder = cases_folder + "/cracked_cantilever";
  const Case whole = read_case(folder + "/cracked_cantilever.yaml").data;
  for (const char* cut : {"cut_80_2", "cut_140_2", "cut_200_2"}) {
    const Diagnosis d = diagnosis_of(whole, read_measured(folder + "/" + cut + "/measured.yaml"));
    EXPECT_EQ(d.verdict, Verdict::none) << cut << ": " << d.headline;
  }
}

} // namespace
} // namespace plica
