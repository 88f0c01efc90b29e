// Static obstacle course of shells, MITC4 with displacement membrane.
//
// Each problem: its source value on a fine mesh, and per mesh the values of an independent MITC4
// (degenerated shell, exact nodal normals, 2x2x2 Gauss, hardly any drilling stiffness), tolerance
// 0.2 %. Sources: Ko, Lee & Bathe, Comput. Struct. 182 (2017) 404-418; MacNeal & Harder, Finite
// Elem. Anal. Des. 1 (1985) 3-20; Bathe, Iosilevich & Chapelle, Comput. Struct. 75 (2000); Knight,
// AIAA J. 35 (1997) and Abaqus Benchmarks 2.3.6.
#include "tests/support/fields.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double per_mesh = 0.002;

ShellSection material(double E, double nu) {
  return {.E = E, .nu = nu, .rho = 1};
}

// Value at a displacement DOF of the node at a point.
double at(const Model& model, const VectorXd& u, const Vector3d& position, int dof) {
  return u[6 * node_at(model.mesh, position) + dof];
}

// A piece of a cylinder about y: a turns from the crown to the angle, b runs along y.
ParametricSurface cylinder(double radius, double angle, double length) {
  return [=](double a, double b) {
    const Vector3d n(std::sin(a * angle), 0, std::cos(a * angle));
    return SurfacePoint{radius * n + b * length * Vector3d::UnitY(), n};
  };
}

// Roof on two diaphragms under its weight: deflection of the middle of the free edge.
double scordelis_lo(int n) {
  const ParametricSurface roof = cylinder(25, 40 * pi / 180, 25);
  Model model = shell_model(mesh_surface(roof, n, n, 0.25), material(4.32e8, 0));
  hold_symmetry(model, "a0", 0);
  hold_symmetry(model, "b0", 1);
  hold(model, "b1", {0, 2});
  return -at(model, solve_static(model, area_load(model, {0, 0, -90})), roof(1, 0).position, 2);
}

TEST(ShellStatics, scordelis_lo_roof) {
  for (const auto& [n, value] : {std::pair{4, 0.9474}, {8, 0.9739}, {16, 0.9893}, {32, 0.9945}})
    expect_ratio(scordelis_lo(n) / 0.3024, value, per_mesh, std::to_string(n));
  expect_ratio(scordelis_lo(16), 0.3024, 0.02, "Ko et al. 2017");
}

// One octant between rigid diaphragms, a quarter of the load.
double pinched_cylinder(int n) {
  const ParametricSurface tube = cylinder(300, pi / 2, 300);
  Model model = shell_model(mesh_surface(tube, n, n, 3), material(3e6, 0.3));
  hold_symmetry(model, "a0", 0);
  hold_symmetry(model, "a1", 2);
  hold_symmetry(model, "b0", 1);
  hold(model, "b1", {0, 2});
  VectorXd force = no_force(model);
  const Vector3d top = tube(0, 0).position;
  force[6 * node_at(model.mesh, top) + 2] = -0.25;
  return -at(model, solve_static(model, force), top, 2);
}

TEST(ShellStatics, pinched_cylinder_with_diaphragms) {
  for (const auto& [n, value] : {std::pair{4, 0.3803}, {8, 0.7484}, {16, 0.9300}, {32, 0.9887}})
    expect_ratio(pinched_cylinder(n) / 1.8248e-5, value, per_mesh, std::to_string(n));
  expect_ratio(pinched_cylinder(32), 1.8248e-5, 0.02, "Ko et al. 2017");
}

// A quarter of the hemisphere with a hole of 18 degrees; +-1 on the two nodes of the equator.
double hemisphere(int n, double drilling = ShellSection{}.drilling) {
  const ParametricSurface sphere = [](double a, double b) {
    const double longitude = a * pi / 2, latitude = b * 72 * pi / 180;
    const Vector3d n_(std::cos(longitude) * std::cos(latitude),
                      std::sin(longitude) * std::cos(latitude), std::sin(latitude));
    return SurfacePoint{10 * n_, n_};
  };
  ShellSection section = material(6.825e7, 0.3);
  section.drilling = drilling;
  Model model = shell_model(mesh_surface(sphere, n, n, 0.04), section);
  hold_symmetry(model, "a0", 1);
  hold_symmetry(model, "a1", 0);
  const int out = node_at(model.mesh, {10, 0, 0}), in = node_at(model.mesh, {0, 10, 0});
  add_support(model, {out}, {2}, "height");
  VectorXd force = no_force(model);
  force[6 * out] = 1;
  force[6 * in + 1] = -1;
  return solve_static(model, force)[6 * out];
}

TEST(ShellStatics, hemisphere_with_hole) {
  for (const auto& [n, value] : {std::pair{4, 1.0483}, {8, 1.0077}, {16, 1.0012}, {32, 1.0036}})
    expect_ratio(hemisphere(n) / 0.0930, value, per_mesh, std::to_string(n));
  expect_ratio(hemisphere(16), 0.0940, 0.02, "MacNeal & Harder 1985");
}

// z = x2 - y2 clamped at x = -1/2, under its weight; the half y > 0.
struct Saddle {
  double deflection = 0; // of the middle of the free end
  double work = 0;       // F'u of the half = strain energy of the whole
};

Saddle hypar(int n, double thickness, double weight) {
  const ParametricSurface saddle = [](double a, double b) {
    const double x = a - 0.5, y = b / 2;
    return SurfacePoint{{x, y, x * x - y * y}, {-2 * x, 2 * y, 1}};
  };
  ShellSection section = material(2e11, 0.3);
  section.drilling = 1e-6; // 1e-4 costs 4 % where an element is 1250 times as long as thick
  Model model = shell_model(mesh_surface(saddle, n, n / 2, thickness), section);
  hold(model, "a0", all_dofs);
  hold_symmetry(model, "b0", 1);
  const VectorXd force = area_load(model, {0, 0, -weight}), u = solve_static(model, force);
  return {-at(model, u, saddle(1, 0).position, 2), force.dot(u)};
}

TEST(ShellStatics, clamped_hyperbolic_paraboloid) {
  struct Case {
    double thickness, weight, reference;
    std::array<double, 3> ratio; // N = 8, 16, 32
    double energy, energy_48;    // source, independent MITC4 with N = 48
  };
  for (const Case& c :
       {Case{1e-2, 80, 9.3355e-5, {0.9203, 0.9562, 0.9821}, 1.6790e-3, 1.6601e-3},
        Case{1e-3, 8, 6.3941e-3, {0.9570, 0.9504, 0.9707}, 1.1013e-2, 1.0795e-2},
        Case{1e-4, 0.8, 5.2988e-1, {1.0298, 0.9837, 0.9761}, 8.9867e-2, 8.8000e-2}}) {
    const std::string which = "t = " + std::to_string(c.thickness);
    for (int k = 0; k < 3; ++k)
      expect_ratio(hypar(8 << k, c.thickness, c.weight).deflection / c.reference, c.ratio[k],
                   per_mesh, which + ", N = " + std::to_string(8 << k));
    const Saddle fine = hypar(48, c.thickness, c.weight);
    expect_ratio(fine.deflection, c.reference, 0.03, which);
    expect_ratio(fine.work, c.energy, 0.03, which);
    expect_ratio(fine.work, c.energy_48, per_mesh, which);
  }
}

// Width direction turns from y at the root to z at the tip; unit load at the tip's centre.
double twisted_beam(int along, int across, double thickness, double load, int dof) {
  const ParametricSurface strip = [](double a, double b) {
    const double angle = pi / 2 * a, eta = 1.1 * (b - 0.5);
    const Vector3d width(0, std::cos(angle), std::sin(angle));
    const Vector3d turning(0, -std::sin(angle), std::cos(angle));
    const Vector3d x_a = 12 * Vector3d::UnitX() + eta * pi / 2 * turning;
    return SurfacePoint{12 * a * Vector3d::UnitX() + eta * width, x_a.cross(width)};
  };
  Model model = shell_model(mesh_surface(strip, along, across, thickness), material(29e6, 0.22));
  hold(model, "a0", all_dofs);
  VectorXd force = no_force(model);
  const Vector3d tip = strip(1, 0.5).position;
  force[6 * node_at(model.mesh, tip) + dof] = load;
  return at(model, solve_static(model, force), tip, dof);
}

TEST(ShellStatics, twisted_beam) {
  constexpr int in_plane = 2, out_of_plane = 1;
  expect_ratio(twisted_beam(12, 2, 0.32, 1, in_plane) / 5.424e-3, 0.9918, per_mesh, "in, 12x2");
  expect_ratio(twisted_beam(12, 2, 0.32, 1, out_of_plane) / 1.754e-3, 0.9206, per_mesh,
               "out, 12x2");
  expect_ratio(twisted_beam(24, 4, 0.32, 1, in_plane) / 5.424e-3, 0.9961, per_mesh, "in, 24x4");
  expect_ratio(twisted_beam(24, 4, 0.32, 1, out_of_plane) / 1.754e-3, 0.9745, per_mesh,
               "out, 24x4");
  // MacNeal & Harder 1985, 2 %.
  expect_ratio(twisted_beam(48, 8, 0.32, 1, in_plane), 5.424e-3, 0.02, "in");
  expect_ratio(twisted_beam(48, 8, 0.32, 1, out_of_plane), 1.754e-3, 0.02, "out");
}

TEST(ShellStatics, thin_twisted_beam) {
  constexpr int in_plane = 2, out_of_plane = 1;
  constexpr double t = 0.0032, P = 1e-6;
  expect_ratio(twisted_beam(12, 2, t, P, in_plane) / 5.256e-3, 0.9812, per_mesh, "in, 12x2");
  expect_ratio(twisted_beam(12, 2, t, P, out_of_plane) / 1.294e-3, 0.9763, per_mesh, "out, 12x2");
  expect_ratio(twisted_beam(24, 4, t, P, in_plane) / 5.256e-3, 0.9918, per_mesh, "in, 24x4");
  expect_ratio(twisted_beam(24, 4, t, P, out_of_plane) / 1.294e-3, 0.9929, per_mesh, "out, 24x4");
}

// Two arcs with one tangent, equal elements along the arc length; the tip is sheared sideways.
double raasch_hook(int along, int across, double nu, double drilling = ShellSection{}.drilling) {
  constexpr double R1 = 14, R2 = 46, turn1 = pi / 3, turn2 = 5 * pi / 6;
  const int first = static_cast<int>(
      std::lround(along * R1 * turn1 / (R1 * turn1 + R2 * turn2))); // elements on the small arc
  const Vector3d centre2 = (R1 + R2) * Vector3d(std::sin(turn1), 0, std::cos(turn1));
  const ParametricSurface hook = [&](double a, double b) {
    const double i = a * along;
    const bool small = i <= first;
    const double angle = small ? turn1 * i / first : turn1 - turn2 * (i - first) / (along - first);
    const Vector3d n(std::sin(angle), 0, std::cos(angle));
    const Vector3d x = small ? Vector3d(R1 * n) : Vector3d(centre2 - R2 * n);
    return SurfacePoint{x + 20 * b * Vector3d::UnitY(), n};
  };
  ShellSection section = material(3300, nu);
  section.drilling = drilling;
  Model model = shell_model(mesh_surface(hook, along, across, 2), section);
  hold(model, "a0", all_dofs);
  VectorXd force = no_force(model);
  add_edge_force(model, "a1", 1, 1, force);
  return solve_static(model, force)[6 * model.mesh.sets["a1"][0] + 1];
}

TEST(ShellStatics, raasch_hook) {
  expect_ratio(raasch_hook(9, 1, 0.35), 4.858, per_mesh, "9x1");
  expect_ratio(raasch_hook(18, 3, 0.35), 4.850, per_mesh, "18x3");
  expect_ratio(raasch_hook(36, 5, 0.35), 4.872, per_mesh, "36x5");
  expect_ratio(raasch_hook(72, 10, 0.35), 4.945, per_mesh, "72x10");
  expect_ratio(raasch_hook(144, 20, 0.35), 4.998, per_mesh, "144x20");
  expect_ratio(raasch_hook(72, 10, 0.3), 4.775, per_mesh, "nu = 0.3");
  expect_ratio(raasch_hook(72, 10, 0.35), 5.02, 0.03, "Abaqus C3D20R"); // 3-D reference
}

TEST(ShellStatics, drilling_penalty_does_not_matter_on_curved_shells) {
  const double sphere = hemisphere(8), hook = raasch_hook(18, 3, 0.35);
  for (double drilling : {1e-6, 1e-5, 1e-3}) {
    expect_ratio(hemisphere(8, drilling), sphere, per_mesh, "hemisphere");
    expect_ratio(raasch_hook(18, 3, 0.35, drilling), hook, per_mesh, "hook");
  }
}

} // namespace
