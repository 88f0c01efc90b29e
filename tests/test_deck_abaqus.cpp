// Every keyword of an Abaqus deck that is followed: its frequencies are those of the same model put
// together by hand.
//
//   4 +------------------+ 3     plate 0.3 x 0.2 x 0.002, edge 4-1 (set ROOT) clamped
//     |                  |
//   1 +------------------+ 2     nodes and quads are written from the mesh, the rest is here
#include "tests/abaqus_plate.hpp"
#include "tests/support/triangulated.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace plica::test::abaqus {
namespace {

using Eigen::Vector3d;

TEST(AbaqusReader, node_element_section_material_boundary) {
  expect_plate("", [](Model&) {});
  std::string text = mesh_text(deck_plate()) + steel + section + clamped;
  text.replace(text.find("TYPE=S4,"), 8, "TYPE=S4R5,");
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(read_text(text), own);
}

TEST(AbaqusReader, reads_small_letters_comments_lines_that_go_on_and_steps) {
  std::string text = mesh_text(deck_plate());
  text += "** a comment\n*Material, name=Steel\n*Elastic, type=isotropic\n 2.E+11 ,0.3\n*Density\n"
          "8.D3,\n*Shell Section, elset=wall,\n  material = STEEL\n0.002\n*Step, perturbation\n"
          "*Frequency\n10\n*Boundary\nroot, 1, 6, 0.\n*Node File\nU\n*End Step\n";
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(read_text(text), own);
}

TEST(AbaqusReader, nset_elset_generate_and_include) {
  const TemporaryFolder folder("abaqus");
  const Mesh mesh = deck_plate();
  std::string nodes = nodes_text(mesh);
  nodes.erase(0, nodes.find('\n') + 1);
  write_whole(folder.path / "nodes.txt", nodes);
  write_whole(folder.path / "elements.inp", elements_text(mesh.quads, "S4R"));
  std::string root;
  for (int node : mesh.sets.at("edge4")) root += fmt::format("{},", node + 1);
  write_whole(folder.path / "model.inp",
              "*NODE\n*INCLUDE, INPUT=nodes.txt\n*INCLUDE, INPUT=elements.inp\n" +
                  fmt::format("*ELSET, ELSET=FIRST, GENERATE\n1, {}, 1\n", mesh.quads.size()) +
                  "*ELSET, ELSET=EVERY\nFIRST\n*NSET, NSET=ROOT\n" + root + "\n" + steel +
                  "*SHELL SECTION, ELSET=EVERY, MATERIAL=STEEL\n2.e-3\n" + clamped);
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(read_abaqus(folder.path / "model.inp", UnknownCards::error), own);
}

TEST(AbaqusReader, boundary_by_degrees_of_freedom_and_by_name) {
  const std::string text = mesh_text(deck_plate()) + steel + section;
  Model own = own_plate();
  hold(own, "edge4", {0, 1, 2, 4});
  hold(own, "edge2", {1, 3, 5});
  expect_same_frequencies(read_text(text + "*BOUNDARY\nROOT, 1, 3\nROOT, 5\nTIP, YSYMM\n"), own);
}

TEST(AbaqusReader, mass_and_rotary_inertia) {
  expect_plate(
      fmt::format("*ELEMENT, TYPE=MASS, ELSET=BALL\n901, {0}\n*MASS, ELSET=BALL\n0.25\n"
                  "*ELEMENT, TYPE=ROTARYI, ELSET=DISC\n902, {0}\n*ROTARY INERTIA, ELSET=DISC\n"
                  "2.e-4, 3.e-4, 4.e-4, 1.e-5, 2.e-5, 3.e-5\n",
                  corner),
      [](Model& own) {
        RigidMass body{.mass = 0.25};
        body.inertia << 2e-4, 1e-5, 2e-5, 1e-5, 3e-4, 3e-5, 2e-5, 3e-5, 4e-4;
        own.masses.push_back({corner - 1, body});
      });
}

const std::string body = "*NODE\n500, 0.34, 0.08, 0.03\n*ELEMENT, TYPE=MASS, ELSET=BALL\n901, 500\n"
                         "*MASS, ELSET=BALL\n0.4\n*ELEMENT, TYPE=ROTARYI, ELSET=DISC\n902, 500\n"
                         "*ROTARY INERTIA, ELSET=DISC\n1.e-4, 1.e-4, 2.e-4\n";
const std::string tip_surface = "*SURFACE, NAME=END, TYPE=NODE\nTIP\n";

TEST(AbaqusReader, kinematic_coupling) {
  const auto by_hand = [](Model& own) {
    const int node = add_body(own);
    add_kinematic_coupling(own, node, own.mesh.sets.at("edge2"), all_dofs, "spider");
  };
  expect_plate(body + tip_surface +
                   "*COUPLING, CONSTRAINT NAME=SPIDER, REF NODE=500, SURFACE=END\n*KINEMATIC\n",
               by_hand);
  expect_plate(body + "*KINEMATIC COUPLING, REF NODE=500\nTIP, 1, 6\n", by_hand);
  expect_plate(body + "*RIGID BODY, REF NODE=500, TIE NSET=TIP\n", by_hand);
  expect_plate(body + "*NSET, NSET=HUB\n500\n*MPC\nBEAM, TIP, HUB\n", by_hand);
}

// On nodes off one line: about that the body would turn freely.
TEST(AbaqusReader, kinematic_coupling_of_some_degrees_of_freedom) {
  const std::string pins = fmt::format("*NSET, NSET=PINS\nTIP, {}\n", middle);
  const auto by_hand = [](Model& own) {
    std::vector<int> nodes = own.mesh.sets.at("edge2");
    nodes.push_back(middle - 1);
    add_kinematic_coupling(own, add_body(own), nodes, {0, 1, 2}, "pins");
  };
  expect_plate(body + pins +
                   "*SURFACE, NAME=END, TYPE=NODE\nPINS\n*COUPLING, CONSTRAINT NAME=C, REF "
                   "NODE=500, SURFACE=END\n*KINEMATIC\n1, 3\n",
               by_hand);
  expect_plate(body + pins + "*RIGID BODY, REF NODE=500, PIN NSET=PINS\n", by_hand);
}

// Nodes alone count alike; those of a surface by the area that belongs to them.
TEST(AbaqusReader, distributing_coupling) {
  const std::string coupling =
      "*COUPLING, CONSTRAINT NAME=MEAN, REF NODE=500, SURFACE=END\n*DISTRIBUTING\n";
  const auto all = [](Model& own) { return own.mesh.sets.at("all"); };
  expect_plate(
      body + "*NSET, NSET=EVERY, ELSET=WALL\n*SURFACE, NAME=END, TYPE=NODE\nEVERY\n" + coupling,
      [&](Model& own) { add_distributing_coupling(own, add_body(own), all(own), "mean"); });
  const auto share = [](const Vector3d& x) {
    const bool side = x.x() < 1e-9 || x.x() > 0.3 - 1e-9, end = x.y() < 1e-9 || x.y() > 0.2 - 1e-9;
    return (side ? 0.5 : 1.) * (end ? 0.5 : 1.);
  };
  const auto weighted = [&](Model& own) {
    std::vector<double> weights;
    for (int node : all(own)) weights.push_back(share(own.mesh.nodes[node]));
    add_distributing_coupling(own, add_body(own), all(own), "mean", weights);
  };
  expect_plate(body + "*SURFACE, NAME=END, TYPE=ELEMENT\nWALL, SPOS\n" + coupling, weighted);
  std::string by_hand = "*ELEMENT, TYPE=DCOUP3D, ELSET=MEAN\n910, 500\n"
                        "*DISTRIBUTING COUPLING, ELSET=MEAN\n";
  const Mesh mesh = deck_plate();
  for (int node : mesh.sets.at("all"))
    by_hand += fmt::format("{}, {}\n", node + 1, share(mesh.nodes[node]));
  expect_plate(body + by_hand, weighted);
}

TEST(AbaqusReader, mpc_tie_and_pin) {
  const int other = number_at(0.3, 0.0);
  for (const auto& [word, dofs] : {std::pair{"TIE", all_dofs}, {"PIN", std::vector{0, 1, 2}}})
    expect_plate(fmt::format("*MPC\n{}, {}, {}\n", word, other, corner),
                 [&, tied = dofs](Model& own) {
                   for (int dof : tied)
                     own.constraints.push_back({other - 1, dof, {{corner - 1, dof, 1}}, "tie"});
                 });
}

TEST(AbaqusReader, equation) {
  expect_plate(
      fmt::format("*EQUATION\n3\n{}, 3, 2., {}, 3, -1.,\n{}, 5, 0.02\n", corner, middle, middle),
      [](Model& own) {
        own.constraints.push_back(
            {corner - 1, 2, {{middle - 1, 2, 0.5}, {middle - 1, 4, -0.01}}, "equation"});
      });
}

TEST(AbaqusReader, springs) {
  expect_plate(fmt::format("*ELEMENT, TYPE=SPRING1, ELSET=FOOT\n920, {}\n*SPRING, ELSET=FOOT\n3\n"
                           "2.e4\n*ELEMENT, TYPE=SPRING2, ELSET=LINK\n921, {}, {}\n"
                           "*SPRING, ELSET=LINK\n3, 5\n150.\n",
                           corner, corner, middle),
               [](Model& own) {
                 BushingElement foot{.node1 = corner - 1, .node2 = -1, .bushing = {}};
                 foot.bushing.law(2, 2) = 2e4;
                 own.bushings.push_back(foot);
                 Eigen::VectorXd b = Eigen::VectorXd::Zero(12);
                 b[2] = 1;
                 b[6 + 4] = -1;
                 own.matrices.push_back({.nodes = {corner - 1, middle - 1},
                                         .K = 150 * b * b.transpose(),
                                         .M = Eigen::MatrixXd::Zero(12, 12)});
               });
}

constexpr double inf = std::numeric_limits<double>::infinity();

// A beam from a corner of the plate, out of its plane and askew.
void expect_beam(const std::string& type, const std::string& keywords,
                 const BeamProperties& properties) {
  expect_plate(
      fmt::format("*NODE\n500, 0.35, 0.25, 0.4\n*ELEMENT, TYPE={}, ELSET=ROD\n930, {}, 500\n", type,
                  corner) +
          keywords,
      [&](Model& own) {
        const int tip = add_node(own, {0.35, 0.25, 0.4});
        BeamElement beam{.node1 = corner - 1, .node2 = tip, .section = properties};
        // n1 = x is the local y.
        beam.up = Vector3d(0.05, 0.05, 0.4).cross(Vector3d::UnitX());
        own.beams.push_back(beam);
      });
}

TEST(AbaqusReader, beam_sections) {
  const BeamMaterial m{2e11, 0.3, 8000};
  const std::string head = "*BEAM SECTION, ELSET=ROD, MATERIAL=STEEL, SECTION=";
  expect_beam("B31", head + "CIRC\n6.e-3\n1., 0., 0.\n", round_section(m, 6e-3));
  expect_beam("B31", head + "PIPE\n8.e-3, 1.e-3\n1., 0., 0.\n", pipe_section(m, 7.5e-3, 1e-3));
  expect_beam("B31", head + "RECT\n5.e-3, 12.e-3\n1., 0., 0.\n", rectangle_section(m, 5e-3, 12e-3));
  BeamProperties slender = rectangle_section(m, 5e-3, 12e-3);
  slender.GA_y = slender.GA_z = inf;
  expect_beam("B33", head + "RECT\n5.e-3, 12.e-3\n1., 0., 0.\n", slender);
  BeamProperties stiff = rectangle_section(m, 5e-3, 12e-3);
  stiff.GA_z = 3e6; // K23
  stiff.GA_y = 2e6;
  expect_beam("B31",
              head + "RECT\n5.e-3, 12.e-3\n1., 0., 0.\n*TRANSVERSE SHEAR STIFFNESS\n3.e6, 2.e6\n",
              stiff);
}

// I11 bends about the local 1, our y.
TEST(AbaqusReader, beam_general_section) {
  constexpr double E = 7e10, G = 2.5e10, A = 1e-4, I11 = 3e-9, I22 = 1e-9, J = 2.5e-9, rho = 2700;
  const BeamProperties p{.EA = E * A,
                         .EI_y = E * I11,
                         .EI_z = E * I22,
                         .GJ = G * J,
                         .GA_y = inf,
                         .GA_z = inf,
                         .mass = rho * A,
                         .inertia_x = rho * (I11 + I22),
                         .inertia_y = rho * I11,
                         .inertia_z = rho * I22};
  expect_beam("B31",
              "*BEAM GENERAL SECTION, ELSET=ROD, SECTION=GENERAL, DENSITY=2700.\n"
              "1.e-4, 3.e-9, 0., 1.e-9, 2.5e-9\n1., 0., 0.\n7.e10, 2.5e10\n",
              p);
  expect_beam("B31",
              "*BEAM GENERAL SECTION, ELSET=ROD, SECTION=RECT, DENSITY=8000., LUMPED=NO\n"
              "5.e-3, 12.e-3\n1., 0., 0.\n2.e11, 76923076923.0769\n",
              rectangle_section({2e11, 0.3, 8000}, 5e-3, 12e-3));
}

// As Abaqus/CAE writes a flat deck.
TEST(AbaqusReader, sets_in_quotes_internal_sets_and_boundaries_anew_in_a_step) {
  std::string text = mesh_text(deck_plate());
  text.replace(text.find("*NSET, NSET=ROOT"), 16, "*Nset, nset=\"Clamp set\", internal");
  text += steel + section +
          "*Boundary\nTIP, ENCASTRE\n*Step, name=Step-1\n*Frequency, eigensolver=Lanczos\n10\n"
          "*Boundary, op=NEW\n\"Clamp set\", 1, 3\n*Boundary, op=NEW\n\"Clamp set\", 4, 6\n"
          "*End Step\n";
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(read_text(text), own);
}

TEST(AbaqusReader, triangles) {
  for (const char* type : {"S3", "S3R"}) {
    std::string text = mesh_text(triangulated(deck_plate())) + steel + section + clamped;
    text.replace(text.find("TYPE=S3,"), 8, std::string("TYPE=") + type + ",");
    Model own = own_plate(triangulated(deck_plate()));
    hold(own, "edge4", all_dofs);
    expect_same_frequencies(read_text(text), own);
  }
}

TEST(AbaqusReader, lists_on_request_what_it_leaves_out) {
  const std::string text = mesh_text(deck_plate()) + steel + "*EXPANSION\n1.2e-5\n" + section +
                           clamped + "*ORIENTATION, NAME=O\n1, 0, 0, 0, 1, 0\n*PLASTIC\n1e8, 0\n" +
                           "*CONTACT PAIR\nA, B\n";
  EXPECT_THROW(read_text(text), InputError);
  const DeckModel deck = read_text(text, UnknownCards::list);
  ASSERT_EQ(deck.left_out.size(), 1U);
  EXPECT_NE(deck.left_out[0].find("*CONTACT PAIR is not had"), std::string::npos);
  ASSERT_EQ(deck.notes.size(), 3U);
  EXPECT_NE(deck.notes[0].find("taken as elastic"), std::string::npos);
  EXPECT_NE(deck.notes[1].find("*HEADING, *PLASTIC"), std::string::npos);
  EXPECT_NE(deck.notes[2].find("static: deck: *EXPANSION"), std::string::npos);
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(deck, own);
}

} // namespace
} // namespace plica::test::abaqus
