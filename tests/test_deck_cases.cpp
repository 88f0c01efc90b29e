// Decks as parts of a case: units, turn, sets, supports, and our own decks read back.
#include "io/decks/write_abaqus.hpp"
#include "io/decks/write_nastran.hpp"
#include "io/files/files.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

constexpr double agreement = 1e-9;

// A clamped plate with a body on a cap, and a bar on springs, all from parts of the case.
std::string own_parts(const std::string& section) {
  return R"(case: own
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}}
parts:
  web: {type: plate, material: steel, corners: [[0, 0, 0], [300 mm, 0, 0], [300 mm, 200 mm, 0], [0, 200 mm, 0]],
        thickness: 2 mm, elements: [6, 4], membrane: incompatible}
  rod: {type: beam, points: [[300 mm, 0, 0], [320 mm, -30 mm, 150 mm]], elements: 3, up: [1, 0, 0],
        section: {)" +
         section + R"(}}
  ball: {type: mass, at: web.corner3, mass: 0.2 kg, inertia: [1e-4, 2e-4, 1e-4, 0, 0, 0]}
caps:
  end: {of: web.edge2, mass: 0.5 kg, inertia: [1e-3, 2e-3, 3e-3, 0, 0, 0]}
  foot: {of: rod.start}
mount: {foot: {stiffness: [1e5, 1e5, 1e5, 100, 100, 100]}}
supports: [{set: web.edge4, fix: [ux, uy, uz, rx, ry, rz]}]
)";
}

const char* const asked = R"(
analyses: {static: false, error_bars: false, modes: {count: 10}}
)";

Results run_text(const std::string& text, const std::filesystem::path& folder) {
  write_whole(folder / "case.yaml", text);
  return run_silently(read_case((folder / "case.yaml").string()).data);
}

void expect_same(const Results& a, const Results& b, double tolerance = agreement) {
  ASSERT_EQ(a.modes.size(), b.modes.size());
  for (std::size_t m = 0; m < a.modes.size(); ++m)
    EXPECT_NEAR(a.modes[m].frequency / b.modes[m].frequency, 1, tolerance) << "mode " << m + 1;
}

// What we write for other codes is read back as what it was. A deck of Abaqus has a spring of 1e-6
// under every mass; one of Nastran leaves out the rotary inertia of beams, and this has none.
TEST(DeckCase, our_own_decks_come_back) {
  const TemporaryFolder folder("deck_case");
  const auto expect_back = [&](const std::string& file, const std::string& section, auto* write,
                               double tolerance) {
    const Results ours = run_text(own_parts(section) + asked, folder.path);
    const Case data = read_case((folder.path / "case.yaml").string()).data;
    write_whole(folder.path / file, write(data, build(data)));
    expect_same(run_text("case: read\nparts:\n  all: {type: deck, file: " + file +
                             ", length_unit: 1 m, mass_unit: 1 kg}\n" + asked,
                         folder.path),
                ours, tolerance);
  };
  expect_back("model.inp", "shape: rectangle, material: steel, width: 5 mm, depth: 9 mm",
              &abaqus_model, 1e-7);
  expect_back("model.bdf", "shape: general, EA: 9e6, EI: 30, GJ: 25, mass_per_length: 0.3",
              &nastran_model, agreement);
}

// A bellows comes back with the mean normals of its facets: as near as the mesh is fine.
TEST(DeckCase, a_bellows_comes_back_within_a_percent) {
  const TemporaryFolder folder("deck_case");
  Case data = verification_case("bellows_a", {.around = 24, .arc = 6, .wall = 6}, 4);
  data.analyses.statics = data.analyses.error_bars = false;
  data.analyses.stress.reset();
  data.analyses.response.reset();
  data.analyses.symmetry = Symmetry::off;
  const Results ours = run_silently(data);
  write_whole(folder.path / "model.inp", abaqus_model(data, build(data)));
  const Results read =
      run_text("case: read\nparts:\n  all: {type: deck, file: model.inp, length_unit: "
               "1 m, mass_unit: 1 kg}\nanalyses: {static: false, error_bars: "
               "false, modes: {count: 4}}\n",
               folder.path);
  ASSERT_EQ(read.modes.size(), ours.modes.size());
  for (std::size_t m = 0; m < ours.modes.size(); ++m)
    compare("bellows A from its own deck", "mode " + std::to_string(m + 1), read.modes[m].frequency,
            ours.modes[m].frequency, 0.01);
}

// In mm, t and MPa, turned by 90 and by 30 degrees, moved, joined to a part of the case by a place
// and by a set of the deck: the same structure.
std::string plate_deck() {
  std::string text = "*NODE\n";
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 6; ++i)
      text += fmt::format("{}, {}., {}., 0.\n", 100 * j + i + 1, 50 * i, 50 * j);
  text += "*ELEMENT, TYPE=S4, ELSET=WEB\n";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 6; ++i)
      text += fmt::format("{}, {}, {}, {}, {}\n", 10 * j + i + 1, 100 * j + i + 1, 100 * j + i + 2,
                          100 * j + i + 102, 100 * j + i + 101);
  text += "*NSET, NSET=ROOT, GENERATE\n1, 401, 100\n*NSET, NSET=TIP, GENERATE\n7, 407, 100\n"
          "*MATERIAL, NAME=STEEL\n*ELASTIC\n200000., 0.3\n*DENSITY\n8.e-9\n"
          "*SHELL SECTION, ELSET=WEB, MATERIAL=STEEL\n2.\n"
          "*ELEMENT, TYPE=MASS, ELSET=M\n900, 407\n*MASS, ELSET=M\n2.e-4\n"
          "*ELEMENT, TYPE=SPRING1, ELSET=K\n901, 4\n*SPRING, ELSET=K\n3\n30.\n"
          "*BOUNDARY\nROOT, ENCASTRE\n";
  return text;
}

TEST(DeckCase, units_turn_and_move) {
  const TemporaryFolder folder("deck_case");
  write_whole(folder.path / "plate.inp", plate_deck());
  const std::string base =
      "case: plate\nparts:\n  web: {type: deck, file: plate.inp, length_unit: 1 "
      "mm, mass_unit: 1 t";
  const Results plain = run_text(base + "}\n" + asked, folder.path);
  const Results own = run_text(
      R"(case: own
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}}
parts:
  web: {type: plate, material: steel, corners: [[0, 0, 0], [300 mm, 0, 0], [300 mm, 200 mm, 0], [0, 200 mm, 0]],
        thickness: 2 mm, elements: [6, 4], membrane: incompatible}
  ball: {type: mass, at: web.corner3, mass: 0.2 kg}
supports: [{set: web.edge4, fix: [ux, uy, uz, rx, ry, rz]}]
)" + std::string(asked),
      folder.path);
  ASSERT_EQ(own.modes.size(), plain.modes.size());
  constexpr double mass = 0.3 * 0.2 * 2e-3 * 8000 + 0.2; // what is held included
  EXPECT_NEAR(headline(plain).at("mass"), mass, 1e-9);
  EXPECT_NEAR(headline(own).at("mass"), mass, 1e-9);
  EXPECT_GT(plain.modes[0].frequency, own.modes[0].frequency); // it has a spring besides
  for (const char* rotate : {"90 deg, 0 deg, 90 deg", "0 deg, 30 deg, 20 deg"})
    expect_same(run_text(base + ", rotate: [" + rotate + "], move: [1 m, 2 m, -3 m]}\n" + asked,
                         folder.path),
                plain);
  // Free of its supports, held by the case: through a set of the deck, and through places.
  const std::string fix = ", fix: [ux, uy, uz, rx, ry, rz]}";
  std::string places, supports;
  for (int j = 0; j <= 4; ++j) {
    places +=
        fmt::format("{}p{}: {{at: [0, {} mm, 0], within: 1 mm}}", j > 0 ? ", " : "", j, 50 * j);
    supports += fmt::format("{}{{set: web.p{}{}", j > 0 ? ", " : "", j, fix);
  }
  const std::string loose = base + ", held: false, places: {" + places + "}}\nsupports: [";
  expect_same(run_text(loose + "{set: web.ROOT" + fix + "]\n" + asked, folder.path), plain);
  expect_same(run_text(loose + supports + "]\n" + asked, folder.path), plain);
}

// What the deck holds and a cap ties is told of at the cap, with how to let it go.
TEST(DeckCase, a_cap_on_what_the_deck_holds_is_told_of_held) {
  const TemporaryFolder folder("deck_case");
  write_whole(folder.path / "plate.inp", plate_deck());
  try {
    run_text(
        std::string("case: plate\nparts:\n  web: {type: deck, file: plate.inp, length_unit: mm, "
                    "mass_unit: t}\ncaps: {root: {of: web.ROOT, mass: 1 kg}}\n") +
            asked,
        folder.path);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().front().key, "caps.root.of") << error.what();
    EXPECT_EQ(error.problems().front().allowed.rfind("held: false at the part of the deck", 0), 0U)
        << error.what();
  }
}

// The reference of a coupling that averages follows its nodes: a cap on it leads the rest.
TEST(DeckCase, a_cap_takes_the_reference_of_an_average) {
  const TemporaryFolder folder("deck_case");
  const std::string average =
      "*NODE, NSET=REF\n99, 250., 100., 50.\n*NSET, NSET=FACE\n5, 7, 405, 407\n"
      "*SURFACE, TYPE=NODE, NAME=S\nFACE\n"
      "*COUPLING, CONSTRAINT NAME=C, REF NODE=99, SURFACE=S\n*DISTRIBUTING\n";
  const std::string base = "case: plate\nparts:\n  web: {type: deck, file: plate.inp, "
                           "length_unit: mm, mass_unit: t}\n";
  write_whole(folder.path / "plate.inp",
              plate_deck() + average +
                  "*ELEMENT, TYPE=MASS, ELSET=B\n990, 99\n*MASS, ELSET=B\n0.3e-3\n");
  const Results by_deck = run_text(base + asked, folder.path);
  write_whole(folder.path / "plate.inp", plate_deck() + average);
  const std::string alone = base + "caps: {tip: {of: web.REF, mass: 0.3 kg}}\n";
  expect_same(run_text(alone + asked, folder.path), by_deck);
  try {
    run_text(alone + "mount: {tip: rigid}\n" + asked, folder.path);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("follows others"), std::string::npos) << error.what();
  }
}

// Bars of Nastran have no rotary inertia; bodies at their ends keep the torsion of a shaft.
TEST(DeckCase, rotary_inertia_of_beams_comes_back_from_nastran) {
  const TemporaryFolder folder("deck_case");
  const Results ours = run_text(R"(case: shaft
parts:
  shaft: {type: beam, points: [[0, 0, 0], [0, 1, 0]], elements: 40, section: {shape: general, EA: 1e9, EI: 1e6,
          GJ: 500, mass_per_length: 2, polar_inertia_per_length: 2e-2, rotary_inertia_per_length: 1e-2}}
supports: [{set: shaft.start, fix: [ux, uy, uz, rx, ry, rz]}]
)" + std::string(asked),
                                folder.path);
  const Case data = read_case((folder.path / "case.yaml").string()).data;
  write_whole(folder.path / "model.bdf", nastran_model(data, build(data)));
  const Results back = run_text(
      std::string("case: read\nparts:\n  all: {type: deck, file: model.bdf, length_unit: 1 m, "
                  "mass_unit: 1 kg}\n") +
          asked,
      folder.path);
  const double torsion = std::sqrt(500 / 2e-2) / 4; // quarter wave
  EXPECT_NEAR(ours.modes[0].frequency, torsion, 1e-3 * torsion);
  // A consistent mass gives 1 + (k h)^2 / 24 of the frequency, a lumped one 1 - (k h)^2 / 24.
  for (int m = 0; m < 5; ++m) {
    const double kh = (2 * m + 1) * std::numbers::pi / 2 / 40;
    EXPECT_NEAR((1 - back.modes[std::size_t(m)].frequency / ours.modes[std::size_t(m)].frequency) /
                    (kh * kh / 12),
                1, 0.05)
        << "mode " << m + 1;
  }
}

TEST(DeckCase, says_in_the_case_what_is_wrong_there) {
  const TemporaryFolder folder("deck_case");
  write_whole(folder.path / "plate.inp", plate_deck() + "*BOUNDARY\nTIP, 3\n*CONTACT PAIR\nA, B\n");
  const auto refusal = [&](const std::string& keys) {
    try {
      run_text("case: plate\nparts:\n  web: {type: deck, " + keys + "}\n" + asked, folder.path);
    } catch (const InputError& error) {
      std::string all;
      for (const InputProblem& p : error.problems()) all += to_string(p) + "\n";
      return all;
    }
    return std::string();
  };
  const std::string units = "length_unit: 1 mm, mass_unit: 1 t";
  const auto expect = [&](const std::string& keys, const std::string& message) {
    EXPECT_NE(refusal(keys).find(message), std::string::npos) << keys << "\n" << refusal(keys);
  };
  expect("file: plate.inp", "parts.web.length_unit");
  expect("file: plate.step, " + units, "is no deck that can be read");
  expect("file: none.inp, " + units, "there is no file");
  expect("file: plate.inp, " + units, "*CONTACT PAIR: is not had");
  write_whole(folder.path / "many.inp", plate_deck() + "*GASKET SECTION\n*CONTACT PAIR\nA, B\n"
                                                       "*CONTACT PAIR\nA, B\n");
  const std::string many = refusal("file: many.inp, " + units); // most frequent first
  EXPECT_LT(many.find("*CONTACT PAIR: is not had, 2 times"), many.find("*GASKET SECTION"));
  const std::string listed = units + ", unknown_cards: list";
  const Results run = run_text("case: plate\nparts:\n  web: {type: deck, file: plate.inp, " +
                                   listed + "}\n" + asked,
                               folder.path);
  const Results turned = run_text("case: plate\nparts:\n  web: {type: deck, file: plate.inp, " +
                                      listed + ", rotate: [10 deg, 20 deg, 30 deg]}\n" + asked,
                                  folder.path);
  expect_same(turned, run); // single DOFs that are held turn along
  ASSERT_FALSE(run.warnings.empty());
  EXPECT_NE(run.warnings[0].find("*CONTACT PAIR is not had"), std::string::npos);
}

} // namespace
} // namespace plica::test
