// Loads of decks as static analyses: beams and plates in closed form, the same deck in CalculiX,
// what is refused.
#include "io/files/files.hpp"
#include "io/input/case_file.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/input_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

namespace plica::test {
namespace deck_loads {
namespace {

// A case of one deck in mm and t; N and MPa follow.
Results loads_of(const std::string& file, const std::string& deck, const std::string& more = "",
                 const std::string& analyses = "") {
  const TemporaryFolder folder("deck_loads");
  write_whole(folder.path / file, deck);
  write_whole(folder.path / "case.yaml", "case: loads\nparts:\n  it: {type: deck, file: " + file +
                                             ", length_unit: mm, mass_unit: t" + more +
                                             "}\nanalyses: {static: deck, error_bars: false" +
                                             analyses + "}\n");
  return run_silently(read_case((folder.path / "case.yaml").string()).data);
}

const DeckLoadResult& load_case(const Results& results, const std::string& name) {
  for (const DeckLoadResult& r : results.deck_loads)
    if (r.name == name) return r;
  throw std::runtime_error("no load case " + name);
}

const DeckLoadNode& node_of(const DeckLoadResult& r, int label) {
  for (const DeckLoadNode& n : r.nodes)
    if (n.label == label) return n;
  throw std::runtime_error("no node " + std::to_string(label));
}

void expect_balance(const DeckLoadResult& r, double force, double moment) {
  for (std::size_t d = 0; d < 6; ++d)
    EXPECT_NEAR(r.load[d] + r.reaction[d], 0, 1e-9 * (d < 3 ? force : moment))
        << r.name << " " << d;
  EXPECT_LT(r.residual, 1e-9);
}

// --- a bar of ten elements along x: L = 1000, E = 2e5, I1 = 100 (bending in x-y), I2 = 300, A = 50

constexpr double L = 1000, E = 2e5, I1 = 100, I2 = 300, A = 50, rho = 8e-9;

std::string bar(const std::string& control, const std::string& loads) {
  std::string text = "SOL 101\nCEND\n" + control + "BEGIN BULK\n";
  for (int i = 0; i <= 10; ++i) text += fmt::format("GRID,{},,{}.,0.,0.\n", i + 1, 100 * i);
  for (int i = 1; i <= 10; ++i) text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
  return text +
         "PBAR,1,1,50.,100.,300.,400.\nMAT1,1,2.+5,,0.3,8.-9\nSPC1,1,123456,1\n"
         "SPC1,2,123456,1,11\nSPCADD,7,1,8\nSPC1,8,23,11\n" +
         loads + "ENDDATA\n";
}

TEST(DeckLoads, subcases_choose_loads_and_supports_of_a_bar_in_closed_form) {
  const Results all = loads_of(
      "bar.bdf", bar("SPC = 1\nSUBCASE 1\n LOAD = 10\nSUBCASE 2\n LOAD = 20\nSUBCASE 3\n SPC = 2\n "
                     "LOAD = 30\nSUBCASE 4\n SPC = 7\n LOAD = 40\nSUBCASE 5\n METHOD = 9\n",
                     "FORCE,11,11,0,5.,0.,2.,0.\nFORCE1,12,11,4.,1,11\nLOAD,10,2.,3.,11,0.5,12\n"
                     "MOMENT,20,11,0,700.,0.,0.,1.\n"
                     "GRAV,30,0,9810.,0.,0.,-1.\nSPCD,40,11,2,5.\n"));
  ASSERT_EQ(all.deck_loads.size(), 4U);
  // LOAD: 2 (3 * 10 N along y + 0.5 * 4 N along the bar)
  const DeckLoadResult& tip = load_case(all, "it, subcase 1");
  const double P = 60, S = 4;
  EXPECT_NEAR(node_of(tip, 11).displacement[1], 1e-3 * P * L * L * L / (3 * E * I1), 1e-9);
  EXPECT_NEAR(node_of(tip, 11).displacement[0], 1e-3 * S * L / (E * A), 1e-12);
  EXPECT_NEAR(node_of(tip, 11).displacement[5], P * L * L / (2 * E * I1), 1e-9);
  EXPECT_NEAR(node_of(tip, 1).reaction[1], -P, 1e-9 * P);
  EXPECT_NEAR(node_of(tip, 1).reaction[5], -1e-3 * P * L, 1e-9 * P);
  EXPECT_NEAR(tip.energy, 1e-3 * (P * P * L * L * L / (6 * E * I1) + S * S * L / (2 * E * A)),
              1e-9);
  EXPECT_NEAR(tip.largest,
              std::hypot(node_of(tip, 11).displacement[0], node_of(tip, 11).displacement[1]),
              1e-12);
  expect_balance(tip, P, 1e-3 * P * L);
  const DeckLoadResult& bent = load_case(all, "it, subcase 2");
  EXPECT_NEAR(node_of(bent, 11).displacement[1], 1e-3 * 700 * L * L / (2 * E * I1), 1e-9);
  expect_balance(bent, 1, 0.7);
  // Its own weight between two clamps: w L^4 / 384 EI in the middle.
  const DeckLoadResult& weight = load_case(all, "it, subcase 3");
  const double w = 9810 * rho * A;
  EXPECT_NEAR(node_of(weight, 6).displacement[2], -1e-3 * w * std::pow(L, 4) / (384 * E * I2),
              1e-11);
  EXPECT_NEAR(weight.load[2], -w * L, 1e-9);
  expect_balance(weight, w * L, 1e-3 * w * L * L);
  // An end that is moved: 3 EI d / L^3.
  const DeckLoadResult& moved = load_case(all, "it, subcase 4");
  EXPECT_NEAR(node_of(moved, 11).displacement[1], 5e-3, 1e-15);
  EXPECT_NEAR(node_of(moved, 11).reaction[1], 3 * E * I1 * 5 / (L * L * L), 1e-9);
  EXPECT_EQ(node_of(moved, 11).displacement[2], 0);
  EXPECT_TRUE(node_of(moved, 11).held);
  expect_balance(moved, 1, 1);
}

TEST(DeckLoads, turn_and_place_of_the_part_turn_its_loads) {
  const std::string deck = bar("SPC = 1\nLOAD = 10\n", "FORCE,10,11,0,60.,0.,1.,0.\n");
  const Results all =
      loads_of("bar.bdf", deck, ", rotate: [0 deg, 0 deg, 90 deg], move: [1 m, 0 m, 0 m]");
  const DeckLoadResult& tip = load_case(all, "it, load 10");
  EXPECT_NEAR(node_of(tip, 11).displacement[0], -1e-3 * 60 * L * L * L / (3 * E * I1), 1e-9);
  EXPECT_NEAR((node_of(tip, 11).at - Eigen::Vector3d(1, 1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(tip.load[0], -60, 1e-9);
}

// A displacement along axes that are not global moves an end aslant: 3 EI d cos / L^3 across.
TEST(DeckLoads, supports_along_axes_of_their_own_move_along_them) {
  std::string deck = bar("SPC = 3\nLOAD = 10\n", "CORD2R,5,0,0.,0.,0.,0.,0.,1.\n,0.8,0.6,0.\n"
                                                 "SPC,3,1,123456,0.\nSPC,3,11,2,5.\nFORCE,10,11,0,"
                                                 "1.-6,0.,0.,1.\n");
  const std::string plain = "GRID,11,,1000.,0.,0.";
  deck.replace(deck.find(plain), plain.size(), plain + ",5");
  const Results all = loads_of("bar.bdf", deck);
  const DeckLoadResult& r = load_case(all, "it, load 10");
  const DeckLoadNode& end = node_of(r, 11);
  EXPECT_NEAR(-0.6 * end.displacement[0] + 0.8 * end.displacement[1], 5e-3, 1e-14);
  const double across = 3 * E * I1 / (L * L * L), along = E * A / L; // N/mm
  const double k = 1 / (0.36 / along + 0.64 / across);
  EXPECT_NEAR(end.reaction[0], -0.6 * k * 5, 1e-7);
  EXPECT_NEAR(end.reaction[1], 0.8 * k * 5, 1e-7);
}

// --- a square plate on four sides, a = 200, t = 2, under pressure: 0.00406235 q a^4 / D in the
// middle (Timoshenko & Woinowsky-Krieger, table 8; nu = 0.3)

constexpr int n = 24;

std::string plate_nodes(const char* line) {
  std::string text;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      text += fmt::format(fmt::runtime(line), j * (n + 1) + i + 1, 200. * i / n, 200. * j / n);
  return text;
}

std::string plate_elements(const char* line) {
  std::string text;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int first = j * (n + 1) + i + 1;
      text += fmt::format(fmt::runtime(line), j * n + i + 1, first, first + 1, first + n + 2,
                          first + n + 1);
    }
  return text;
}

std::vector<int> border() {
  std::vector<int> all;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      if (i == 0 || j == 0 || i == n || j == n) all.push_back(j * (n + 1) + i + 1);
  return all;
}

constexpr double plate_D = 2e5 * 8 / (12 * 0.91), middle_w = 1e-3 * 0.00406235 * 1.6e9 / plate_D;
constexpr int middle = n / 2 * (n + 1) + n / 2 + 1;

TEST(DeckLoads, pressure_on_shells_bends_a_plate_as_in_the_tables) {
  std::string bulk =
      "SPC = 1\nSUBCASE 1\nLOAD = 1\nSUBCASE 2\nLOAD = 2\nSUBCASE 3\nLOAD = 3\nBEGIN "
      "BULK\n" +
      plate_nodes("GRID,{},,{:.9g},{:.9g},0.0\n") + plate_elements("CQUAD4,{},1,{},{},{},{}\n") +
      "PSHELL,1,1,2.,1,,1\nMAT1,1,2.+5,,0.3,8.-9\n";
  for (int node : border()) bulk += fmt::format("SPC1,1,123,{}\n", node);
  bulk += fmt::format("PLOAD2,1,0.01,1,THRU,{}\n", n * n);
  bulk += fmt::format("PLOAD4,2,1,0.02,,,,THRU,{}\n,0,0.,0.,-3.\n", n * n);
  bulk += fmt::format("PLOAD4,3,1,0.,0.03,0.03,0.\n"); // along one side of one element
  const Results all = loads_of("plate.bdf", bulk + "ENDDATA\n");
  const DeckLoadResult& up = load_case(all, "it, subcase 1");
  EXPECT_NEAR(node_of(up, middle).displacement[2] / (0.01 * middle_w), 1, 0.01);
  EXPECT_NEAR(up.load[2], 0.01 * 200 * 200, 1e-9);
  expect_balance(up, 400, 400);
  const DeckLoadResult& down = load_case(all, "it, subcase 2");
  EXPECT_NEAR(node_of(down, middle).displacement[2] / (0.02 * middle_w), -1, 0.01);
  const DeckLoadResult& corner = load_case(all, "it, subcase 3");
  const double side = 200. / n, mean = 0.015;
  EXPECT_NEAR(corner.load[2], mean * side * side, 1e-8); // digits of the deck
  EXPECT_NEAR(corner.load[4], -1e-3 * corner.load[2] * side * 2 / 3, 1e-10) << "a wedge's centre";
}

TEST(DeckLoads, stresses_of_the_loads_stand_among_the_stresses) {
  std::string deck = "*NODE\n" + plate_nodes("{}, {:.9g}, {:.9g}, 0.\n") +
                     "*ELEMENT, TYPE=S4, ELSET=ALL\n" + plate_elements("{}, {}, {}, {}, {}\n") +
                     "*MATERIAL, NAME=M\n*ELASTIC\n2e5, .3\n*SHELL SECTION, ELSET=ALL, "
                     "MATERIAL=M\n2.\n*BOUNDARY\n";
  for (int node : border()) deck += fmt::format("{}, 1, 3\n", node);
  deck += "*STEP\n*STATIC\n*DLOAD\nALL, P, 0.01\n*END STEP\n*STEP\n*STATIC\n*DLOAD, OP=NEW\n"
          "ALL, P, -0.01\nALL, P, -0.02\n*END STEP\n";
  const Results all = loads_of("plate.inp", deck, "", ", stress: {}");
  EXPECT_NEAR(node_of(load_case(all, "it, step 1"), middle).displacement[2] / (0.01 * middle_w), 1,
              0.01);
  EXPECT_NEAR(node_of(load_case(all, "it, step 2"), middle).displacement[2] / (0.03 * middle_w), -1,
              0.01)
      << "a step's loads add, OP=NEW clears";
  ASSERT_EQ(all.stresses.size(), 2U);
  EXPECT_EQ(all.stresses[0].name, "it, step 1");
  // Both bending moments 0.0479 q a^2 in the middle: von Mises 6 M / t^2.
  EXPECT_NEAR(all.stresses[0].above[middle - 1] / (1e6 * 6 * 0.0479 * 0.01 * 4e4 / 4), 1, 0.02);
}

// --- beside CalculiX on the same deck: a plate of S8R held at one side, one of its nodes turned

std::string calculix_plate() {
  constexpr int along = 24, across = 16;
  std::string nodes = "*NODE, NSET=ALL\n", elements = "*ELEMENT, TYPE=S8R, ELSET=PLATE\n", held;
  const auto number = [](int i, int j) { return 1000 * j + i + 1; };
  for (int j = 0; j <= 2 * across; ++j)
    for (int i = 0; i <= 2 * along; ++i) {
      if (i % 2 == 1 && j % 2 == 1) continue;
      nodes += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", number(i, j), 150. * i / along,
                           100. * j / across, 20. * i * i / (4. * along * along));
      if (i == 0) held += fmt::format("{}, 1, 6\n", number(i, j));
    }
  for (int j = 0, e = 0; j < 2 * across; j += 2)
    for (int i = 0; i < 2 * along; i += 2)
      elements +=
          fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}\n", ++e, number(i, j), number(i + 2, j),
                      number(i + 2, j + 2), number(i, j + 2), number(i + 1, j),
                      number(i + 2, j + 1), number(i + 1, j + 2), number(i, j + 1));
  const int corner = number(2 * along, 0), other = number(2 * along, 2 * across);
  return nodes + elements +
         fmt::format("*NSET, NSET=WATCHED\n{}, {}\n*NSET, NSET=END\n{}\n", corner, other, other) +
         "*MATERIAL, NAME=STEEL\n*ELASTIC\n200000., .3\n*DENSITY\n8e-9\n"
         "*SHELL SECTION, ELSET=PLATE, MATERIAL=STEEL\n2.\n"
         "*TRANSFORM, NSET=END\n0.6, 0., 0.8, 0., 1., 0.\n"
         "*BOUNDARY\n" +
         held +
         fmt::format("*STEP\n*STATIC\n*CLOAD\n{}, 3, 2.\nEND, 1, 3.\n*NODE PRINT, NSET=WATCHED, "
                     "GLOBAL=YES\nU\n*END STEP\n"
                     "*STEP\n*STATIC\n*DLOAD\nPLATE, P, 0.001\n*CLOAD\n{}, 3, 1.\n*NODE PRINT, "
                     "NSET=WATCHED, GLOBAL=YES\nU\n*END STEP\n"
                     "*STEP\n*STATIC\n*CLOAD, OP=NEW\n*DLOAD, OP=NEW\nPLATE, GRAV, 9810., 0., 0.6, "
                     "-0.8\n*NODE PRINT, NSET=WATCHED, GLOBAL=YES\nU\n*END STEP\n"
                     "*STEP\n*STATIC\n*CLOAD, OP=NEW\n*DLOAD, OP=NEW\n*BOUNDARY\n{}, 3, 3, "
                     "4.\n*NODE PRINT, NSET=WATCHED, GLOBAL=YES\nU\n*END STEP\n",
                     corner, corner, corner);
}

// Displacements of the two nodes that are watched, step by step; empty where CalculiX is not there.
std::vector<std::map<int, Eigen::Vector3d>> calculix_steps(const std::string& deck) {
  const TemporaryFolder folder("calculix_loads");
  write_whole(folder.path / "model.inp", deck);
  const std::string command =
      "cd '" + folder.path.string() + "' && OMP_NUM_THREADS=1 ccx -i model >log 2>&1";
  if (std::system(command.c_str()) != 0) return {};
  std::istringstream stream(read_whole(folder.path / "model.dat"));
  std::vector<std::map<int, Eigen::Vector3d>> steps;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("displacements") != std::string::npos) steps.emplace_back();
    std::istringstream fields(line);
    int node = 0;
    Eigen::Vector3d u;
    if (!steps.empty() && fields >> node >> u[0] >> u[1] >> u[2]) steps.back()[node] = u;
  }
  return steps;
}

TEST(CalculixLoads, steps_of_forces_pressure_weight_and_moved_nodes_give_its_displacements) {
  const std::string deck = calculix_plate();
  const auto theirs = calculix_steps(deck);
  ASSERT_EQ(theirs.size(), 4U) << "CalculiX (ccx) is not there, or broke off";
  const Results ours = loads_of("model.inp", deck);
  ASSERT_EQ(ours.deck_loads.size(), 4U);
  for (std::size_t step = 0; step < 4; ++step)
    for (const auto& [node, u] : theirs[step]) {
      const Eigen::Vector3d own = 1e3 * node_of(ours.deck_loads[step], node).displacement.head<3>();
      fmt::print("step {} node {}: {:.5f} {:.5f} {:.5f} mm, CalculiX {:.5f} {:.5f} {:.5f}\n",
                 step + 1, node, own[0], own[1], own[2], u[0], u[1], u[2]);
      EXPECT_LT((own - u).norm(), 0.01 * u.norm()) << "step " << step + 1 << " node " << node;
    }
}

// --- what is refused, all at once

std::vector<InputProblem> problems_of(const std::string& file, const std::string& deck) {
  try {
    loads_of(file, deck);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

TEST(DeckLoads, what_acts_and_is_not_had_is_refused_with_its_lines_all_at_once) {
  const std::string deck =
      bar("SPC = 1\nLOAD = 10\n", "FORCE,10,99,0,60.,0.,1.,0.\nPLOAD1,10,1,FY,FR,0.,1.,1.,1.\n"
                                  "PLOAD4,10,5,1.\nSPCD,10,11,2,1.\n");
  const auto problems = problems_of("bar.bdf", deck);
  ASSERT_EQ(problems.size(), 4U);
  for (const InputProblem& p : problems) EXPECT_EQ(p.key, "analyses.static");
  std::string all;
  for (const InputProblem& p : problems) all += p.wrong + "\n";
  for (const char* part : {"bar.bdf:33: FORCE: there is no grid point 99", "bar.bdf:34: PLOAD1",
                           "element 5, which is no shell", "11 2, which no SPC holds"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

TEST(DeckLoads, a_set_that_is_not_there_and_a_deck_without_loads_are_refused) {
  const auto none = problems_of("bar.bdf", bar("SPC = 1\nLOAD = 10\n", ""));
  ASSERT_EQ(none.size(), 1U);
  EXPECT_NE(none[0].wrong.find("no load of set 10"), std::string::npos) << none[0].wrong;
  const auto open = problems_of("bar.bdf", bar("SPC = 1\n", ""));
  ASSERT_EQ(open.size(), 1U);
  EXPECT_NE(open[0].wrong.find("no subcase with LOAD"), std::string::npos) << open[0].wrong;
  const auto warm = problems_of("bar.bdf", bar("SPC = 1\nLOAD = 10\nTEMP(LOAD) = 3\nDEFORM = 4\n",
                                               "FORCE,10,11,0,60.,0.,1.,0.\n"));
  ASSERT_EQ(warm.size(), 2U);
  EXPECT_NE(warm[0].wrong.find("TEMPERATURE(LOAD) is not had"), std::string::npos);
  EXPECT_NE(warm[1].wrong.find("DEFORM is not had"), std::string::npos);
  const TemporaryFolder folder("deck_loads");
  write_whole(
      folder.path / "case.yaml",
      "case: none\nmaterials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}}\nparts:\n  a: {type: "
      "plate, material: steel, corners: [[0, 0, 0], [300 mm, 0, 0], [300 mm, 200 mm, 0], "
      "[0, 200 mm, 0]], thickness: 2 mm, elements: [6, 4]}\nanalyses: {static: deck}\n");
  try {
    read_case((folder.path / "case.yaml").string());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no part is one"), std::string::npos) << error.what();
  }
}

TEST(DeckLoads, a_deck_that_nothing_asks_the_loads_of_runs_whatever_they_are) {
  const TemporaryFolder folder("deck_loads");
  write_whole(folder.path / "bar.bdf",
              bar("SPC = 1\nLOAD = 10\n", "FORCE,10,99,0,60.,0.,1.,0.\nPLOAD1,10,1,FY,FR,0.,1.\n"));
  write_whole(folder.path / "case.yaml",
              "case: modes\nparts:\n  it: {type: deck, file: bar.bdf, length_unit: mm, mass_unit: "
              "t}\nanalyses: {error_bars: false, modes: {count: 2}}\n");
  const Results all = run_silently(read_case((folder.path / "case.yaml").string()).data);
  EXPECT_EQ(all.modes.size(), 2U);
  bool said = false;
  for (const std::string& w : all.warnings)
    said = said || w.find("loads, which act where the case says static: deck: FORCE, PLOAD1") !=
                       std::string::npos;
  EXPECT_TRUE(said);
}

} // namespace
} // namespace deck_loads
} // namespace plica::test
