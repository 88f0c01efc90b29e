// Walls of an Abaqus deck beside their nodes, of varying thickness, with normals given or averaged.
#include "tests/abaqus_plate.hpp"

#include <algorithm>
#include <cmath>

namespace plica::test::abaqus {
namespace {

using Eigen::Vector3d;

// A wall beside its nodes is the wall beside the clamp of these nodes: nothing else changes.
TEST(AbaqusReader, offset_of_a_wall) {
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  for (const char* offset : {"SPOS", "SNEG", "0.25"})
    expect_same_frequencies(read_text(mesh_text(deck_plate()) + steel +
                                      "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL, OFFSET=" +
                                      offset + "\n2.e-3\n" + clamped),
                            own);
  const Model wall = place(read_text(mesh_text(deck_plate()) + steel +
                                     "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL, OFFSET=SPOS\n"
                                     "2.e-3\n" +
                                     clamped),
                           {});
  for (const ShellQuad& quad : wall.mesh.quads) // the nodes are on its top
    EXPECT_NEAR(wall.mesh.nodes[quad.nodes[0]].z(), -1e-3, 1e-12);
}

TEST(AbaqusReader, nodal_thickness) {
  std::string text = mesh_text(deck_plate()) + steel +
                     "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL, NODAL THICKNESS\n2.e-3\n"
                     "*NODAL THICKNESS\n" +
                     clamped;
  const Mesh mesh = deck_plate();
  const auto thickness = [](const Vector3d& x) { return 2e-3 - 3e-3 * x.x(); };
  std::string lines;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    lines += fmt::format("{}, {:.17g}\n", i + 1, thickness(mesh.nodes[i]));
  text.insert(text.find(clamped), lines);
  Model own = own_plate();
  for (ShellQuad& quad : own.mesh.quads)
    for (int a = 0; a < 4; ++a) quad.thickness[a] = thickness(own.mesh.nodes[quad.nodes[a]]);
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(read_text(text), own);
}

// The middle of eight nodes, which no deck names, is as thick as they make it.
TEST(AbaqusReader, nodal_thickness_of_eight_nodes) {
  const std::string nodes =
      "*NODE\n1, 0, 0\n2, .2, 0\n3, .2, .1\n4, 0, .1\n5, .1, 0\n6, .2, .05\n"
      "7, .1, .1\n8, 0, .05\n*NSET, NSET=N, GENERATE\n1, 8\n*ELEMENT, TYPE=S8R, "
      "ELSET=WALL\n1, 1, 2, 3, 4, 5, 6, 7, 8\n" +
      steel + "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL";
  const std::string held = "*BOUNDARY\n1, 1, 6\n4, 1, 6\n8, 1, 6\n";
  const auto thickest = [&](const std::string& rest) {
    const Mesh mesh = place(read_text(nodes + rest + held), {}).mesh;
    double t = 0, middle = 0;
    for (const ShellQuad& quad : mesh.quads)
      for (int a = 0; a < 4; ++a) {
        t = std::max(t, quad.thickness[a]);
        if ((mesh.nodes[quad.nodes[a]] - Vector3d(0.1, 0.05, 0)).norm() < 1e-9)
          middle = quad.thickness[a];
      }
    return std::pair{t, middle};
  };
  const auto alike = thickest(", NODAL THICKNESS\n2.e-3\n*NODAL THICKNESS\nN, 3.e-3\n");
  EXPECT_NEAR(alike.first, 3e-3, 1e-15);
  EXPECT_NEAR(alike.second, 3e-3, 1e-15);
  const auto tapered = thickest(", NODAL THICKNESS\n2.e-3\n*NODAL THICKNESS\nN, 3.e-3\n2, 5.e-3\n"
                                "3, 5.e-3\n6, 5.e-3\n5, 4.e-3\n7, 4.e-3\n");
  EXPECT_NEAR(tapered.first, 5e-3, 1e-15);
  EXPECT_NEAR(tapered.second, 4e-3, 1e-15);
}

// A quarter of a cylinder.
Mesh shell() {
  Mesh mesh = mesh_surface(
      [](double a, double b) {
        const Vector3d n(std::sin(1.5 * a), 0, std::cos(1.5 * a));
        return SurfacePoint{0.1 * n + 0.2 * b * Vector3d::UnitY(), n};
      },
      6, 4, 1e-3);
  mesh.sets["edge4"] = mesh.sets["a0"];
  mesh.sets["edge2"] = mesh.sets["a1"];
  return mesh;
}

const std::string thin = "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL\n1.e-3\n";

TEST(AbaqusReader, normals_that_are_given) {
  const Mesh mesh = shell();
  std::string normals = "*NORMAL, TYPE=ELEMENT\n";
  for (std::size_t e = 0; e < mesh.quads.size(); ++e)
    for (int a = 0; a < 4; ++a) {
      const Vector3d n = mesh.quads[e].directors.col(a);
      normals += fmt::format("{}, {}, {:.17g}, {:.17g}, {:.17g}\n", e + 1,
                             mesh.quads[e].nodes[a] + 1, n.x(), n.y(), n.z());
    }
  Model own = own_plate(mesh);
  hold(own, "edge4", all_dofs);
  expect_same_frequencies(read_text(mesh_text(mesh) + steel + thin + normals + clamped), own);
}

// Facets that meet at 14 degrees share a normal, at 23 degrees each keeps its own.
TEST(AbaqusReader, normals_are_averaged_below_20_degrees) {
  for (const auto& [turn, shared] : {std::pair{14., true}, {23., false}}) {
    const double angle = turn * M_PI / 180;
    const std::string text =
        fmt::format("*NODE\n1, 0, 0, 0\n2, 0, 1, 0\n3, 1, 0, 0\n4, 1, 1, 0\n5, {0:.17g}, 0, "
                    "{1:.17g}\n6, {0:.17g}, 1, {1:.17g}\n*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, 3, "
                    "4, 2\n2, 3, 5, 6, 4\n",
                    1 + std::cos(angle), std::sin(angle)) +
        steel + section;
    const Mesh mesh = place(read_text(text), {}).mesh;
    const double between =
        std::acos(std::min(1., mesh.quads[0].directors.col(1).dot(mesh.quads[1].directors.col(0))));
    EXPECT_NEAR(between, shared ? 0 : angle, 1e-7);
  }
}

} // namespace
} // namespace plica::test::abaqus
