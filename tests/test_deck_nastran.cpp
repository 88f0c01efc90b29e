// Every card of a Nastran deck that is followed: its frequencies are those of the same model put
// together by hand. The plate is that of tests/deck_text.hpp.
#include "io/decks/nastran_cards.hpp"
#include "io/decks/read_nastran.hpp"
#include "io/files/files.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/triangulated.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::Vector3d;

std::string number(double x) {
  return nastran_real(x);
}

std::string grids(const Mesh& mesh) {
  std::string text;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    text += large_card("GRID", {std::to_string(i + 1), "", number(mesh.nodes[i].x()),
                                number(mesh.nodes[i].y()), number(mesh.nodes[i].z())});
  return text;
}

template <class Shells>
std::string elements(const Shells& shells, const std::string& name,
                     const std::vector<std::string>& more = {}) {
  std::string text;
  for (std::size_t e = 0; e < shells.size(); ++e) {
    std::vector<std::string> fields{std::to_string(e + 1), "1"};
    for (int node : shells[e].nodes) fields.push_back(std::to_string(node + 1));
    fields.insert(fields.end(), more.begin(), more.end());
    text += small_card(name, fields);
  }
  return text;
}

std::string spc1(const Mesh& mesh, const std::string& set, const std::string& dofs,
                 const std::string& sid = "1") {
  std::vector<std::string> fields{sid, dofs};
  for (int node : mesh.sets.at(set)) fields.push_back(std::to_string(node + 1));
  return small_card("SPC1", fields);
}

const std::string mat1 = "MAT1    1       2.0+11          0.3     8000.\n";
const std::string pshell = "PSHELL  1       1       .002    1               1\n";

DeckModel read_text(const std::string& text, UnknownCards unknown = UnknownCards::error) {
  const TemporaryFolder folder("nastran");
  write_whole(folder.path / "model.bdf", of_consistent_mass(text));
  return read_nastran(folder.path / "model.bdf", unknown);
}

std::string plate() {
  return grids(deck_plate()) + elements(deck_plate().quads, "CQUAD4") + mat1 + pshell;
}
std::string clamped() {
  return spc1(deck_plate(), "edge4", "123456");
}

void expect_plate(const std::string& more, const std::function<void(Model&)>& by_hand) {
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  by_hand(own);
  expect_same_frequencies(read_text(plate() + clamped() + more), own);
}

const int corner = number_at(0.3, 0.2), middle = number_at(0.15, 0.1), other = number_at(0.3, 0);

// Of three given constants each is used where it enters; within rounding a wall takes them.
TEST(NastranReader, shear_modulus_beside_E_and_nu_is_that_of_beams) {
  const std::string two = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCBAR,1,1,1,2,0.,1.,0.\n";
  const double J = std::numbers::pi / 2 * std::pow(0.02, 4);
  const auto beam = [&](const std::string& material, const std::string& property) {
    return read_text(two + material + property).beams.at(0).section;
  };
  const std::string rod = "PBARL,1,1,,ROD\n,.02\n", numbers = "PBAR,1,1,1.-3,1.-6,1.-6,2.-6\n";
  const BeamProperties given = beam("MAT1,1,2.1+11,4.+10,.3,7800.\n", rod);
  const BeamProperties usual = beam("MAT1,1,2.1+11,,.3,7800.\n", rod);
  EXPECT_NEAR(given.GJ / (4e10 * J), 1, 1e-12);
  EXPECT_NEAR(given.GA_y / usual.GA_y, 4e10 / (2.1e11 / 2.6), 1e-12);
  EXPECT_EQ(given.EI_y, usual.EI_y);
  EXPECT_NEAR(beam("MAT1,1,2.1+11,4.+10,.3,7800.\n", numbers).GJ, 4e10 * 2e-6, 1e-6);
  EXPECT_NEAR(beam("MAT1,1,2.1+11,4.+10\n", numbers).GJ, 4e10 * 2e-6, 1e-6);
  const std::string rounded = elements(deck_plate().quads, "CQUAD4") + "MAT1,1,2.0+11,7.7+10,.3\n";
  EXPECT_EQ(read_text(grids(deck_plate()) + rounded + pshell).sections.at(0).nu, 0.3);
}

TEST(NastranReader, blanks_may_stand_before_a_card) {
  const DeckModel deck = read_text("  PARAM, POST,-1\n GRID,1,,0.,0.,0.\n\t GRID , 2,,1.,0.,0.\n"
                                   "         GRID,3,,2.,0.,\n        ,\n GRID   4       "
                                   "        3.\n");
  ASSERT_EQ(deck.nodes.size(), 4U);
  EXPECT_EQ(deck.nodes[2], Vector3d(2, 0, 0));
  EXPECT_EQ(deck.nodes[3], Vector3d(3, 0, 0));
}

TEST(NastranReader, grid_cquad4_pshell_mat1_spc1) {
  expect_plate("", [](Model&) {});
  expect_plate("ENDDATA\nnonsense after the end\n", [](Model&) {});
}

TEST(NastranReader, case_control_free_fields_and_continuations) {
  const Mesh mesh = deck_plate();
  std::string text = "SOL 103\nCEND\nTITLE = plate\nSPC = 7 $ a comment\nMETHOD = 1\nBEGIN BULK\n"
                     "EIGRL,1,,,10\nPARAM,POST,-1\nMAT1,1,2.E11,,.3,8.D3\n"
                     "PSHELL,1,1,.002,1,,1\nSPC1,8,3,1\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    text += fmt::format("GRID*,{},,{},{}\n*,{}\n", i + 1, number(mesh.nodes[i].x()),
                        number(mesh.nodes[i].y()), number(mesh.nodes[i].z()));
  text += elements(mesh.quads, "CQUAD4") + spc1(mesh, "edge4", "123456", "7") + "ENDDATA\n";
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(read_text(text), own);
}

TEST(NastranReader, include_spcadd_thru_and_permanent_constraints) {
  const TemporaryFolder folder("nastran");
  write_whole(folder.path / "mesh.bdf",
              grids(deck_plate()) + elements(deck_plate().quads, "CQUADR"));
  std::string text = "SPC = 3\nBEGIN BULK\nINCLUDE 'mesh.bdf'\n" + mat1 + pshell +
                     "SPCADD  3       1       2\n" + spc1(deck_plate(), "edge4", "123456") +
                     "SPC1    2       2       1       THRU    3\n" +
                     fmt::format("SPC,2,{},6,0.,{},4\n", corner, other) + "ENDDATA\n";
  write_whole(folder.path / "model.bdf", of_consistent_mass(text));
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  add_support(own, {0, 1, 2}, {1}, "row");
  add_support(own, {corner - 1}, {5}, "corner");
  add_support(own, {other - 1}, {3}, "other");
  expect_same_frequencies(read_nastran(folder.path / "model.bdf", UnknownCards::error), own);
  Model pinned = own_plate();
  hold(pinned, "edge4", all_dofs);
  add_support(pinned, {corner - 1}, {2}, "grid");
  std::string bulk = plate() + clamped();
  const std::string grid =
      large_card("GRID", {std::to_string(corner), "", number(0.3), number(0.2), number(0)});
  ASSERT_NE(bulk.find(grid), std::string::npos);
  bulk.replace(bulk.find(grid), grid.size(), fmt::format("GRID,{},,.3,.2,0.,,3\n", corner));
  expect_same_frequencies(read_text(bulk), pinned);
}

// The same plate in a rectangular system, turned and moved, and its corner in a cylindrical and a
// spherical one.
TEST(NastranReader, coordinate_systems) {
  std::string text = "CORD2R,4,,1.,2.,3.,1.,2.,4.\n,1.,3.,3.\n"; // its x is our y, its y our -x
  text += "CORD2C,5,4,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nCORD2S,6,4,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n";
  const Mesh mesh = deck_plate();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const double x = mesh.nodes[i].x(), y = mesh.nodes[i].y();
    const double degrees = std::atan2(y, x) * 180 / M_PI;
    const std::string id = std::to_string(i + 1);
    if (int(i) + 1 == corner)
      text += large_card("GRID", {id, "5", number(std::hypot(x, y)), number(degrees), "0."});
    else if (int(i) + 1 == other)
      text += large_card("GRID", {id, "6", number(std::hypot(x, y)), "90.", number(degrees)});
    else
      text += large_card("GRID", {id, "4", number(x), number(y), "0."});
  }
  const DeckModel deck =
      read_text(text + elements(mesh.quads, "CQUAD4") + mat1 + pshell + clamped());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vector3d place(1 - mesh.nodes[i].y(), 2 + mesh.nodes[i].x(), 3);
    EXPECT_LE((deck.nodes[i] - place).norm(), 1e-12) << i;
  }
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(deck, own);
}

TEST(NastranReader, shells_with_factors_offsets_and_thickness) {
  const std::string base = grids(deck_plate()) + mat1 + clamped();
  Model own = own_plate();
  own.shells[0].section.bending_factor = 0.25;
  own.shells[0].section.shear_correction = 0.7;
  own.shells[0].section.rho = 8000 + 3 / 2e-3;
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(
      read_text(base + elements(deck_plate().quads, "CQUAD4") +
                "PSHELL  1       1       .002    1       .25     1       .7      3.\n"),
      own);
  Model plain = own_plate();
  hold(plain, "edge4", all_dofs);
  expect_same_frequencies(
      read_text(base + elements(deck_plate().quads, "CQUAD4", {"", ".004"}) + pshell), plain);
  for (const auto& [flag, corners] : {std::pair{"0", "8.-4"}, {"1", ".4"}}) {
    Model tapered = own_plate();
    for (ShellQuad& quad : tapered.mesh.quads) quad.thickness[2] = 8e-4;
    hold(tapered, "edge4", all_dofs);
    expect_same_frequencies(
        read_text(base +
                  elements(deck_plate().quads, "CQUAD4", {"", "", "", flag, "", "", corners}) +
                  pshell),
        tapered);
  }
}

TEST(NastranReader, triangles) {
  for (const char* name : {"CTRIA3", "CTRIAR"}) {
    Model own = own_plate(triangulated(deck_plate()));
    hold(own, "edge4", all_dofs);
    expect_same_frequencies(read_text(grids(deck_plate()) + mat1 + pshell + clamped() +
                                      elements(own.mesh.triangles, name)),
                            own);
  }
}

TEST(NastranReader, conm2_beside_its_grid_point_and_wtmass) {
  const auto by_hand = [](Model& own) {
    RigidMass body{.mass = 0.25, .offset = {0.01, 0.02, -0.03}};
    body.inertia << 2e-4, 1e-5, -2e-5, 1e-5, 3e-4, 3e-5, -2e-5, 3e-5, 4e-4;
    own.masses.push_back({corner - 1, body});
  };
  const std::string inertia_row = ",2.-4,-1.-5,3.-4,2.-5,-3.-5,4.-4\n";
  expect_plate(fmt::format("CONM2,901,{},0,.25,.01,.02,-.03\n", corner) + inertia_row, by_hand);
  expect_plate(fmt::format("CONM2,901,{},-1,.25,.31,.22,-.03\n", corner) + inertia_row, by_hand);
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  own.masses.push_back({corner - 1, {.mass = 0.25}});
  std::string text =
      plate() + clamped() + "PARAM,WTMASS,.001\n" + fmt::format("CONM2,901,{},,250.\n", corner);
  text.replace(text.find("8000."), 5, "8.+6 ");
  expect_same_frequencies(read_text(text), own);
}

const std::string body = "GRID,500,,.34,.08,.03\nCONM2,901,500,,.4\n,1.-4,,1.-4,,,2.-4\n";

std::string tip() {
  std::string text;
  const Mesh mesh = deck_plate();
  for (int node : mesh.sets.at("edge2")) text += fmt::format(",{}", node + 1);
  return text;
}

TEST(NastranReader, rbe2_of_all_and_of_some_components) {
  for (const auto& [components, dofs] :
       {std::pair{"123456", all_dofs}, {"123", std::vector{0, 1, 2}}})
    expect_plate(body + fmt::format("RBE2,910,500,{}", components) + tip() +
                     fmt::format("\n,{}\n", middle),
                 [&, tied = dofs](Model& own) {
                   std::vector<int> nodes = own.mesh.sets.at("edge2");
                   nodes.push_back(middle - 1);
                   add_kinematic_coupling(own, add_body(own), nodes, tied, "rbe2");
                 });
}

// Two weights, and the mean of displacements alone for a mass without rotations.
TEST(NastranReader, rbe3_with_weights) {
  const std::string groups =
      fmt::format("RBE3,910,,500,123456,1.,123,{},{}\n,{},2.5,123,{},{}\n", number_at(0.3, 0),
                  number_at(0.3, 0.05), number_at(0.3, 0.1), number_at(0.3, 0.15), middle);
  expect_plate(body + groups, [](Model& own) {
    add_distributing_coupling(own, add_body(own),
                              {number_at(0.3, 0) - 1, number_at(0.3, 0.05) - 1,
                               number_at(0.3, 0.1) - 1, number_at(0.3, 0.15) - 1, middle - 1},
                              "rbe3", {1, 1, 1, 2.5, 2.5});
  });
  std::string three = groups;
  three.replace(three.find("123456"), 6, "123");
  expect_plate("GRID,500,,.34,.08,.03\nCONM2,901,500,,.4\n" + three, [](Model& own) {
    const int node = add_node(own, {0.34, 0.08, 0.03});
    own.masses.push_back({node, {.mass = 0.4}});
    add_distributing_coupling(own, node,
                              {number_at(0.3, 0) - 1, number_at(0.3, 0.05) - 1,
                               number_at(0.3, 0.1) - 1, number_at(0.3, 0.15) - 1, middle - 1},
                              "rbe3", {1, 1, 1, 2.5, 2.5});
  });
}

TEST(NastranReader, rbar_either_way) {
  const auto by_hand = [](Model& own) {
    add_kinematic_coupling(own, corner - 1, {add_body(own)}, all_dofs, "rbar");
  };
  expect_plate(body + fmt::format("RBAR,910,{},500,123456\n", corner), by_hand);
  expect_plate(body + fmt::format("RBAR,910,500,{},,123456\n", corner), by_hand);
}

TEST(NastranReader, mpc) {
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  own.constraints.push_back(
      {corner - 1, 2, {{middle - 1, 2, 0.5}, {middle - 1, 4, -0.01}}, "equation"});
  const std::string card =
      fmt::format("MPC,5,{},3,2.,{},3,-1.\n,,{},5,.02\n", corner, middle, middle);
  expect_same_frequencies(read_text("SPC = 1\nMPC = 5\nBEGIN BULK\n" + plate() + clamped() + card),
                          own);
  expect_same_frequencies(
      read_text("SPC = 1\nMPC = 9\nBEGIN BULK\nMPCADD,9,5\n" + plate() + clamped() + card), own);
  for (const char* control : {"SPC = 1\nMPC = 6\n", "SPC = 2\nMPC = 5\n"})
    EXPECT_THROW(read_text(control + ("BEGIN BULK\n" + plate() + clamped() + card)), InputError)
        << control; // a set that is not there
  const DeckModel none = read_text("CEND\nBEGIN BULK\n" + plate() + clamped() + card);
  EXPECT_TRUE(none.supports.empty() && none.equations.empty());
  ASSERT_EQ(none.notes.size(), 2U);
  EXPECT_NE(none.notes[1].find("chooses no set of SPC"), std::string::npos);
  const DeckModel two = read_text("SUBCASE 1\nSPC = 1\nSUBCASE 2\nSPC = 4\nBEGIN BULK\n" + plate() +
                                  clamped() + spc1(deck_plate(), "edge2", "3", "4"));
  EXPECT_EQ(two.supports.size(), 6 * deck_plate().sets.at("edge4").size());
  ASSERT_EQ(two.notes.size(), 1U);
  EXPECT_NE(two.notes[0].find("that of the first, 1, is in force"), std::string::npos);
}

TEST(NastranReader, springs) {
  const auto foot = [](Model& own) {
    BushingElement spring{.node1 = corner - 1, .node2 = -1, .bushing = {}};
    spring.bushing.law.diagonal() << 0, 0, 2e4, 0, 50, 0;
    own.bushings.push_back(spring);
  };
  expect_plate(fmt::format("PBUSH,20,K,,,2.+4,,50.\nCBUSH,920,20,{},,,,,0\n", corner), foot);
  expect_plate(fmt::format("PELAS,21,2.+4\nCELAS1,921,21,{0},3\nCELAS2,922,50.,{0},5\n", corner),
               foot);
  expect_plate(fmt::format("CELAS2,922,150.,{},3,{},5\n", corner, middle), [](Model& own) {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(12);
    b[2] = 1;
    b[6 + 4] = -1;
    own.matrices.push_back({.nodes = {corner - 1, middle - 1},
                            .K = 150 * b * b.transpose(),
                            .M = Eigen::MatrixXd::Zero(12, 12)});
  });
  expect_plate(body + fmt::format("PBUSH,20,K,1.+5,2.+5,3.+5,4.+2,5.+2,6.+2\nCBUSH,920,20,{},500,,,"
                                  ",0\n",
                                  corner),
               [](Model& own) {
                 BushingElement link{.node1 = corner - 1, .node2 = add_body(own), .bushing = {}};
                 link.bushing.law.diagonal() << 1e5, 2e5, 3e5, 4e2, 5e2, 6e2;
                 own.bushings.push_back(link);
               });
}

constexpr double inf = std::numeric_limits<double>::infinity();

// A beam from a corner, out of the plane of the plate and askew; our local z is the y of Nastran.
void expect_beam(const std::string& cards, const BeamProperties& section,
                 const Vector3d& offset1 = Vector3d::Zero()) {
  expect_plate("GRID,500,,.35,.25,.4\n" + cards, [&](Model& own) {
    const int node = add_node(own, {0.35, 0.25, 0.4});
    own.beams.push_back({.node1 = corner - 1,
                         .node2 = node,
                         .section = section,
                         .up = {1, 0.5, 0},
                         .offset1 = offset1});
  });
}

TEST(NastranReader, bars_and_beams) {
  const BeamMaterial m{2e11, 0.3, 8000};
  const double G = m.E / 2.6;
  const std::string bar = fmt::format("CBAR,930,9,{},500,1.,.5,0.\n", corner);
  expect_beam("PBARL,9,1,,ROD\n,6.-3\n" + bar, round_section(m, 6e-3));
  expect_beam("PBARL,9,1,,TUBE\n,8.-3,7.-3\n" + bar, pipe_section(m, 7.5e-3, 1e-3));
  expect_beam("PBARL,9,1,,BAR\n,5.-3,12.-3\n" + bar, rectangle_section(m, 5e-3, 12e-3));
  // I1 bends in the plane of the orientation vector: about our y.
  BeamProperties p{.EA = m.E * 1e-4,
                   .EI_y = m.E * 3e-9,
                   .EI_z = m.E * 1e-9,
                   .GJ = G * 2.5e-9,
                   .GA_y = inf,
                   .GA_z = inf,
                   .mass = 8000 * 1e-4 + 0.2,
                   .inertia_x = 8000 * 4e-9,
                   .inertia_y = 8000 * 3e-9,
                   .inertia_z = 8000 * 1e-9};
  expect_beam("PBAR,9,1,1.-4,3.-9,1.-9,2.5-9,.2\n" + bar, p);
  const std::string by_grid = fmt::format("GRID,501,,1.3,.7,0.\nCBAR,930,9,{},500,501\n", corner);
  expect_beam("PBAR,9,1,1.-4,3.-9,1.-9,2.5-9,.2\n" + by_grid, p);
  p.GA_z = 0.8 * G * 1e-4;
  p.GA_y = 0.6 * G * 1e-4;
  expect_beam("PBAR,9,1,1.-4,3.-9,1.-9,2.5-9,.2\n,\n,.8,.6\n" + bar, p);
  const std::string beam = fmt::format("CBEAM,930,9,{},500,1.,.5,0.\n", corner);
  expect_beam("PBEAM,9,1,1.-4,3.-9,1.-9,,2.5-9,.2\n,\n,.8,.6\n" + beam, p);
  p.GA_z = p.GA_y = G * 1e-4; // by default 1
  expect_beam("PBEAM,9,1,1.-4,3.-9,1.-9,,2.5-9,.2\n" + beam, p);
  expect_beam("PBEAML,9,1,,BAR\n,5.-3,12.-3\n" + beam, rectangle_section(m, 5e-3, 12e-3));
  expect_beam("PBARL,9,1,,ROD\n,6.-3\n" +
                  fmt::format("CBAR,930,9,{},500,1.,.5,0.\n,,,.01,.0,.02\n", corner),
              round_section(m, 6e-3), {0.01, 0, 0.02});
}

TEST(NastranReader, lists_on_request_what_it_leaves_out) {
  const std::string text = plate() + clamped() + "PLOAD4,1,1,5.\nPARAM,LGDISP,1\nRSPLINE,9\n";
  EXPECT_THROW(read_text(text), InputError);
  const DeckModel deck = read_text(text, UnknownCards::list);
  ASSERT_EQ(deck.left_out.size(), 1U);
  EXPECT_NE(deck.left_out[0].find("RSPLINE is not had"), std::string::npos);
  ASSERT_EQ(deck.notes.size(), 2U);
  EXPECT_EQ(deck.notes[0], "passed over, since they change neither stiffness nor mass: PARAM");
  EXPECT_EQ(deck.notes[1], "loads, which act where the case says static: deck: PLOAD4");
}

} // namespace
} // namespace plica::test
