// Static tests of flat shells: Cook's membrane, plates, the curved beam of MacNeal & Harder.
#include "mesh/plate.hpp"
#include "tests/support/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double per_mesh = 0.005; // against an independent MITC4

// Cook's skew membrane, sheared by a unit force: height of the middle of the loaded edge.
double cook(int n, MembraneStrain membrane) {
  Model model =
      shell_model(mesh_plate({Vector3d(0, 0, 0), {48, 44, 0}, {48, 60, 0}, {0, 44, 0}}, n, n, 1),
                  {.E = 1, .nu = 1. / 3}, membrane);
  hold(model, "edge4", all_dofs);
  hold(model, "all", {2, 3, 4});
  VectorXd force = no_force(model);
  add_edge_force(model, "edge2", 1, 1, force);
  return solve_static(model, force)[6 * node_at(model.mesh, {48, 52, 0}) + 1];
}

TEST(PlateStatics, cook_membrane) {
  using enum MembraneStrain;
  for (const auto& [n, value] : {std::pair{4, 18.30}, {8, 22.08}, {16, 23.43}})
    expect_ratio(cook(n, displacement), value, per_mesh, std::to_string(n));
  // Simo & Rifai 1990: 23.91 to 23.96. The bilinear membrane within 2 % at 16, two ends apart.
  expect_ratio(cook(16, displacement), 23.91, 0.0205, "displacement");
  expect_ratio(cook(16, incompatible), 23.935, 0.005, "incompatible");
  expect_ratio(cook(8, incompatible), 23.935, 0.02, "incompatible");
}

// A quarter of a square plate of side 1 under unit pressure: centre deflection times D.
double square_plate(int n, bool clamped) {
  constexpr double E = 1e4, nu = 0.3, t = 1e-3;
  Model model =
      shell_model(mesh_plate({Vector3d(0, 0, 0), {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}}, n, n, t),
                  {.E = E, .nu = nu});
  hold_symmetry(model, "edge4", 0);
  hold_symmetry(model, "edge1", 1);
  for (const char* edge : {"edge2", "edge3"})
    hold(model, edge, clamped ? all_dofs : std::vector{0, 1, 2});
  const VectorXd u = solve_static(model, area_load(model, {0, 0, -1}));
  return -u[2] * E * t * t * t / (12 * (1 - nu * nu));
}

// Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, art. 30 and 44. 1 % at 8x8.
TEST(PlateStatics, clamped_square_plate_at_order_two) {
  constexpr double exact = 1.26532e-3;
  const std::array value{square_plate(4, true), square_plate(8, true), square_plate(16, true)};
  expect_ratio(value[0] / exact, 0.9885, per_mesh, "4");
  expect_ratio(value[1] / exact, 0.9971, per_mesh, "8");
  expect_ratio(value[2] / exact, 0.9993, per_mesh, "16");
  expect_ratio(value[1], exact, 0.01, "source");
  EXPECT_NEAR(observed_order(value[0], value[1], value[2]), 2, 0.1);
}

TEST(PlateStatics, supported_square_plate_at_order_two) {
  constexpr double exact = 4.06235e-3;
  const std::array value{square_plate(4, false), square_plate(8, false), square_plate(16, false)};
  expect_ratio(value[0] / exact, 0.9949, per_mesh, "4");
  expect_ratio(value[1] / exact, 0.9988, per_mesh, "8");
  expect_ratio(value[2] / exact, 0.9997, per_mesh, "16");
  expect_ratio(value[1], exact, 0.01, "source");
  EXPECT_NEAR(observed_order(value[0], value[1], value[2]), 2, 0.15);
}

// A quarter of a disc of radius 1 in three blocks round (c, c), n x n elements each:
//
//   D---E          O = (0, 0), A = (c, 0), C = (c, c), D = (0, c); B on the x axis,
//   |  / \         E on the arc at 45 degrees, F on the y axis
Mesh quarter_disc(int n, double thickness) {
  constexpr double c = 0.5;
  const Vector3d diagonal(std::sqrt(0.5), std::sqrt(0.5), 0);
  const auto blend = [](const Vector3d& inner, double angle, double a) {
    const Vector3d arc(std::cos(angle), std::sin(angle), 0);
    return SurfacePoint{(1 - a) * inner + a * arc, Vector3d::UnitZ()};
  };
  const std::array<ParametricSurface, 3> blocks{
      [&](double a, double b) {
        return SurfacePoint{{c * a, c * b, 0}, Vector3d::UnitZ()};
      },
      [&](double a, double b) {
        return blend({c, c * b, 0}, b * pi / 4, a);
      },
      [&](double a, double b) {
        return blend({c - c * b, c, 0}, (1 + b) * pi / 4, a);
      }};
  Mesh mesh;
  for (const ParametricSurface& block : blocks) {
    const Mesh part = mesh_surface(block, n, n, thickness);
    std::vector<int> number;
    for (const Vector3d& x : part.nodes) {
      const auto same = [&](const Vector3d& y) { return (x - y).norm() < 1e-9; };
      const auto found = std::find_if(mesh.nodes.begin(), mesh.nodes.end(), same);
      number.push_back(static_cast<int>(found - mesh.nodes.begin()));
      if (found == mesh.nodes.end()) mesh.nodes.push_back(x);
    }
    for (ShellQuad quad : part.quads) {
      for (int& node : quad.nodes) node = number[node];
      mesh.quads.push_back(quad);
    }
  }
  for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
    const Vector3d& x = mesh.nodes[i];
    if (x.x() < 1e-9) mesh.sets["x0"].push_back(i);
    if (x.y() < 1e-9) mesh.sets["y0"].push_back(i);
    if (x.norm() > 1 - 1e-9) mesh.sets["rim"].push_back(i);
  }
  return mesh;
}

// Deflection of the centre of a disc under unit pressure, times D.
double disc(int n, bool clamped) {
  constexpr double E = 1e4, nu = 0.3, t = 1e-3;
  Model model = shell_model(quarter_disc(n, t), {.E = E, .nu = nu});
  hold_symmetry(model, "x0", 0);
  hold_symmetry(model, "y0", 1);
  hold(model, "rim", clamped ? all_dofs : std::vector{2});
  const VectorXd u = solve_static(model, area_load(model, {0, 0, -1}));
  return -u[2] * E * t * t * t / (12 * (1 - nu * nu));
}

// 1/64 and (5 + nu)/(64 (1 + nu)): Timoshenko & Woinowsky-Krieger, art. 16. 1 % at N = 16.
TEST(PlateStatics, circular_plate_at_order_two) {
  expect_ratio(disc(16, true), 1. / 64, 0.01, "clamped");
  expect_ratio(disc(16, false), 5.3 / (64 * 1.3), 0.01, "supported");
  EXPECT_NEAR(observed_order(disc(4, true), disc(8, true), disc(16, true)), 2, 0.2);
}

// A quarter ring, 4.12 to 4.32, clamped at one end, unit tip shear: displacement of the tip.
double curved_beam(int along, int across, int dof, MembraneStrain membrane) {
  const ParametricSurface ring = [](double a, double b) {
    const double angle = a * pi / 2, radius = 4.32 - 0.2 * b;
    return SurfacePoint{radius * Vector3d(std::cos(angle), std::sin(angle), 0), Vector3d::UnitZ()};
  };
  Model model =
      shell_model(mesh_surface(ring, along, across, 0.1), {.E = 1e7, .nu = 0.25}, membrane);
  hold(model, "a0", all_dofs);
  VectorXd force = no_force(model);
  add_edge_force(model, "a1", dof, 1, force);
  return solve_static(model, force)[6 * model.mesh.sets["a1"][0] + dof];
}

// MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20: 0.08734 in plane (thin-ring theory
// 0.0885), 0.5022 out of plane; 5 %. The bilinear membrane needs a fine mesh in plane.
TEST(PlateStatics, curved_beam) {
  constexpr int in_plane = 1, out_of_plane = 2;
  using enum MembraneStrain;
  for (int along : {12, 24, 48})
    expect_ratio(curved_beam(along, 1, in_plane, incompatible), 0.08734, 0.05, "incompatible");
  expect_ratio(curved_beam(96, 8, in_plane, displacement), 0.08734, 0.05, "displacement");
  for (int along : {6, 24, 48})
    for (MembraneStrain membrane : {displacement, mitc4_plus, incompatible})
      expect_ratio(curved_beam(along, 1, out_of_plane, membrane), 0.5022, 0.05, "out of plane");
}

} // namespace
