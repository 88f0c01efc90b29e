// Words of Abaqus decks that people write by hand, and those of CalculiX: the same structure in
// plain words has the same frequencies, or a closed form or a benchmark says them.
#include "tests/abaqus_plate.hpp"

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

const std::string held_plate = "*BOUNDARY\nROOT, ENCASTRE\n";

Eigen::VectorXd hertz_of(const std::string& text, int count) {
  return find_modes(place(abaqus::read_text(text), {}), count).hertz;
}

void expect_clamped_plate(const std::string& text) {
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(abaqus::read_text(text), own);
}

// The clamped cantilever of ten beams along x from 0 to `length`.
std::string cantilever(double length, const std::string& type, const std::string& more) {
  return fmt::format("*NODE\n1, 0.\n11, {}\n99, 0., 0., 7.\n*NGEN\n1, 11\n*ELEMENT, TYPE={}, "
                     "ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, 10\n*MATERIAL, NAME=M\n*ELASTIC\n"
                     "2.e11, 0.3\n*DENSITY\n8000.\n*BOUNDARY\n1, 1, 6\n",
                     length, type) +
         more;
}

bool noted(const DeckModel& deck, const std::string& words) {
  for (const std::string& note : deck.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

} // namespace

// NAFEMS, The Standard NAFEMS Benchmarks (1990), FV4: a cantilever with two masses beside its end.
TEST(DeckWords, nafems_fv4_by_generated_nodes_and_elements) {
  const Eigen::VectorXd hertz =
      hertz_of("*NODE\n101, 0., 0.\n111, 10., 0.\n99, 10., 2.\n999, 10., -2.\n"
               "*NGEN, NSET=LINE\n101, 111, 1\n*ELEMENT, TYPE=B31\n101, 101, 102\n"
               "*ELGEN, ELSET=ALL\n101, 10\n*ELEMENT, TYPE=MASS, ELSET=M1\n200, 99\n"
               "*ELEMENT, TYPE=MASS, ELSET=M2\n300, 999\n*MASS, ELSET=M1\n10000.\n"
               "*MASS, ELSET=M2\n1000.\n*BEAM SECTION, SECTION=CIRC, ELSET=ALL, MATERIAL=M\n0.25\n"
               "0, 0, -1\n*MATERIAL, NAME=M\n*DENSITY\n8000.\n*ELASTIC\n2.e11, 0.3\n"
               "*MPC\nBEAM, 99, 111\nBEAM, 999, 111\n*BOUNDARY\n101, 1, 6\n",
               6);
  const double target[] = {1.723, 1.727, 7.413, 9.972, 18.155, 26.957};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(hertz[i] / target[i], 1, 0.01) << hertz.transpose();
}

TEST(DeckWords, a_plate_of_generated_filled_and_copied_nodes) {
  const std::string corners = "*NODE\n1, 0., 0.\n7, 0.3, 0.\n401, 0., 0.2\n407, 0.3, 0.2\n";
  const std::string root =
      abaqus::steel + abaqus::section + "*NSET, NSET=ROOT, GENERATE\n1, 401, 100\n" + held_plate;
  expect_clamped_plate("*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, 2, 102, 101\n" + corners +
                       "*NGEN, NSET=FRONT\n1, 7\n*NGEN, NSET=BACK\n401, 407\n"
                       "*NFILL, NSET=ALL\nFRONT, BACK, 4, 100\n*ELGEN, ELSET=WALL\n"
                       "1, 6, 1, 1, 4, 100, 10\n" +
                       root);
  expect_clamped_plate("*NODE\n1, 0., 0.\n7, 0.3, 0.\n*NGEN, NSET=FRONT\n1, 7\n"
                       "*NCOPY, OLD SET=FRONT, NEW SET=REST, CHANGE NUMBER=100, SHIFT, MULTIPLE=4\n"
                       "0., 0.05, 0.\n*ELEMENT, TYPE=S4, ELSET=ROW\n1, 1, 2, 102, 101\n"
                       "*ELGEN, ELSET=ROW\n1, 6, 1, 1, 2, 100, 10\n"
                       "*ELCOPY, OLD SET=ROW, NEW SET=UP, ELEMENT SHIFT=20, SHIFT NODES=200\n"
                       "*ELSET, ELSET=WALL\nROW, UP\n" +
                       root);
}

TEST(DeckWords, nodes_on_arcs) {
  const std::string rest = "*ELEMENT, TYPE=B31, ELSET=E\n1, 1, 2\n*MATERIAL, NAME=M\n*ELASTIC\n"
                           "2e11, .3\n*BEAM SECTION, ELSET=E, MATERIAL=M, SECTION=CIRC\n0.1\n";
  const auto at = [](const DeckModel& deck, int label) {
    for (std::size_t i = 0; i < deck.labels.size(); ++i)
      if (deck.labels[i] == label) return deck.nodes[i];
    return Vector3d(NAN, NAN, NAN);
  };
  DeckModel deck = abaqus::read_text(
      "*NODE\n1, 3., 0.\n4, 0., 3.\n9, 0., 0.\n*NGEN, LINE=C\n1, 4, 1, 9\n" + rest);
  EXPECT_LT((at(deck, 2) - 3 * Vector3d(std::cos(pi / 6), std::sin(pi / 6), 0)).norm(), 1e-12);
  deck = abaqus::read_text(
      "*NODE\n1, 4., 1.\n5, -2., 1.\n*NGEN, LINE=C\n1, 5, 1, , 1., 1., 0., 0., 0., -1.\n" + rest);
  EXPECT_LT((at(deck, 3) - Vector3d(1, -2, 0)).norm(), 1e-12); // the lower half
}

// A node after its own turns the one beam that names it; the next has the n1 of its section.
TEST(DeckWords, a_node_that_turns_a_beam_turns_no_other) {
  const DeckModel deck = abaqus::read_text(
      "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 2., 0., 0.\n9, 0., 5., 0.\n"
      "*ELEMENT, TYPE=B31, ELSET=BEAM\n1, 1, 2, 9\n2, 2, 3\n" +
      abaqus::steel +
      "*BEAM SECTION, ELSET=BEAM, MATERIAL=STEEL, SECTION=RECT\n0.02, 0.01\n0., 0., -1.\n");
  ASSERT_EQ(deck.beams.size(), 2);
  EXPECT_LT(deck.beams[0].up.cross(Vector3d(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT(deck.beams[1].up.cross(Vector3d(0, 1, 0)).norm(), 1e-12);
}

TEST(DeckWords, of_several_sections_the_last_holds) {
  const std::string twice = abaqus::mesh_text(deck_plate()) + abaqus::steel +
                            "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL\n5.e-3\n" +
                            abaqus::section + held_plate;
  expect_clamped_plate(twice);
  EXPECT_TRUE(noted(abaqus::read_text(twice), "24 elements are given several sections"));
  // One that no element is left to holds nothing, not even what is wrong with it.
  expect_clamped_plate(abaqus::mesh_text(deck_plate()) + abaqus::steel +
                       "*SHELL SECTION, ELSET=WALL, COMPOSITE\n0., 3, NONE\n" + abaqus::section +
                       held_plate);
}

TEST(DeckWords, a_set_that_is_called_by_a_number_is_no_element) {
  expect_clamped_plate(abaqus::mesh_text(deck_plate()) + abaqus::steel +
                       "*ELSET, ELSET=3\nWALL\n*SHELL SECTION, ELSET=3, MATERIAL=STEEL\n2.e-3\n" +
                       held_plate);
}

TEST(DeckWords, what_calculix_reads_past) {
  const std::string text =
      "\xEF\xBB\xBFsaved by a preprocessor\n" + abaqus::mesh_text(deck_plate()) +
      "*NODE\n1, 0., 0., 0.\n" + abaqus::steel +
      "*EXPANSION TYPE=ISO\n1.e-5\n*NSET, NSET=ROOT\n7000, 7001\n" +
      "*NSET, NSET=ROOT, GENERATE\n8000, 8010\n" + abaqus::section + held_plate +
      "*STEP\n*STATIC\n*ENDSTEP\n*STEP\n*SUBSTRUCTURE MATRIX OUTPUT, STIFFNESS=YES\n*END STEP\n";
  expect_clamped_plate(text);
  const DeckModel deck = abaqus::read_text(text);
  EXPECT_TRUE(noted(deck, "1 lines before the first keyword"));
  EXPECT_TRUE(noted(deck, "of sets 13 numbers that no node or element has"));
  EXPECT_TRUE(noted(deck, "1 nodes are given again"));
}

TEST(DeckWords, the_turns_of_a_rigid_body_are_a_node_of_calculix) {
  const std::string tied = "*NODE\n900, 0.34, 0.1, 0.\n901, 5., 5., 5.\n*ELEMENT, TYPE=MASS, "
                           "ELSET=BODY\n900, 900\n*MASS, ELSET=BODY\n0.4\n";
  const std::string plate =
      abaqus::mesh_text(deck_plate()) + abaqus::steel + abaqus::section + held_plate + tied;
  const Eigen::VectorXd plain =
      hertz_of(plate + "*RIGID BODY, NSET=TIP, REF NODE=900\n*BOUNDARY\n900, 4, 5\n", 6);
  const Eigen::VectorXd theirs = hertz_of(
      plate + "*RIGID BODY, NSET=TIP, REF NODE=900, ROT NODE=901\n*BOUNDARY\n901, 1, 2\n", 6);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(theirs[i] / plain[i], 1, deck_agreement);
}

TEST(DeckWords, equations_that_a_later_step_removes) {
  const std::string text =
      abaqus::mesh_text(deck_plate()) + abaqus::steel + abaqus::section + held_plate +
      fmt::format("*EQUATION\n2\n{0}, 3, 1., {1}, 3, -1.\n*STEP\n*STATIC\n"
                  "*END STEP\n*STEP\n*EQUATION, REMOVE\n{0}, 1, 3\n*END STEP\n",
                  abaqus::corner, abaqus::middle);
  expect_clamped_plate(text);
  EXPECT_TRUE(noted(abaqus::read_text(text), "*EQUATION, REMOVE in line"));
}

// A node after those of a beam is where n1 points to.
TEST(DeckWords, a_node_that_turns_a_beam) {
  const std::string beam = "*BEAM SECTION, ELSET=BEAM, MATERIAL=M, SECTION=RECT\n0.02, 0.05\n";
  const Eigen::VectorXd plain = hertz_of(cantilever(2, "B31", beam + "0., 0., 1.\n"), 4);
  std::string named = cantilever(2, "B31", beam + "0., 1., 0.\n");
  named.replace(named.find("\n1, 1, 2\n"), 9, "\n1, 1, 2, 99\n");
  const Eigen::VectorXd theirs = hertz_of(named, 4);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(theirs[i] / plain[i], 1, deck_agreement);
}

// f = 1.8751^2 / (2 pi) sqrt(E r^2 / rho) / L^2, r the radius of inertia of an ellipse, a quarter
// of its diameter; r of the rectangle is its size over the root of 12.
TEST(DeckWords, an_ellipse_bends_as_the_closed_form_says) {
  const Eigen::VectorXd hertz = hertz_of(
      cantilever(4, "B31",
                 "*BEAM SECTION, ELSET=BEAM, MATERIAL=M, SECTION=CIRC\n0.05, 0.08\n0., 1., 0.\n"),
      2);
  const auto closed = [](double r) {
    return 1.8751 * 1.8751 / (2 * pi) * std::sqrt(2e11 * r * r / 8000) / 16;
  };
  EXPECT_NEAR(hertz[0] / closed(0.05 / 4), 1, 0.002);
  EXPECT_NEAR(hertz[1] / closed(0.08 / 4), 1, 0.002);
}

// The line of the nodes at the upper side of the section (2 = z): its middle is half a depth below.
TEST(DeckWords, a_beam_beside_its_nodes) {
  const DeckModel deck = abaqus::read_text(
      cantilever(4, "B31",
                 "*BEAM SECTION, ELSET=BEAM, MATERIAL=M, SECTION=RECT, OFFSET2=0.5, "
                 "OFFSET1=-0.25\n0.04, 0.08\n0., 1., 0.\n"));
  ASSERT_EQ(deck.beams.size(), 10U);
  EXPECT_LT((deck.beams[3].offset1 - Vector3d(0, 0.01, -0.04)).norm(), 1e-15);
  EXPECT_EQ(deck.beams[3].offset1, deck.beams[3].offset2);
}

// The beam of CalculiX by its numbers is the general section of the same numbers.
TEST(DeckWords, the_beam_u1_of_calculix) {
  const std::string user = "*USER ELEMENT, TYPE=U1, NODES=2, INTEGRATION POINTS=2, MAXDOF=6\n"
                           "*BEAM SECTION, ELSET=BEAM, MATERIAL=M, SECTION=GENERAL\n"
                           "0.0625, 3.e-4, 0., 4.e-4, 0.8333\n0., 1., 0.\n";
  const double G = 2e11 / 2.6, shear = 0.8333 * G * 0.0625;
  const std::string general =
      fmt::format("*BEAM GENERAL SECTION, ELSET=BEAM, SECTION=GENERAL, DENSITY=8000.\n"
                  "0.0625, 3.e-4, 0., 4.e-4, 7.e-4\n0., 1., 0.\n2.e11, {:.16g}\n"
                  "*TRANSVERSE SHEAR STIFFNESS\n{:.16g}, {:.16g}\n",
                  G, shear, shear);
  const Eigen::VectorXd theirs = hertz_of(cantilever(5, "U1", user), 6);
  const Eigen::VectorXd plain = hertz_of(cantilever(5, "B31", general), 6);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(theirs[i] / plain[i], 1, deck_agreement);
}

TEST(DeckWords, a_spring_that_hardens_has_its_slope_at_rest) {
  const std::string text =
      "*NODE\n1, 0.\n2, 1.\n*ELEMENT, TYPE=SPRINGA, ELSET=S\n1, 1, 2\n"
      "*ELEMENT, TYPE=MASS, ELSET=M\n2, 2\n*MASS, ELSET=M\n2.\n"
      "*SPRING, ELSET=S, NONLINEAR\n\n-9., -0.5\n0., 0.\n800., 0.1\n9000., 0.2\n"
      "*BOUNDARY\n1, 1, 3\n2, 2, 3\n";
  EXPECT_NEAR(hertz_of(text, 1)[0], std::sqrt(8000. / 2) / (2 * pi), 1e-9);
  EXPECT_TRUE(noted(abaqus::read_text(text), "its slope from rest on is taken, 8000"));
}

TEST(DeckWords, plies_of_no_thickness_and_moduli_across_the_wall_that_are_blank) {
  const auto wall = [](const std::string& elastic, const std::string& idle) {
    return hertz_of(abaqus::mesh_text(deck_plate()) + held_plate +
                        "*MATERIAL, NAME=PLY\n*DENSITY\n1600.\n" + elastic +
                        "*SHELL SECTION, ELSET=WALL, COMPOSITE\n1.e-3, 3, PLY, 0.\n" + idle +
                        "1.e-3, 3, PLY, 90.\n",
                    4);
  };
  const Eigen::VectorXd plain =
      wall("*ELASTIC, TYPE=LAMINA\n1.4e11, 1.e10, .3, 5.e9, 5.e9, 3.e9\n", "");
  const Eigen::VectorXd theirs =
      wall("*ELASTIC, TYPE=ENGINEERINGCONSTANTS\n1.4e11, 1.e10, , .3, , , "
           "5.e9, 5.e9\n3.e9\n",
           "0., 3, PLY, 45.\n");
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(theirs[i] / plain[i], 1, deck_agreement);
}

// A normal of a beam turns its section, which of a round one says nothing.
TEST(DeckWords, a_normal_of_a_beam_whose_axes_are_alike) {
  const auto beam = [](const std::string& section, const std::string& normal) {
    return cantilever(4, "B31",
                      "*BEAM SECTION, ELSET=BEAM, MATERIAL=M, SECTION=" + section +
                          "\n0., 1., 0.\n*NORMAL, TYPE=ELEMENT\n3, 4, " + normal + "\n");
  };
  const Eigen::VectorXd plain = hertz_of(beam("CIRC\n0.05", "0., 1., 0."), 4),
                        turned = hertz_of(beam("CIRC\n0.05", "0., 0., 1."), 4);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(turned[i] / plain[i], 1, deck_agreement);
  try {
    abaqus::read_text(beam("RECT\n0.05, 0.08", "0., 0., 1."));
    ADD_FAILURE() << "a section that turns was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("two different axes"), std::string::npos)
        << error.what();
  }
}

TEST(DeckWords, a_rectangle_in_full) {
  const auto beam = [](const std::string& shape) {
    return hertz_of(cantilever(4, "B31",
                               "*BEAM SECTION, ELSET=BEAM, MATERIAL=M, SECTION=" + shape +
                                   "\n0.05, 0.08\n0., 1., 0.\n"),
                    2);
  };
  EXPECT_EQ(beam("RECTANGULAR"), beam("RECT"));
}

// A membrane beside its nodes: its middle is half a thickness above them.
TEST(DeckWords, a_membrane_beside_its_nodes) {
  const DeckModel deck = abaqus::read_text(
      "*NODE\n1, 0.\n2, 1.\n3, 1., 1.\n4, 0., 1.\n*ELEMENT, TYPE=M3D4, ELSET=M\n1, 1, 2, 3, 4\n"
      "*MATERIAL, NAME=M\n*ELASTIC\n2.e11, 0.3\n*MEMBRANE SECTION, ELSET=M, MATERIAL=M, "
      "OFFSET=-0.5\n0.02\n");
  ASSERT_EQ(deck.shells.size(), 1U);
  EXPECT_NEAR(deck.shells[0].offset, 0.01, 1e-15);
}

} // namespace plica::test
