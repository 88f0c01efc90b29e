// Forces along beams and temperatures of decks: closed forms, the same deck in CalculiX.
#include "tests/curved_plate.hpp"
#include "tests/loads_beside_calculix.hpp"
#include "tests/support/refusal.hpp"

#include <cmath>

namespace plica::test {
namespace deck_loads {
namespace {

// The bar of ten elements with other words in its cards.
std::string bar_with(const std::string& control, const std::string& loads,
                     const std::vector<std::pair<std::string, std::string>>& words) {
  std::string text = bar(control, loads);
  for (const auto& [old, now] : words) {
    const std::size_t at = text.find(old);
    if (at == std::string::npos) throw std::runtime_error("no " + old);
    text.replace(at, old.size(), now);
  }
  return text;
}

// One CBAR of length L clamped at both ends, its y along z.
std::string clamped(const std::string& loads, const std::string& more = "") {
  return "SOL 101\nCEND\nSPC = 1\nLOAD = 10\nBEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1000.,0.,0.\n"
         "GRID,3,,1000.,900.,0.\nGRID,4,,1000.,900.,50.\nCBAR,1,1,1,2,0.,0.,1.\n"
         "CBAR,3,1,3,4,1.,0.,0.\nCBAR,2,1,2,3,0.,0.,1." +
         more + "\nPBAR,1,1,50.,100.,300.,400.\nMAT1,1,2.+5,,0.3,8.-9\nSPC1,1,123456,1,2,3\n" +
         loads + "ENDDATA\n";
}

constexpr double w = 0.7; // N/mm

TEST(BeamLoads, uniform_ones_bend_a_cantilever_as_in_the_tables) {
  std::string cards;
  for (int i = 1; i <= 10; ++i) cards += fmt::format("PLOAD1,10,{},FY,FR,0.,{},1.,{}\n", i, w, w);
  const Results slender = loads_of("bar.bdf", bar("SPC = 1\nLOAD = 10\n", cards));
  const DeckLoadResult& r = load_case(slender, "it, load 10");
  EXPECT_NEAR(node_of(r, 11).displacement[1], 1e-3 * w * std::pow(L, 4) / (8 * E * I1), 1e-9);
  EXPECT_NEAR(node_of(r, 6).displacement[1], 1e-3 * 17 * w * std::pow(L, 4) / (384 * E * I1), 1e-9);
  EXPECT_NEAR(node_of(r, 11).displacement[5], w * L * L * L / (6 * E * I1), 1e-9);
  EXPECT_NEAR(node_of(r, 1).reaction[1], -w * L, 1e-9 * w * L);
  EXPECT_NEAR(node_of(r, 1).reaction[5], -1e-3 * w * L * L / 2, 1e-9 * w * L * L);
  expect_balance(r, w * L, 1e-3 * w * L * L);
  // With shear: w L^2 / (2 K1 G A) beside it.
  constexpr double K1 = 0.4, G = E / 2.6;
  const Results shear = loads_of(
      "bar.bdf",
      bar_with("SPC = 1\nLOAD = 10\n", cards,
               {{"PBAR,1,1,50.,100.,300.,400.", "PBAR,1,1,50.,100.,300.,400.\n,\n,0.4,0.4"}}));
  EXPECT_NEAR(node_of(load_case(shear, "it, load 10"), 11).displacement[1] -
                  node_of(r, 11).displacement[1],
              1e-3 * w * L * L / (2 * K1 * G * A), 1e-10);
}

// Moments of clamped ends (Roark's Formulas for Stress and Strain, table of straight beams).
TEST(BeamLoads, of_parts_of_a_beam_give_the_moments_of_clamped_ends) {
  const auto moments = [](const std::string& card) {
    const Results all = loads_of("beam.bdf", clamped(card));
    const DeckLoadResult& r = all.deck_loads.at(0);
    expect_balance(r, w * L, 1e-3 * w * L * L);
    return std::pair{1e3 * node_of(r, 1).reaction[5], -1e3 * node_of(r, 2).reaction[5]};
  };
  const auto near = [&](const std::string& card, double left, double right) {
    const auto [own_left, own_right] = moments(card);
    EXPECT_NEAR(own_left / left, 1, 1e-9) << card;
    EXPECT_NEAR(own_right / right, 1, 1e-9) << card;
  };
  const double c = 400, a = 300, b = L - a, P = 20;
  near("PLOAD1,10,1,FY,LE,0.,0.7,1000.,0.7\n", -w * L * L / 12, -w * L * L / 12);
  near("PLOAD1,10,1,FY,LE,0.,0.7,400.,0.7\n",
       -w * c * c / (12 * L * L) * (6 * L * L - 8 * L * c + 3 * c * c),
       -w * c * c * c / (12 * L * L) * (4 * L - 3 * c));
  near("PLOAD1,10,1,FY,FR,0.,0.,1.,0.7\n", -w * L * L / 30, -w * L * L / 20);
  near("PLOAD1,10,1,FY,FR,0.3,20.\n", -P * a * b * b / (L * L), -P * a * a * b / (L * L));
  // Along the axes of the element: its z is -y here.
  near("PLOAD1,10,1,FZE,FR,0.,0.7,1.,0.7\n", w * L * L / 12, w * L * L / 12);
}

// Of the second beam, along y and at an offset of its axis.
TEST(BeamLoads, act_on_the_axis_of_a_beam_beside_its_nodes) {
  const Results all = loads_of("beam.bdf", clamped("PLOAD1,10,2,FX,LE,0.,0.7,900.,0.7\n"
                                                   "PLOAD1,10,2,FYE,FR,0.5,20.\n",
                                                   ",\n,,,0.,0.,30.,0.,0.,30."));
  const DeckLoadResult& r = all.deck_loads.at(0);
  EXPECT_NEAR(r.load[0], w * 900, 1e-9);
  EXPECT_NEAR(r.load[2], 20, 1e-9);
  EXPECT_NEAR(r.load[3], 20 * 0.45, 1e-9);                 // P at y = 450
  EXPECT_NEAR(r.load[4], 0.03 * w * 900 - 20 * 1.0, 1e-9); // z = 30, x = 1000
  EXPECT_NEAR(r.load[5], -0.45 * w * 900, 1e-9);
  expect_balance(r, w * L, 1e-3 * w * L * L);
}

TEST(BeamLoads, that_are_not_had_are_refused_with_their_line) {
  const auto refused = [](const std::string& deck, const std::string& why) {
    std::string all;
    try {
      loads_of("beam.bdf", deck);
    } catch (const InputError& error) {
      all = error.what();
    }
    EXPECT_NE(all.find(why), std::string::npos) << why << " in\n" << all;
  };
  refused(clamped("PLOAD1,10,1,MZ,FR,0.,1.,1.,1.\n"), "beam.bdf:16: PLOAD1: acts as MZ");
  refused(clamped("PLOAD1,10,1,FY,FRPR,0.,1.,1.,1.\n"), "over FRPR");
  refused(clamped("PLOAD1,10,1,FY,LE,0.,1.,1001.,1.\n"), "goes from 0. to 1001.");
  refused(clamped("PLOAD1,10,9,FY,FR,0.,1.,1.,1.\n"), "element 9, which is no beam");
  refused(clamped("PLOAD1,10,2,FY,FR,0.,1.,1.,1.\n", ",\n,5"), "released ends");
}

// --- temperatures

constexpr double alpha = 1.2e-5, dT = 60;

std::string hot_bar(const std::string& control, const std::string& cards) {
  return bar_with(control, cards, {{"0.3,8.-9", "0.3,8.-9,1.2-5,20."}});
}

TEST(DeckTemperatures, press_a_bar_between_clamps_by_E_A_alpha_dT) {
  const double N = E * A * alpha * dT;
  const auto ends = [&](const std::string& control, const std::string& cards) {
    const Results all = loads_of("bar.bdf", hot_bar("SPC = 2\n" + control, cards));
    EXPECT_EQ(all.deck_loads.size(), 1U);
    expect_balance(all.deck_loads.at(0), N, N * L);
    return all.deck_loads.at(0);
  };
  const DeckLoadResult all = ends("TEMPERATURE(LOAD) = 3\n", "TEMPD,3,80.\n");
  EXPECT_EQ(all.name, "it, temperature 3");
  EXPECT_NEAR(node_of(all, 1).reaction[0] / N, 1, 1e-9);
  EXPECT_NEAR(node_of(all, 11).reaction[0] / N, -1, 1e-9);
  EXPECT_NEAR(all.energy / (1e-3 * N * N * L / (2 * E * A)), 1, 1e-9);
  EXPECT_LT(all.largest, 1e-12);
  // From another temperature than TREF, point by point: half of them twice as hot.
  std::string points = "TEMPD,4,-30.\n";
  for (int i = 1; i <= 11; ++i)
    points += fmt::format("TEMP,3,{},{}\n", i, i < 6 ? 90. : i == 6 ? 30. : -30.);
  const DeckLoadResult half = ends("TEMP(LOAD) = 3\nTEMP(INIT) = 4\n", points);
  EXPECT_NEAR(node_of(half, 1).reaction[0] / N, 1, 1e-9); // 120 degrees over half of the length
  // By elements.
  const DeckLoadResult one = ends("TEMP(LOAD) = 3\n", "TEMPD,3,20.\nTEMPRB,3,1,770.,470.\n,\n,2\n");
  EXPECT_NEAR(node_of(one, 1).reaction[0] / N, 2, 1e-9); // 600 degrees in two of ten
}

// What may grow bears nothing.
TEST(DeckTemperatures, make_a_bar_longer_that_is_held_at_one_end) {
  const Results all = loads_of("bar.bdf", hot_bar("SPC = 1\nLOAD = 10\nTEMP(LOAD) = 3\n",
                                                  "TEMPD,3,80.\nFORCE,10,11,0,60.,0.,1.,0.\n"));
  const DeckLoadResult& r = load_case(all, "it, load 10");
  EXPECT_NEAR(node_of(r, 11).displacement[0], 1e-3 * alpha * dT * L, 1e-12);
  EXPECT_NEAR(node_of(r, 11).displacement[1], 1e-3 * 60 * L * L * L / (3 * E * I1), 1e-9);
  EXPECT_NEAR(node_of(r, 1).reaction[0], 0, 1e-6);
  EXPECT_NEAR(r.energy / (1e-3 * 60 * 60 * L * L * L / (6 * E * I1)), 1, 1e-9);
}

std::string hot_plate(const std::string& held, const std::string& wall) {
  std::string text = "SOL 101\nCEND\nSPC = 1\nTEMPERATURE = 3\nBEGIN BULK\n";
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i)
      text += fmt::format("GRID,{},,{}.,{}.,0.\n", 5 * j + i + 1, 25 * i + (j == 2 ? 3 * i : 0),
                          20 * j);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int n = 5 * j + i + 1;
      text += i == 1
                  ? fmt::format("CTRIA3,{0},1,{1},{2},{3}\nCTRIA3,1{0},1,{1},{3},{4}\n",
                                4 * j + i + 1, n, n + 1, n + 6, n + 5)
                  : fmt::format("CQUAD4,{},1,{},{},{},{}\n", 4 * j + i + 1, n, n + 1, n + 6, n + 5);
    }
  return text + wall + "MAT1,1,2.+5,,0.3,8.-9,1.2-5\nTEMPD,3,60.\n" + held + "ENDDATA\n";
}

// E t alpha dT / (1 - nu) per length of a side.
TEST(DeckTemperatures, press_a_plate_in_its_plane) {
  const std::string wall = "PSHELL,1,1,2.,1,,1\n";
  const Results all =
      loads_of("plate.bdf", hot_plate("SPC1,1,126,1,THRU,25\nSPC1,1,345,1\n", wall));
  double left = 0;
  for (int node : {1, 6, 11, 16, 21}) left += node_of(all.deck_loads.at(0), node).reaction[0];
  EXPECT_NEAR(left / (E * 2 * alpha * dT / 0.7 * 80), 1, 1e-9);
  const Results loose =
      loads_of("plate.bdf", hot_plate("SPC1,1,123456,1\n", wall)); // one corner alone
  const DeckLoadResult& r = loose.deck_loads.at(0);
  EXPECT_NEAR(node_of(r, 25).displacement[0], 0.1 * alpha * dT, 1e-12);
  EXPECT_NEAR(node_of(r, 25).displacement[1], 0.08 * alpha * dT, 1e-12);
  EXPECT_LT(r.energy, 1e-12);
}

TEST(DeckTemperatures, that_are_not_had_are_refused_where_they_are_asked_for) {
  const auto said = [](const std::string& file, const std::string& deck,
                       const std::string& analyses = "") {
    return error_of([&] { loads_of(file, deck, "", analyses); });
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  };
  const std::string held = "SPC1,1,123456,1\n", plies = "PCOMP,1\n,1,1.,0.,,1,1.,90.\n";
  EXPECT_EQ(said("plate.bdf", hot_plate(held, plies)), "no error"); // all of one material
  has(said("plate.bdf", hot_plate(held, "PCOMP,1\n,1,1.,0.,,2,1.,90.\nMAT8,2,2.+5,1.+5,.3,8.+4,,,"
                                        "8.-9\n,1.-5,2.-5\n")),
      "expands by plies");
  has(said("plate.bdf", hot_plate(held + "TEMPP1,3,1,80.,5.\n", plies)), "varies through the wall");
  has(said("bar.bdf", hot_bar("SPC = 2\nTEMP(LOAD) = 3\n", "TEMP,3,1,50.\n")),
      "CBAR 1 in line 17 has no temperature in set 3");
  has(said("bar.bdf", hot_bar("SPC = 2\nTEMP(LOAD) = 3\n", "TEMPD,4,50.\n")),
      "there is no temperature of set 3");
  has(said("plate.bdf", hot_plate(held, plies), ", stress: {}"), "stress of what expands");
}

// --- Abaqus

std::string beams(const std::string& steps) {
  std::string text = "*NODE\n";
  for (int i = 0; i <= 10; ++i) text += fmt::format("{}, 0, {}, 0\n", i + 1, 100 * i);
  text += "*ELEMENT, TYPE=B33, ELSET=BAR\n";
  for (int i = 1; i <= 10; ++i) text += fmt::format("{}, {}, {}\n", i, i, i + 1);
  return text +
         "*MATERIAL, NAME=M\n*ELASTIC\n2e5, .3\n*EXPANSION, ZERO=-40.\n1.2e-5\n*BEAM SECTION, "
         "SECTION=RECT, ELSET=BAR, MATERIAL=M\n6., 10.\n0., 0., 1.\n*NSET, NSET=ALL\n1, 2, 3, 4, "
         "5, 6, 7, 8, 9, 10, 11\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 20.\n*BOUNDARY\n"
         "1, 1, 6\n" +
         steps;
}

// Local 1 is n1, z here; 2 is the axis times n1, x.
TEST(BeamLoads, of_abaqus_are_along_the_axes_of_the_deck_or_of_the_section) {
  const Results all = loads_of(
      "bar.inp", beams("*STEP\n*STATIC\n*DLOAD\nBAR, PX, 0.7\n*END STEP\n"
                       "*STEP\n*STATIC\n*DLOAD, OP=NEW\nBAR, P1, 0.7\nBAR, P2, -1.4\n*END STEP\n"
                       "*STEP\n*STATIC\n*DLOAD, OP=NEW\nBAR, PY, 2.\n*END STEP\n"));
  const double I_1 = 10 * 216 / 12., I_2 = 6 * 1000 / 12.; // 6 along 1 (z), 10 along 2 (x)
  const double sag = 1e-3 * w * std::pow(L, 4) / (8 * E);
  const auto tip = [&](int step) {
    return node_of(load_case(all, fmt::format("it, step {}", step)), 11).displacement;
  };
  EXPECT_NEAR(tip(1)[0] / (sag / I_2), 1, 1e-9);
  EXPECT_NEAR(tip(2)[2] / (sag / I_1), 1, 1e-9);
  EXPECT_NEAR(tip(2)[0] / (-2 * sag / I_2), 1, 1e-9);
  EXPECT_NEAR(tip(3)[1] / (1e-3 * 2 * L * L / (2 * E * 60)), 1, 1e-9);
}

// The zero of *EXPANSION says nothing where alpha is one number.
TEST(DeckTemperatures, of_abaqus_go_on_from_step_to_step) {
  const Results all =
      loads_of("bar.inp",
               beams("11, 2, 2\n*STEP\n*STATIC\n*TEMPERATURE\nALL, 80.\n*END STEP\n*STEP\n*STATIC\n"
                     "*CLOAD\n11, 1, 1.\n*END STEP\n*STEP\n*STATIC\n*TEMPERATURE, OP=NEW\n1, 20.\n"
                     "*END STEP\n"));
  const double N = E * 60 * alpha * dT;
  EXPECT_NEAR(node_of(load_case(all, "it, step 1"), 1).reaction[1] / N, 1, 1e-9);
  EXPECT_NEAR(node_of(load_case(all, "it, step 2"), 1).reaction[1] / N, 1, 1e-9);
  EXPECT_NEAR(node_of(load_case(all, "it, step 3"), 1).reaction[1], 0, 1e-9);
}

// --- beside CalculiX: a curved plate of S8R that is hot, and pressed by its surface

std::string hot_plate(const std::string& steps) {
  const CurvedPlate plate = curved_plate();
  return plate.mesh + fmt::format("*NSET, NSET=WATCHED\n{}, {}\n", plate.corner, plate.other) +
         "*SURFACE, NAME=UPPER, TYPE=ELEMENT\nPLATE, SPOS\n*SURFACE, NAME=LOWER, "
         "TYPE=ELEMENT\nPLATE, SNEG\n*MATERIAL, NAME=STEEL\n*ELASTIC\n200000., .3\n*EXPANSION\n"
         "1.2e-5\n*SHELL SECTION, ELSET=PLATE, MATERIAL=STEEL\n2.\n"
         "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 20.\n*BOUNDARY\n" +
         plate.held + steps;
}

TEST(CalculixLoads, of_hot_shells_and_of_their_sides_give_its_displacements) {
  const std::string print = "*NODE PRINT, NSET=WATCHED, GLOBAL=YES\nU\n*END STEP\n";
  const std::string deck =
      hot_plate("*STEP\n*STATIC\n*TEMPERATURE\nALL, 120.\n" + print +
                "*STEP\n*STATIC\n*TEMPERATURE\nALL, 20.\n*DSLOAD\nUPPER, "
                "P, 0.001\n" +
                print + "*STEP\n*STATIC\n*DSLOAD, OP=NEW\nLOWER, P, 0.003\n" + print);
  expect_displacements_of_calculix(deck, 3);
}

} // namespace
} // namespace deck_loads
} // namespace plica::test
