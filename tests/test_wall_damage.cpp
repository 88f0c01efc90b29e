// Spots of plates and of parts that are read from a file that have lost some of their stiffness.
#include "diagnose/effects/place_nodes.hpp"
#include "diagnose/effects/places.hpp"
#include "diagnose/effects/wall_damage.hpp"
#include "io/input/measured_file.hpp"
#include "io/tables/ledger_words.hpp"
#include "tests/changed_beam.hpp"
#include "tests/deck_panel.hpp"
#include "tests/steel_plate.hpp"
#include "tests/support/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace test::deck_panel;

// The panel on a mesh twice as fine, where a rectangle of 40 x 30 mm about a point has this share
// of its modulus, and of its mass.
VectorXd frequencies(double x, double y, double modulus) {
  Model model = build(drawn(48, 32)).model;
  ShellProperties soft = model.shells.front();
  soft.section.E *= modulus;
  model.shells.push_back(soft);
  for (std::size_t q = 0; q < model.mesh.quads.size(); ++q) {
    const Vector3d away = quad_centre(model, int(q)) - Vector3d(x, y, 0);
    if (std::abs(away.x()) < 0.02 && std::abs(away.y()) < 0.015)
      model.mesh.quads[q].section = int(model.shells.size()) - 1;
  }
  return test::find_modes(model, 8).hertz;
}

// Hit and weighed before and after; every mode as mounted anew some ten-thousandths off.
Measured before_and_after(double x, double y, double modulus) {
  constexpr std::array anew{4e-4, -6e-4, 2e-4, 5e-4, -4e-4, 3e-4, -2e-4, 1e-4};
  Measured m;
  m.specimen = "panel";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  for (const char* state : {"before", "after"}) {
    const bool is_after = state == m.states[1].name;
    const VectorXd hertz = frequencies(x, y, is_after ? modulus : 1);
    for (Index i = 0; i < hertz.size(); ++i) {
      MeasuredMode mode;
      mode.shape = MeasuredShape::other;
      mode.order = int(i) + 1;
      mode.state = state;
      mode.frequency = hertz[i] * (is_after ? 1 + anew[std::size_t(i)] : 1);
      m.modes.push_back(mode);
    }
    m.weighings.emplace_back().value = rho * thickness * length * width;
    m.weighings.back().state = state;
  }
  return m;
}

Vector3d at(const Case& c, const std::string& place) {
  const BuiltCase built = build(c);
  const Measured none;
  const std::vector<int> nodes = nodes_at({.data = c, .built = built, .measured = none}, place);
  EXPECT_EQ(nodes.size(), 1U) << place;
  return built.model.mesh.nodes[std::size_t(nodes.front())];
}

// The spots of the first part of a case, and what half of its modulus is taken of.
class Damaged {
public:
  explicit Damaged(const Case& c) : built_(build(c)) {
    const Measured none;
    spots = damaged_spots({.data = c, .built = built_, .measured = none}, c.parts.front());
  }
  const Model& whole() const { return built_.model; }
  // Of every quad, triangle and beam, one behind the other: how much of it is left.
  std::vector<double> left_of(const DamagedSpot& spot) const {
    Model damaged = whole();
    spot.halved.apply(damaged);
    std::vector<double> left;
    const auto add_shells = [&](const auto& before, const auto& after) {
      for (std::size_t i = 0; i < before.size(); ++i)
        left.push_back(damaged.shells[std::size_t(after[i].section)].section.E /
                       whole().shells[std::size_t(before[i].section)].section.E);
    };
    add_shells(whole().mesh.quads, damaged.mesh.quads);
    add_shells(whole().mesh.triangles, damaged.mesh.triangles);
    for (std::size_t i = 0; i < whole().beams.size(); ++i)
      left.push_back(damaged.beams[i].section.EI_y / whole().beams[i].section.EI_y);
    return left;
  }
  // Those of which no spot takes anything.
  std::size_t never_damaged() const {
    std::vector<double> least = left_of(spots.front());
    for (const DamagedSpot& spot : spots) {
      const std::vector<double> left = left_of(spot);
      for (std::size_t i = 0; i < left.size(); ++i) least[i] = std::min(least[i], left[i]);
    }
    return std::size_t(std::count(least.begin(), least.end(), 1.));
  }

  std::vector<DamagedSpot> spots;

private:
  BuiltCase built_;
};

TEST(WallDamage, takes_half_of_the_modulus_about_a_spot_and_nothing_elsewhere) {
  const Damaged panel(drawn(24, 16));
  ASSERT_EQ(panel.spots.size(), 384U);
  const double reach = 0.1 * std::sqrt(length * width), element = length / 24;
  for (const DamagedSpot& spot : {panel.spots.front(), panel.spots[11], panel.spots.back()}) {
    EXPECT_EQ(spot.way, "49 mm across");
    EXPECT_EQ(spot.spot.free_numbers, 2);
    const Vector3d& middle = panel.whole().mesh.nodes[std::size_t(spot.spot.touched)];
    const std::vector<double> left = panel.left_of(spot);
    int soft = 0;
    for (std::size_t q = 0; q < left.size(); ++q) {
      const double away = (quad_centre(panel.whole(), int(q)) - middle).norm();
      EXPECT_DOUBLE_EQ(left[q], away < reach ? 0.5 : 1) << spot.spot.place << " " << away;
      if (left[q] < 1) ++soft;
    }
    const double all = std::numbers::pi * reach * reach / (element * element);
    EXPECT_LT(soft, 1.2 * all);
    EXPECT_GT(soft, 0.2 * all) << "in a corner it is a quarter";
  }
}

// A deck of a mesh, whose elements are quads or triangles.
Case deck_of(const Mesh& mesh) {
  using namespace test::abaqus;
  Case c;
  DeckPart deck{.file = "part.inp"};
  deck.content = std::make_shared<DeckModel>(read_text(
      "*HEADING\npart\n" + nodes_text(mesh) +
      (mesh.quads.empty() ? elements_text(mesh.triangles, "S3") : elements_text(mesh.quads, "S4")) +
      steel + section));
  c.parts.push_back({"part", deck});
  return c;
}

// Held or not: damage at a clamp is seen best.
TEST(WallDamage, every_element_lies_in_some_spot) {
  EXPECT_EQ(Damaged(drawn(24, 16)).never_damaged(), 0U) << "a deck on four edges";
  Mesh triangles = test::deck_plate(12, 8);
  for (const ShellQuad& q : triangles.quads)
    for (int first : {0, 2}) {
      ShellTriangle& t = triangles.triangles.emplace_back();
      for (int a = 0; a < 3; ++a) t.nodes[std::size_t(a)] = q.nodes[std::size_t((first + a) % 4)];
    }
  triangles.quads.clear();
  const Damaged of_triangles(deck_of(triangles));
  EXPECT_EQ(of_triangles.whole().mesh.triangles.size(), 192U);
  EXPECT_EQ(of_triangles.never_damaged(), 0U);
  Case strip = steel_plate({{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.05, 0}, {0, 0.05, 0}}}, {100, 10});
  strip.caps.push_back({.name = "clamp", .of = {"plate.edge4"}});
  strip.mount.push_back({.cap = "clamp"});
  const Damaged of_strip(strip);
  EXPECT_EQ(of_strip.never_damaged(), 0U) << "a long plate";
  EXPECT_EQ(std::count_if(of_strip.spots.begin(), of_strip.spots.end(),
                          [](const DamagedSpot& d) { return d.spot.between.empty(); }),
            24);
}

// Beams of a frame of 2 x 2 x 2 cells of a metre: those that meet at a node, however far they go.
TEST(WallDamage, of_beams_is_of_those_that_meet) {
  std::string nodes = "*NODE\n", beams;
  const auto number = [](int i, int j, int k) { return 1 + i + 3 * j + 9 * k; };
  int count = 0;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        nodes += fmt::format("{}, {}., {}., {}.\n", number(i, j, k), i, j, k);
        for (const auto& [di, dj, dk] :
             {std::array{1, 0, 0}, std::array{0, 1, 0}, std::array{0, 0, 1}})
          if (i + di < 3 && j + dj < 3 && k + dk < 3)
            beams += fmt::format("{}, {}, {}\n", ++count, number(i, j, k),
                                 number(i + di, j + dj, k + dk));
      }
  Case c;
  DeckPart deck{.file = "frame.inp"};
  deck.content = std::make_shared<DeckModel>(test::abaqus::read_text(
      "*HEADING\nframe\n" + nodes + "*ELEMENT, TYPE=B31, ELSET=WALL\n" + beams +
      test::abaqus::steel +
      "*BEAM SECTION, ELSET=WALL, MATERIAL=STEEL, SECTION=RECT\n0.02, 0.02\n0.3, 0.5, 0.8\n"));
  c.parts.push_back({"frame", deck});
  const Damaged frame(c);
  ASSERT_EQ(frame.whole().beams.size(), 54U);
  EXPECT_EQ(frame.spots.size(), 27U);
  EXPECT_EQ(frame.never_damaged(), 0U);
  for (const DamagedSpot& spot : frame.spots) {
    const std::vector<double> left = frame.left_of(spot);
    EXPECT_LE(std::count(left.begin(), left.end(), 0.5), 6) << spot.spot.place;
  }
}

TEST(WallDamage, of_a_wall_leaves_the_one_that_lies_opposite) {
  Mesh two = test::deck_plate(12, 8);
  const std::size_t nodes = two.nodes.size(), quads = two.quads.size();
  for (std::size_t i = 0; i < nodes; ++i)
    two.nodes.emplace_back(two.nodes[i] + Vector3d(0, 0, 0.005));
  for (std::size_t q = 0; q < quads; ++q) {
    ShellQuad opposite = two.quads[q];
    for (int& node : opposite.nodes) node += int(nodes);
    two.quads.push_back(opposite);
  }
  const Damaged walls(deck_of(two));
  const std::vector<double> left = walls.left_of(walls.spots.front());
  const auto middle = left.begin() + std::ptrdiff_t(quads);
  const auto below = std::count(left.begin(), middle, 0.5),
             above = std::count(middle, left.end(), 0.5);
  EXPECT_EQ(below + above, 4) << "elements of 25 mm about a node";
  EXPECT_EQ(std::min(below, above), 0);
}

TEST(WallDamage, of_a_deck_is_found_where_it_is) {
  constexpr double x = 0.211, y = 0.072;
  const Case c = drawn(24, 16);
  const Diagnosis d = changed_beam::diagnosis_of(c, before_and_after(x, y, 0.4));
  EXPECT_TRUE(d.verdict == Verdict::identified || d.verdict == Verdict::ambiguous) << d.headline;
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "local_damage") << d.headline;
  ASSERT_TRUE(e.within.has_value()) << d.headline;
  // Frequencies of a rectangle do not tell a spot from its mirror images.
  const Vector3d found = at(c, e.place);
  const double away =
      std::hypot(std::min(std::abs(found.x() - x), std::abs(length - found.x() - x)),
                 std::min(std::abs(found.y() - y), std::abs(width - found.y() - y)));
  EXPECT_LT(away, std::min(*e.within, 0.03)) << e.place << ": " << d.headline;
  // As much as the rectangle lost, of a disc that is half as large again.
  const double lost = 0.6 * 0.04 * 0.03 / (std::numbers::pi * 0.01 * length * width);
  EXPECT_LT(e.parameters[0].interval[0], lost) << e.parameters[0].interval[0];
  EXPECT_GT(e.parameters[0].interval[1], lost) << e.parameters[0].interval[1];
  EXPECT_NE(plain_verdict(d).find("of its stiffness"), std::string::npos) << plain_verdict(d);
}

// Cuts of 6 mm in a clamped beam of 20 mm that others measured (cases/cracked_cantilever), drawn as
// a deck: two frequencies make nothing sure, and the cut is among what is listed, where it is.
TEST(WallDamage, measured_cuts_are_listed_where_they_are_on_a_deck) {
  const std::string folder = PLICA_SOURCE_DIR "/cases/cracked_cantilever/";
  Case c = test::deck_beam(
      {.width = 0.02, .length = 0.3, .thickness = 0.02, .E = 206e9, .rho = 7800, .elements = 64});
  c.analyses.damping.modal = 0.005;
  for (const auto& [cut, place] :
       {std::pair{"cut_80_6", 0.08}, {"cut_140_6", 0.14}, {"cut_200_6", 0.2}}) {
    const Measured m = test::by_order_alone(read_measured(folder + cut + "/measured.yaml"));
    const Diagnosis d = changed_beam::diagnosis_of(c, m);
    EXPECT_EQ(d.verdict, Verdict::ambiguous) << cut << ": " << d.headline;
    const auto damage = std::find_if(d.effects.begin(), d.effects.end(),
                                     [](const NamedEffect& e) { return e.name == "local_damage"; });
    ASSERT_NE(damage, d.effects.end()) << cut << ": " << d.headline;
    ASSERT_TRUE(damage->within.has_value()) << cut;
    const Vector3d found = at(c, damage->place);
    EXPECT_LT(std::abs(found.y() - place), std::min(*damage->within, 0.04))
        << cut << ": " << d.headline;
  }
}

} // namespace
} // namespace plica
