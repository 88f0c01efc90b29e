// Decks that cannot be: each is refused with its line, its card and what is wrong.
#include "io/decks/read_deck.hpp"
#include "io/files/files.hpp"
#include "model/shape/deck.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/input_error.hpp"

#include <fmt/format.h>

#include <random>

namespace plica::test {
namespace {

struct Broken {
  std::string text; // after, or in place of a line of, the good deck
  int line = 0;
  std::string message;
  std::size_t problems = 1; // the first of them is looked at
};

// Ten lines; what is broken comes after them.
const std::string good_abaqus = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n"
                                "*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, 2, 3, 4\n"
                                "*MATERIAL, NAME=M\n*ELASTIC\n2.e11, 0.3\n";
const std::string section = "*SHELL SECTION, ELSET=WALL, MATERIAL=M\n0.001\n";

const std::string good_nastran = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\n"
                                 "GRID,4,,0.,1.,0.\nCQUAD4,1,1,1,2,3,4\nMAT1,1,2.+11,,.3\n";
const std::string property = "PSHELL,1,1,.001,1,,1\n";

// Plies, axes and given matrices.
const std::string plies =
    "*MATERIAL, NAME=C\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n14e10, 1e10, 1e10, .3, .3, .4, 5e9, "
    "5e9\n3e9\n*ORIENTATION, NAME=O\n1, 0, 0, 0, 1, 0\n3, 20.\n*SHELL SECTION, ELSET=WALL, "
    "COMPOSITE, ORIENTATION=O\n1e-3, 3, C, 45.\n1e-3, 3, C, O\n*TRANSVERSE SHEAR STIFFNESS\n"
    "1e6, 2e6, 0.\n*MATRIX INPUT, NAME=K\n1, 1, 1, 1, 3.\n2, 1, 1, 1, 2.\n2, 1, 2, 1, 9.\n"
    "*MATRIX ASSEMBLE, STIFFNESS=K\n";
const std::string laminate =
    "MAT8,4,14.+10,1.+10,.3,5.+9,5.+9,3.+9\nPCOMP,1,,,,,,,SYM\n,4,.001,45.,,4,.001,-45.\nDMIG,KX,0,"
    "6,2,0\nDMIG,KX,1,1,,1,1,3.\n,2,1,2.,0.\nDMIG,KX,2,1,,2,1,9.\nGRID,21,,0.,0.,5.\n=(9),*(1),,=,*"
    "(.5),==\nMAT2,5,4.+10,1.+10,0.,4.+10,0.,2.+10\nMAT2,6,1.+9,0.,0.,1.+9,0.,1.+9\nPSHELL,9,5,."
    "001,4,,5\n,,,6\n";

std::vector<InputProblem> problems_of(const std::string& text, const std::string& name) {
  const TemporaryFolder folder("deck");
  write_whole(folder.path / name, text);
  try {
    const auto deck = read_deck(folder.path / name, UnknownCards::error);
    place(*deck, {});
  } catch (const InputError& error) {
    return error.problems();
  } catch (const std::exception& error) {
    return {{"", 0, "", error.what(), ""}};
  }
  return {};
}

void expect_refused(const std::string& text, const std::string& name, const Broken& broken) {
  const std::vector<InputProblem> problems = problems_of(text, name);
  ASSERT_EQ(problems.size(), broken.problems) << broken.text;
  EXPECT_NE(problems[0].wrong.find(broken.message), std::string::npos)
      << broken.text << "\n-> " << to_string(problems[0]);
  EXPECT_EQ(problems[0].line, broken.line) << to_string(problems[0]);
  if (broken.line > 0) {
    EXPECT_NE(problems[0].file.find(name), std::string::npos);
  }
}

void expect_refused_abaqus(const std::vector<Broken>& all) {
  for (const Broken& b : all) expect_refused(good_abaqus + b.text, "model.inp", b);
}

void expect_refused_nastran(const std::vector<Broken>& all) {
  for (const Broken& b : all) expect_refused(good_nastran + b.text, "model.bdf", b);
}

TEST(BrokenDeck, abaqus_nodes_and_elements_made_of_others) {
  expect_refused_abaqus(
      {{section + "*NGEN\n1, 3, 5\n", 14, "goes from node 1 to 3 in steps of 5"},
       {section + "*NGEN, LINE=P\n1, 3, 1\n", 13, "has LINE=P"},
       {section + "*NGEN, LINE=C\n1, 3, 1\n", 14, "is an arc whose plane is not known"},
       {section + "*NFILL\nA, B, 2\n", 14, "there is no node set A"},
       {section + "*NCOPY, OLD SET=A, CHANGE NUMBER=1, REFLECT=POINT\n", 13,
        "has a parameter REFLECT that is not known", 2},
       {section + "*ELGEN\n1, 2, 90\n", 14, "there is no node 91"},
       {section + "*ELGEN\n1, 2000000000\n", 14, "makes 2000000000 elements"},
       {section + "*ELCOPY, OLD SET=A, ELEMENT SHIFT=1, SHIFT NODES=1\n", 13,
        "there is no element set A"}});
}

TEST(BrokenDeck, abaqus_nodes_and_elements) {
  expect_refused_abaqus(
      {{section + "*USER ELEMENT, TYPE=U3, NODES=2\n", 13, "is not had"},
       {section + "*NODE\n4, 0, 0, 1\n", 14, "node 4 is there twice, first in line 5"},
       {section + "*NODE\n4, 0, 0, 1\n5, 2, 2, 0\n3, 0, 0, 1\n*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, "
                  "2, 3, 4\n*MATERIAL, NAME=M\n*ELASTIC\n1., .3\n",
        14, "node 4 is there twice", 5},
       {section + "*SURFACE, NAME=S\nWALL\n*SURFACE, NAME=S\nWALL, SPOS\n", 15,
        "surface S is there already in line 13"},
       {section + "*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, 2, 3, 4\n", 14,
        "element 1 is there twice, first in line 7"},
       {section + "*ELEMENT, TYPE=S4, ELSET=WALL\n2, 1, 2, 3\n", 14, "has 3 nodes for S4"},
       {section + "*ELEMENT, TYPE=S4, ELSET=WALL\n2, 1, 2, 3, 9\n", 14, "there is no node 9"},
       {section + "*ELEMENT, TYPE=S9R5, ELSET=WALL\n", 13, "is not had"},
       {section + "*ELEMENT, TYPE=C3D4\n2, 1, 2, 3, 4\n*ELEMENT, TYPE=C3D8\n3, 1\n4, 1\n", 15,
        "is of solids, 3 of the 4 elements of the deck (75 %): 2 C3D8, C3D4"},
       {section + "*ELEMENT, TYPE=MASS\n9, 1\n", 14, "element 9 has no *MASS"}});
}

TEST(BrokenDeck, abaqus_sections) {
  expect_refused_abaqus(
      {{"", 7, "element 1 has no *SHELL SECTION"},
       {section + "*ELEMENT, TYPE=SPRINGA, ELSET=S\n9, 1, 2\n*SPRING, ELSET=S, NONLINEAR\n1., 1.\n"
                  "2., 2.\n",
        15, "has no slope at rest"},
       {section + "*ELEMENT, TYPE=B31, ELSET=B\n9, 1, 2\n*BEAM SECTION, ELSET=B, MATERIAL=M, "
                  "SECTION=PIPE, OFFSET1=.5\n.1, .01\n",
        15, "has OFFSET1 for SECTION=PIPE"},
       {"*SHELL SECTION, ELSET=WAL, MATERIAL=M\n0.001\n", 11, "there is no element set WAL"},
       {"*SHELL SECTION, ELSET=WALL, MATERIAL=N\n0.001\n", 11, "there is no elastic material N"},
       {"*SHELL SECTION, ELSET=WALL, MATERIAL=M\n0.\n", 12, "has no thickness"},
       {"*SHELL SECTION, ELSET=WALL, MATERIAL=M\nthin\n", 12, "field 1 is \"thin\""},
       {"*SHELL SECTION, ELSET=WALL, MATERIAL=M\n", 11, "has 0 data lines"},
       {"*SHELL SECTION, ELSET=WALL, MATERIAL=M, DENSITY=1.\n0.001\n", 11,
        "has a parameter DENSITY that is not known"},
       {section + "*TRANSVERSE SHEAR STIFFNESS\n1e6, 2e6, 0.\n", 14,
        "differs along the two axes"}});
}

TEST(BrokenDeck, abaqus_materials_and_orientations) {
  expect_refused_abaqus(
      {{section + "*MATERIAL, NAME=N\n*ELASTIC, TYPE=ANISOTROPIC\n", 14, "has TYPE=ANISOTROPIC"},
       {section + "*MATERIAL, NAME=N\n*ELASTIC, TYPE=LAMINA\n1e11, 1e10, 4., 5e9, 5e9, 5e9\n", 15,
        "is no material in plane stress"},
       {section + "*MATERIAL, NAME=N\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1e11, 1e10\n", 14,
        "has 1 data lines"},
       {section + "*ORIENTATION, NAME=O\n1,0,0,0,1,0\n*ORIENTATION, NAME=O\n1,0,0,0,1,0\n", 15,
        "orientation O is there already in line 13"},
       {section + "*MATERIAL, NAME=N\n*ELASTIC\n2e11, 0.6\n", 15, "is no material"},
       {"*DENSITY\n7800.\n" + section + "*DENSITY\n8000.\n", 15,
        "material M has one already in line 11"},
       {"8000.\n" + section, 10, "has 2 data lines and no temperatures"},
       {section + "*ELASTIC\n2e11, 0.3\n", 13, "material M has one already in line 9"},
       {section + "*MATERIAL, NAME=M\n", 13, "material M is there already in line 8"},
       {section + "*MATERIAL, NAME=N, NAME=O\n", 13, "has NAME twice, N and O"}});
}

TEST(BrokenDeck, abaqus_supports_and_what_couples) {
  expect_refused_abaqus(
      {{section + "*RIGID BODY, ELSET=WALL, REF NODE=1, ROT NODE=1\n", 13,
        "has one node as REF NODE and ROT NODE"},
       {section + "*EQUATION, REMOVE\n1, 1\n", 14, "REMOVE names no equation"},
       {section + "*BOUNDARY\n1, 7\n", 14, "names degree of freedom 7"},
       {section + "*BOUNDARY\nEDGE, 1\n", 14, "there is no node set EDGE"},
       {section + "*EQUATION\n2\n1, 1, 1.\n", 13, "has 2 data lines"},
       {section + "*COUPLING, CONSTRAINT NAME=C, REF NODE=1, SURFACE=S\n", 13,
        "is neither kinematic nor distributing"},
       {section + "*COUPLING, CONSTRAINT NAME=C, REF NODE=1, SURFACE=S\n*KINEMATIC\n", 13,
        "there is no surface S"},
       {section + "*COUPLING, CONSTRAINT NAME=C, REF NODE=1, SURFACE=S\n*COUPLING, CONSTRAINT "
                  "NAME=D, REF NODE=1, SURFACE=S\n*KINEMATIC\n",
        13, "is neither kinematic nor distributing", 2},
       {section + "*KINEMATIC\n1, 6\n", 13, "follows no *COUPLING"},
       {section + "*MPC\nSLIDER, 1, 2\n", 14, "is \"SLIDER\""},
       {section + "*TIE, NAME=T\nA, B\n", 13, "there is no surface A"},
       {section + "*CONTACT PAIR, INTERACTION=I\nA, B\n", 13, "is not had"},
       {section + "*COUPLING PAIRS\n", 13, "is not known"}});
}

TEST(BrokenDeck, abaqus_parts_and_files) {
  expect_refused_abaqus(
      {{section + "*INCLUDE, INPUT=nowhere.inp\n", 13, "there is no file"},
       {section + "*INCLUDE, INPUT=model.inp\n", 13, "include each other"},
       {section + "*PART, NAME=P\n", 13, "P has no end"},
       {section + "*INSTANCE, NAME=I, PART=P\n*END INSTANCE\n", 13, "there is no part P"},
       {section + "*TRANSFORM, NSET=N, TYPE=R\n1, 0, 0, 0, 1, 0\n", 14, "there is no node set N"}});
}

TEST(BrokenDeck, abaqus) {
  expect_refused_abaqus(
      {{section + "*NODE\n5, x, 0, 0\n", 14, "field 2 is \"x\""},
       {section + "*NODE\n5-3, 0, 0, 0\n", 14, "field 1 is \"5-3\""},
       {section + "*NSET, NSET=A, GENERATE\n1, 4, 1e300\n", 14, "field 3 is \"1e300\""}});
  expect_refused("solid thing\n", "model.inp", {"not a deck", 1, "is no keyword"});
  expect_refused("", "model.inp", {"empty", 0, "has no keyword"});
  expect_refused("*HEADING\nnothing\n", "model.inp", {"nothing", 0, "has no node"});
  expect_refused("*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 2, 0, 0\n4, 3, 0, 0\n"
                 "*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, 2, 3, 4\n*MATERIAL, NAME=M\n*ELASTIC\n"
                 "2.e11, 0.3\n" +
                     section,
                 "model.inp", {"a line", 0, "element 1 in line 7 has no area"});
}

TEST(BrokenDeck, says_at_once_what_does_not_build_on_each_other) {
  std::vector<InputProblem> problems = problems_of(
      good_abaqus + "*HYPERELASTIC\n*CONTACT PAIR\nA, B\n*HYPERELASTIC\n*RELEASE\n" + section,
      "model.inp");
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].line, 11); // most frequent first
  EXPECT_EQ(problems[0].wrong, "is not had, 2 times from here on");
  problems =
      problems_of(good_abaqus + section + "*BOUNDARY\n1, 7\n*BOUNDARY\nEDGE, 1\n", "model.inp");
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].line, 14);
  EXPECT_EQ(problems[1].line, 16);
  problems =
      problems_of(good_nastran + property + "CHEXA,2,1,1,2,3,4\nCTETRA,3,1,1,2,3,4\n", "model.bdf");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 8);
  EXPECT_EQ(problems[0].wrong,
            "is of solids, 2 of the 3 elements of the deck (67 %): CHEXA, CTETRA");
  problems =
      problems_of(good_nastran + property + "CTRIA3,2,1,1,2,9\nCTRIA3,3,1,1,2,8\n", "model.bdf");
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_NE(problems[1].wrong.find("there is no grid point 8"), std::string::npos);
}

TEST(BrokenDeck, shells_that_are_folded_and_bodies_that_are_none) {
  std::string folded = good_abaqus + section;
  folded.replace(folded.find("3, 1, 1, 0"), 10, "3, 0.2, 0.2, 0");
  expect_refused(folded, "model.inp", {"folded", 0, "element 1 in line 7 is folded"});
  expect_refused(good_abaqus + section +
                     "*ELEMENT, TYPE=MASS, ELSET=M\n9, 1\n*MASS, ELSET=M\n-1.\n",
                 "model.inp", {"negative", 16, "is no body"});
  expect_refused(good_nastran + property + "CONM2,9,1,,1.\n,1.-4,5.-4,1.-4,,,1.-4\n", "model.bdf",
                 {"inertia", 8, "is no body"});
}

TEST(BrokenDeck, nastran_points_and_their_systems) {
  expect_refused_nastran(
      {{property + "GRID,4,,0.,0.,1.\n", 8, "grid point 4 is there twice"},
       {property + "GRID,5,7,0.,0.,1.\n", 8, "there is no coordinate system 7"},
       {property + "GRID,5,,0.,0.,1.,7\n", 8, "there is no coordinate system 7"},
       {property + "GRDSET,,,,,,,345\nGRDSET,,,,,,,345\n", 9, "is there already in line 8"},
       {property + "CORD2R,9,9,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nGRID,8,9,0.,0.,0.\n", 8,
        "refer to each other"},
       {property + "CORD2R,9,,0.,0.,0.,0.,0.,1.\n,0.,0.,2.\nGRID,8,9,0.,0.,0.\n", 8,
        "three points on one line"}});
}

TEST(BrokenDeck, nastran_walls_and_materials) {
  expect_refused_nastran(
      {{"", 5, "there is no PSHELL 1"},
       {"PSHELL,1,2,.001,1,,1\n", 7, "there is no material 2"},
       {"PSHELL,1,1,.001,-1\n", 7, "is in plane strain"},
       {"PSHELL,1,1,,1\n", 5, "has no thickness"},
       {property + "PCOMP,3,,,,,,,BEND\n,1,.001,0.\n", 8, "is laminated with LAM BEND"},
       {property + "MAT8,3,1.+11,1.+10,4.,5.+9\nPSHELL,3,3,.001,3,,3\n", 9,
        "which has no stiffness in some direction"},
       {property + "PSHELL,3,1,.001,1,,1\n,,,1\n", 8, "by more than they resist"},
       {property + "MAT1,3\nPSHELL,3,3,.001,3,,3\n", 9, "which has no stiffness"},
       {property + "PSHELL,1,1,.002,1,,1\n", 8, "1 is there already in line 7"},
       {property + "MAT1,2,,4.+10\n", 8, "is no material"},
       {property + "MAT1,2,2.+11,,7.\n", 8, "has nu = 7."},
       {property + "MAT1,2,2.+11,4.+10,.3\nPSHELL,2,,.001,2,,2\n", 9,
        "a wall of material 2 in line 8, which has G = 4e+10, which E and nu make 7.69231e+10"}});
}

TEST(BrokenDeck, nastran_beams_springs_and_matrices) {
  expect_refused_nastran(
      {{property + "GENEL,1,,2,3\n", 8, "has no matrix"},
       {property + "CROD,2,1,1,2\n", 8, "there is no PROD 1"},
       {property + "CONROD,2,1,2,7,1.-4\n", 8, "there is no material 7"},
       {property + "CELAS4,2,5.,1\n", 8, "is tied to grid point 1"},
       {property + "PBARL,3,1,,HAT\n,1.,1.,1.,1.\n", 8, "do not fit its shape HAT"},
       {property + "PBARL,3,1,,I\n,.01,.02,.02,.002,.006,.006\n", 8, "do not fit its shape I"},
       {property + "PBEAML,3,1,,TEE\n,.01,.02,.002,.002\n", 8, "has the shape TEE"},
       {property + "CELASS1,2,1,1,2,3,4\n", 8, "is not had"},
       {property + "CBUSH,2,1,1,2\n", 8, "there is no PBUSH 1"},
       {property + "CELAS2,2,5.,1\n", 8, "acts on components \"\""},
       {property + "CBAR,2,1,1,2,0.,0.,1.\n", 8, "there is no property 1 of a beam"}});
}

TEST(BrokenDeck, nastran_elements) {
  expect_refused_nastran(
      {{property + "PSHEAR,3,1,.001\nCSHEAR,2,3,1,2,4,3\n", 9, "that points inward"},
       {property + "CQUAD4,1,1,1,2,3,4\n", 8, "element 1 is there twice"},
       {property + "CTRIA3,2,1,1,2,9\n", 8, "there is no grid point 9"},
       {property + "CHEXA,2,1,1,2,3,4\n", 8, "is of solids, 1 of the 2 elements"},
       {property + "CQUAD,2,1,1,2,3,4\n", 8, "is not had"}});
}

TEST(BrokenDeck, nastran_rigid_bodies_supports_and_parameters) {
  expect_refused_nastran(
      {{property + "PARAM,CM1,2.\n", 8, "scales what is solved"},
       {property + "CORD3G,2,1,1,2,3,4\n", 8, "is not known"},
       {property + "RBE2,2,1,127,2\n", 8, "field 4 is \"127\""},
       {property + "RBE2,2,1,123456,2,GRID\n", 8, "amid its grid points"},
       {property + "RBE3,2,,1,123456,1.,12345,2\n", 8, "do not determine its motion"},
       {property + "RBAR,2,1,2,123,456\n", 8, "at both ends"},
       {property + "SPC,1,1,123\nSPC,2,2,123\n", 9, "belongs to one of 2 sets"}});
}

TEST(BrokenDeck, nastran) {
  expect_refused_nastran(
      {{property + "GRID,5,,zero\n", 8, "field 4 is \"zero\""},
       {property + "GRID,-,,1.,0.,0.\n", 8, "field 2 is \"-\""},
       {property + "GRID,25-3,,1.,0.,0.\n", 8, "field 2 is \"25-3\""},
       {property + "CTRIA3,2,1,1,2,3x\n", 8, "field 6 is \"3x\""},
       {property + "SPC1,1,123,1,THRU,999999999\n", 8, "THRU leads to 999999999"},
       {property + "GRID,5,,0x1p3,0.,0.\n", 8, "field 4 is \"0x1p3\""},
       {property + "SPC1,1,123,1,2,3,4,1,2,3,4\n", 8, "behind its 8 fields"},
       {property + "GRID,5,,0.,0.,0.,,,,+A\n+B,1.\n", 9, "is continued by \"+B\""},
       {property + "GRID,5,,0.,0.,0.\n,1.\n", 8, "goes on beyond its last field with \"1.\""},
       {property + "INCLUDE 'nowhere.bdf'\n", 8, "there is no file"},
       {property + "INCLUDE 'model.bdf'\n", 8, "include each other"}});
  expect_refused("", "model.bdf", {"empty", 0, "has no card"});
  expect_refused("*NODE\n1, 0, 0, 0\n", "model.bdf", {"Abaqus", 1, "is a keyword of Abaqus"});
  expect_refused(",1,2,3\n", "model.bdf", {"tail", 1, "continues no card"});
}

// Whatever a byte becomes, the deck is read or refused, and nothing else.
TEST(BrokenDeck, any_byte_may_be_wrong) {
  std::mt19937 random(5);
  const TemporaryFolder folder("deck");
  int refused = 0;
  for (const auto& [name, text] :
       {std::pair{"model.inp", good_abaqus + section},
        {"model.bdf", good_nastran + property},
        {"plies.inp", good_abaqus + plies},
        {"plies.bdf", "CEND\nK2GG=2.*KX\nBEGIN BULK\n" + good_nastran + laminate}})
    for (int round = 0; round < 400; ++round) {
      std::string broken = text;
      for (int change = 0; change < 3; ++change)
        broken[random() % broken.size()] = char(random() % 256);
      if (round % 4 == 0) broken.resize(random() % broken.size());
      const std::string file = fmt::format("{}_{}", round, name);
      write_whole(folder.path / file, broken);
      try {
        place(*read_deck(folder.path / file, UnknownCards::list), {});
      } catch (const InputError& error) {
        ++refused;
        EXPECT_FALSE(error.problems().empty());
      } catch (const std::runtime_error& error) { // of the placing
        EXPECT_NE(std::string(error.what()), "");
      }
    }
  EXPECT_GT(refused, 400);
}

} // namespace
} // namespace plica::test
