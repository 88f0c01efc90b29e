// Loads of decks that are not had are refused, where they are asked for.
#include "tests/deck_loads.hpp"
#include "tests/support/refusal.hpp"

namespace plica::test {
namespace deck_loads {
namespace {

std::vector<InputProblem> problems_of(const std::string& file, const std::string& deck) {
  return input_problems([&] { loads_of(file, deck); });
}

TEST(DeckLoads, what_acts_and_is_not_had_is_refused_with_its_lines_all_at_once) {
  const std::string deck =
      bar("SPC = 1\nLOAD = 10\n", "FORCE,10,99,0,60.,0.,1.,0.\nRFORCE,10,1,,1.,0.,1.,1.\n"
                                  "PLOAD4,10,5,1.\nSPCD,10,11,2,1.\n");
  const auto problems = problems_of("bar.bdf", deck);
  ASSERT_EQ(problems.size(), 4U);
  for (const InputProblem& p : problems) EXPECT_EQ(p.key, "analyses.static");
  std::string all;
  for (const InputProblem& p : problems) all += p.wrong + "\n";
  for (const char* part : {"bar.bdf:33: FORCE: there is no grid point 99", "bar.bdf:34: RFORCE",
                           "element 5, which is no shell", "11 2, which no SPC holds"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

TEST(DeckLoads, what_would_change_the_loads_unseen_is_refused) {
  const auto said = [](const std::string& file, const std::string& deck) {
    std::string all;
    for (const InputProblem& p : problems_of(file, deck)) all += p.wrong + "\n";
    return all;
  };
  const std::string force = "FORCE,10,11,0,60.,0.,1.,0.\n";
  const auto refused = [&](const std::string& control, const std::string& cards,
                           const std::string& why) {
    const std::string all = said("bar.bdf", bar(control, force + cards));
    EXPECT_NE(all.find(why), std::string::npos) << why << " in\n" << all;
  };
  refused("SPC = 1\nLOAD = 10\n", "PLOAD2,10,1.,1,THRU,10\n", "acts on no shell");
  refused("SPC = 1\nLOAD = 10\nP2G = LOADS\n", "", "P2G of case control");
  refused("SPC = 1\nLOAD = 10\n",
          "CORD2C,5,0,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nGRAV,10,5,9810.,1.,0.,0.\n",
          "axes turn from place to place");
  const std::string truss =
      "*NODE\n1, 0, 0, 0\n2, 100, 0, 0\n*ELEMENT, TYPE=B31, ELSET=B\n1, 1, 2\n"
      "*MATERIAL, NAME=M\n*ELASTIC\n2e5, .3\n*BEAM SECTION, SECTION=RECT, "
      "ELSET=B, MATERIAL=M\n2., 2.\n0, 0, 1\n*BOUNDARY\n1, 1, 6\n";
  const std::string cases = said(
      "bar.inp", truss + "*STEP, PERTURBATION\n*STATIC\n*LOAD CASE, NAME=A\n*CLOAD\n2, 2, 1.\n"
                         "*END LOAD CASE\n*LOAD CASE, NAME=B\n*CLOAD\n2, 3, 1.\n*END LOAD CASE\n"
                         "*END STEP\n");
  EXPECT_NE(cases.find("*LOAD CASE is not had"), std::string::npos) << cases;
  const std::string fixed =
      said("bar.inp", truss + "*STEP\n*STATIC\n*BOUNDARY\n2, 2, 2, 4.\n*END STEP\n*STEP\n*STATIC\n"
                              "*BOUNDARY, FIXED\n2, 2, 2\n*END STEP\n");
  EXPECT_NE(fixed.find("holds by FIXED"), std::string::npos) << fixed;
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
  EXPECT_NE(warm[0].wrong.find("there is no temperature of set 3"), std::string::npos);
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
