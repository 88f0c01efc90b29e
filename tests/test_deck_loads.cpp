// Loads of decks as static analyses: beams and plates in closed form, the same deck in CalculiX.
#include "tests/curved_plate.hpp"
#include "tests/loads_beside_calculix.hpp"

#include <cmath>

namespace plica::test {
namespace deck_loads {
namespace {

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

// What moves needs no force beside it, no case control, and no node that nothing uses.
TEST(DeckLoads, moved_supports_act_without_forces_and_without_case_control) {
  const std::string moved = "SPC,3,1,123456,0.\nSPC,3,11,2,5.\n";
  const Results two =
      loads_of("bar.bdf", bar("SUBCASE 1\n SPC = 1\n LOAD = 10\nSUBCASE 2\n SPC = 3\n",
                              moved + "FORCE,10,11,0,1.,0.,0.,1.\n"));
  ASSERT_EQ(two.deck_loads.size(), 2U);
  EXPECT_NEAR(node_of(load_case(two, "it, subcase 2"), 11).displacement[1], 5e-3, 1e-15);
  std::string deck = bar("SPC = 3\n", "SPC,3,20,3,1.\n" + moved);
  const std::string begin = "BEGIN BULK\n";
  deck.replace(deck.find(begin), begin.size(), begin + "GRID,20,,50.,50.,0.\n"); // a stray
  const Results stray = loads_of("bar.bdf", deck);
  ASSERT_EQ(stray.deck_loads.size(), 1U);
  EXPECT_NEAR(node_of(stray.deck_loads[0], 11).displacement[1], 5e-3, 1e-15);
  EXPECT_NEAR(node_of(stray.deck_loads[0], 11).reaction[1], 3 * E * I1 * 5 / (L * L * L), 1e-9);
  std::string bulk = bar("", "");
  bulk = bulk.substr(bulk.find(begin) + begin.size());
  bulk = bulk.substr(0, bulk.find("SPC1,1,")) + moved + "FORCE,1,6,0,1.,0.,0.,1.\n";
  const Results open = loads_of("bar.bdf", bulk);
  ASSERT_EQ(open.deck_loads.size(), 1U);
  EXPECT_NEAR(node_of(open.deck_loads[0], 11).displacement[1], 5e-3, 1e-15);
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
  std::string bulk = "SPC = 1\nSUBCASE 1\nLOAD = 1\nSUBCASE 2\nLOAD = 2\nSUBCASE 3\nLOAD = 3\n"
                     "SUBCASE 4\nLOAD = 4\nBEGIN BULK\n" +
                     plate_nodes("GRID,{},,{:.9g},{:.9g},0.0\n") +
                     plate_elements("CQUAD4,{},1,{},{},{},{}\n") +
                     "PSHELL,1,1,2.,1,,1\nMAT1,1,2.+5,,0.3,8.-9\n";
  for (int node : border()) bulk += fmt::format("SPC1,1,123,{}\n", node);
  bulk += fmt::format("PLOAD2,1,0.01,1,THRU,{}\n", n * n);
  bulk += fmt::format("PLOAD4,2,1,0.02,,,,THRU,{}\n,0,0.,0.,-3.\n", n * n);
  bulk += fmt::format("PLOAD4,3,1,0.,0.03,0.03,0.\n"); // along one side of one element
  bulk += fmt::format("CORD2C,5,0,100.,100.,0.,100.,100.,1.\n,200.,100.,0.\n"
                      "PLOAD4,4,1,0.02,,,,THRU,{}\n,5,1.,0.,0.\n",
                      n * n); // away from the middle
  const Results all = loads_of("plate.bdf", bulk + "ENDDATA\n");
  const DeckLoadResult& up = load_case(all, "it, subcase 1");
  EXPECT_NEAR(node_of(up, middle).displacement[2] / (0.01 * middle_w), 1, 0.01);
  EXPECT_NEAR(up.load[2], 0.01 * 200 * 200, 1e-9);
  expect_balance(up, 400, 400);
  const DeckLoadResult& down = load_case(all, "it, subcase 2");
  EXPECT_NEAR(node_of(down, middle).displacement[2] / (0.02 * middle_w), -1, 0.01);
  const DeckLoadResult& outwards = load_case(all, "it, subcase 4");
  EXPECT_NEAR(outwards.load[0], 0, 1e-9 * 0.02 * 4e4) << "radial in each place";
  EXPECT_GT(node_of(outwards, middle + 6).displacement[0], 0);
  EXPECT_LT(node_of(outwards, middle - 6).displacement[0], 0);
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

// A perturbation has its own loads alone, and what is loaded in it is gone behind it.
TEST(DeckLoads, perturbations_have_their_own_loads_and_leave_none) {
  std::string deck = "*NODE\n" + plate_nodes("{}, {:.9g}, {:.9g}, 0.\n") +
                     "*ELEMENT, TYPE=S4, ELSET=ALL\n" + plate_elements("{}, {}, {}, {}, {}\n") +
                     "*MATERIAL, NAME=M\n*ELASTIC\n2e5, .3\n*SHELL SECTION, ELSET=ALL, "
                     "MATERIAL=M\n2.\n*BOUNDARY\n";
  for (int node : border()) deck += fmt::format("{}, 1, 3\n", node);
  const Results all = loads_of("plate.inp", deck +
                                                "*STEP\n*BUCKLE\n2\n*DLOAD\nALL, P, 1.\n*END STEP\n"
                                                "*STEP\n*STATIC\n*DLOAD\nALL, P, 0.01\n*END STEP\n"
                                                "*STEP, PERTURBATION\n*STATIC\n*CLOAD\n" +
                                                fmt::format("{}, 3, 1.\n", middle) +
                                                "*END STEP\n*STEP\n*STATIC\n*END STEP\n");
  ASSERT_EQ(all.deck_loads.size(), 3U);
  EXPECT_NEAR(load_case(all, "it, step 2").load[2], 0.01 * 4e4, 1e-9);
  EXPECT_NEAR(load_case(all, "it, step 3").load[2], 1, 1e-9);
  EXPECT_NEAR(load_case(all, "it, step 4").load[2], 0.01 * 4e4, 1e-9);
}

// --- beside CalculiX on the same deck: a plate of S8R held at one side, one of its nodes turned

std::string calculix_plate() {
  const CurvedPlate plate = curved_plate();
  return plate.mesh +
         fmt::format("*NSET, NSET=WATCHED\n{}, {}\n*NSET, NSET=END\n{}\n", plate.corner,
                     plate.other, plate.other) +
         "*MATERIAL, NAME=STEEL\n*ELASTIC\n200000., .3\n*DENSITY\n8e-9\n"
         "*SHELL SECTION, ELSET=PLATE, MATERIAL=STEEL\n2.\n"
         "*TRANSFORM, NSET=END\n0.6, 0., 0.8, 0., 1., 0.\n"
         "*BOUNDARY\n" +
         plate.held +
         fmt::format("*STEP\n*STATIC\n*CLOAD\n{}, 3, 2.\nEND, 1, 3.\n*NODE PRINT, NSET=WATCHED, "
                     "GLOBAL=YES\nU\n*END STEP\n"
                     "*STEP\n*STATIC\n*DLOAD\nPLATE, P, 0.001\n*CLOAD\n{}, 3, 1.\n*NODE PRINT, "
                     "NSET=WATCHED, GLOBAL=YES\nU\n*END STEP\n"
                     "*STEP\n*STATIC\n*CLOAD, OP=NEW\n*DLOAD, OP=NEW\nPLATE, GRAV, 9810., 0., 0.6, "
                     "-0.8\n*NODE PRINT, NSET=WATCHED, GLOBAL=YES\nU\n*END STEP\n"
                     "*STEP\n*STATIC\n*CLOAD, OP=NEW\n*DLOAD, OP=NEW\n*BOUNDARY\n{}, 3, 3, "
                     "4.\n*NODE PRINT, NSET=WATCHED, GLOBAL=YES\nU\n*END STEP\n",
                     plate.corner, plate.corner, plate.corner);
}

TEST(CalculixLoads, steps_of_forces_pressure_weight_and_moved_nodes_give_its_displacements) {
  expect_displacements_of_calculix(calculix_plate(), 4);
}

} // namespace
} // namespace deck_loads
} // namespace plica::test
