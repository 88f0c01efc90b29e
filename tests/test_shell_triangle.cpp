// MITC3+: patches, isotropy, plates and shells against closed forms and published values.
#include "mesh/plate.hpp"
#include "solve/stress.hpp"
#include "tests/support/patch.hpp"
#include "tests/support/shell_cases.hpp"
#include "tests/support/triangulated.hpp"
#include "words/directions.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

const ShellSection steel{.E = 2e11, .nu = 0.3, .rho = 8000};

// The first three corners of the shapes that MITC4 is tested on.
std::vector<TriangleGeometry> shapes() {
  std::vector<TriangleGeometry> all;
  for (const auto& [name, g] : all_shells())
    all.push_back({g.X.leftCols<3>(), g.directors.leftCols<3>(), g.thickness.head<3>()});
  return all;
}

// Whichever corner is the first, the element is the same.
TEST(ShellTriangle, does_not_know_its_first_corner) {
  for (const TriangleGeometry& g : shapes()) {
    TriangleGeometry turned;
    Eigen::PermutationMatrix<18> P;
    for (int i = 0; i < 3; ++i) {
      const int from = (i + 1) % 3;
      turned.X.col(i) = g.X.col(from);
      turned.directors.col(i) = g.directors.col(from);
      turned.thickness[i] = g.thickness[from];
      for (int d = 0; d < 6; ++d) P.indices()[6 * i + d] = 6 * from + d;
    }
    const Matrix18 K = shell_mitc3_stiffness(g, steel), M = shell_mitc3_mass(g, steel);
    EXPECT_LE((P * shell_mitc3_stiffness(turned, steel) * P.transpose() - K).norm(),
              1e-9 * K.norm());
    EXPECT_LE((P * shell_mitc3_mass(turned, steel) * P.transpose() - M).norm(), 1e-12 * M.norm());
  }
}

// MacNeal & Harder's patch, each of its quads in two.
Model patch() {
  return shell_model(triangulated(patch_mesh(t)), {.E = E, .nu = nu, .rho = 1});
}

// The boundary follows the field; the inner nodes find it by themselves.
void expect_patch(const Field& field) {
  const Model model = patch();
  const MatrixXd K = dense(assemble(model).K);
  const VectorXd wanted = nodal_values(model.mesh, field);
  VectorXd u = wanted;
  u.tail(24) = -K.bottomRightCorner(24, 24).ldlt().solve(K.bottomLeftCorner(24, 24) * u.head(24));
  for (int d = 0; d < 6; ++d) {
    const VectorXd difference = (u - wanted).reshaped(6, 8).row(d);
    const double size = VectorXd(wanted.reshaped(6, 8).row(d)).norm();
    EXPECT_LE(difference.norm(), 1e-9 * (size > 0 ? size
                                         : d < 3  ? 1e-3 * 0.24
                                                  : 1e-3))
        << dof_name(d);
  }
}

TEST(ShellTriangle, passes_membrane_patch) {
  expect_patch([](double x, double y) {
    return NodeMotion(1e-3 * NodeMotion(x + y / 2, y + x / 2, 0, 0, 0, 0));
  });
}

TEST(ShellTriangle, passes_bending_patch) {
  expect_patch([](double x, double y) {
    return NodeMotion(1e-3 *
                      NodeMotion(0, 0, (x * x + x * y + y * y) / 2, y + x / 2, -(x + y / 2), 0));
  });
}

// A stubby cantilever under a force at its end, nu = 0: P L^3 / 3EI + P L / kGA, three quarters of
// it bending.
TEST(ShellTriangle, shears_and_bends_as_timoshenko_says) {
  constexpr double L = 1, b = 0.5, h = 0.6, modulus = 1e7;
  Model model = shell_model(
      triangulated(mesh_plate({Vector3d(0, 0, 0), {L, 0, 0}, {L, b, 0}, {0, b, 0}}, 24, 12, h)),
      {.E = modulus, .nu = 0});
  hold(model, "edge4", all_dofs);
  VectorXd force = no_force(model);
  add_edge_force(model, "edge2", 2, 1, force);
  const double tip = solve_static(model, force)[6 * node_at(model.mesh, {L, b / 2, 0}) + 2];
  const double wanted =
      L * L * L / (3 * modulus * b * h * h * h / 12) + L / (5. / 6 * modulus / 2 * b * h);
  expect_ratio(tip, wanted, 0.002, "tip");
}

// A uniform load on triangles: a third of each at its corners.
VectorXd area_load(const Model& model, const Vector3d& load) {
  VectorXd force = no_force(model);
  for (const ShellTriangle& triangle : model.mesh.triangles) {
    const Eigen::Matrix3d X = shell_geometry(model.mesh, triangle).X;
    const double area =
        Vector3d(X.col(1) - X.col(0)).cross(Vector3d(X.col(2) - X.col(0))).norm() / 2;
    for (int node : triangle.nodes) force.segment<3>(6 * node) += area / 3 * load;
  }
  return force;
}

// A quarter of a square plate of side 1, t = 1/1000: centre deflection times D.
double square_plate(int n, bool clamped) {
  constexpr double modulus = 1e4, poisson = 0.3, thin = 1e-3;
  Model model =
      shell_model(triangulated(mesh_plate(
                      {Vector3d(0, 0, 0), {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}}, n, n, thin)),
                  {.E = modulus, .nu = poisson});
  hold_symmetry(model, "edge4", 0);
  hold_symmetry(model, "edge1", 1);
  for (const char* edge : {"edge2", "edge3"})
    hold(model, edge, clamped ? all_dofs : std::vector{0, 1, 2});
  const VectorXd u = solve_static(model, area_load(model, {0, 0, -1}));
  return -u[2] * modulus * thin * thin * thin / (12 * (1 - poisson * poisson));
}

// Timoshenko & Woinowsky-Krieger, art. 30 and 44; thin, so that shear would lock.
TEST(ShellTriangle, square_plates_converge) {
  for (const auto& [clamped, exact] : {std::pair{true, 1.26532e-3}, {false, 4.06235e-3}}) {
    const double error8 = square_plate(8, clamped) / exact - 1;
    const double error16 = square_plate(16, clamped) / exact - 1;
    const double error32 = square_plate(32, clamped) / exact - 1;
    std::printf("| MITC3+ plate, %s | %+.2f %% at 8 | %+.2f %% at 16 | %+.2f %% at 32 |\n",
                clamped ? "clamped" : "supported", 100 * error8, 100 * error16, 100 * error32);
    EXPECT_LE(std::abs(error8), 0.03);
    EXPECT_LE(std::abs(error16), 0.01);
    if (!clamped) continue; // its error changes its sign
    EXPECT_NEAR(std::log2(error8 / error16), 2, 0.4);
  }
}

// Roof on two diaphragms under its weight, 0.3024 (Ko, Lee & Bathe 2017; test_shell_statics.cpp).
double scordelis_lo_of_triangles(int n) {
  const ParametricSurface roof = [](double a, double b) {
    const Vector3d normal(std::sin(a * 40 * pi / 180), 0, std::cos(a * 40 * pi / 180));
    return SurfacePoint{25 * normal + b * 25 * Vector3d::UnitY(), normal};
  };
  Model model =
      shell_model(triangulated(mesh_surface(roof, n, n, 0.25)), {.E = 4.32e8, .nu = 0, .rho = 1});
  hold_symmetry(model, "a0", 0);
  hold_symmetry(model, "b0", 1);
  hold(model, "b1", {0, 2});
  const VectorXd u = solve_static(model, area_load(model, {0, 0, -90}));
  return -u[6 * node_at(model.mesh, roof(1, 0).position) + 2];
}

TEST(ShellTriangle, scordelis_lo_roof) {
  const double coarse = scordelis_lo_of_triangles(16) / 0.3024,
               fine = scordelis_lo_of_triangles(32) / 0.3024;
  std::printf("| MITC3+ Scordelis-Lo | %.4f at 16 | %.4f at 32 |\n", coarse, fine);
  EXPECT_NEAR(coarse, 1, 0.05);
  EXPECT_NEAR(fine, 1, 0.02);
}

// A strip under pure bending: sigma = +-6 m / t^2 on its faces, m per width.
TEST(ShellTriangle, recovers_the_stress_of_pure_bending) {
  constexpr double length = 1, width = 0.2, thickness = 0.01, moment = 3;
  Model model =
      shell_model(triangulated(mesh_plate(
                      {Vector3d(0, 0, 0), {length, 0, 0}, {length, width, 0}, {0, width, 0}}, 10, 2,
                      thickness)),
                  {.E = 2e11, .nu = 0, .rho = 1});
  hold(model, "edge4", {0, 2, 4});
  hold(model, "corner1", {1});
  VectorXd force = no_force(model);
  add_edge_force(model, "edge2", 4, moment * width, force);
  const StressField field = recover_stress(model, solve_static(model, force));
  const double wanted = 6 * moment / (thickness * thickness);
  ASSERT_FALSE(field.node_of_point.empty());
  for (std::size_t p = 0; p < field.node_of_point.size(); ++p)
    for (int face : {0, 1})
      EXPECT_NEAR(std::abs(field.shell(12 * Eigen::Index(p) + 6 * face, 0)), wanted, 1e-6 * wanted);
}

// A cantilever plate as quads and as triangles: their frequencies meet.
TEST(ShellTriangle, vibrates_as_quads_do) {
  const auto plate = [](int n) {
    return mesh_plate({Vector3d(0, 0, 0), {0.3, 0, 0}, {0.3, 0.2, 0}, {0, 0.2, 0}}, 3 * n, 2 * n,
                      2e-3);
  };
  const auto hertz = [](Mesh mesh) {
    Model model = shell_model(std::move(mesh), steel);
    hold(model, "edge4", all_dofs);
    return test::find_modes(model, 6).hertz;
  };
  const VectorXd quads = hertz(plate(10)), triangles = hertz(triangulated(plate(10)));
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(triangles[i] / quads[i], 1, 0.01) << i;
}

} // namespace
