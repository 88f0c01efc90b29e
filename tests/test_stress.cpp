// Stress recovery and the measures read off it: patches, beams, von Mises over a cycle and RMS.
#include "tests/support/fields.hpp"
#include "tests/support/shell_cases.hpp"

#include "solve/stress.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <numbers>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// Displacements with the strains of the patch test of MacNeal & Harder (1985), membrane and bending
// together: 1333.33 -+ 0.6667 in both directions, 400 -+ 0.2 in shear, below and above.
TEST(ShellStress, of_the_patch_state_is_exact_on_both_faces_of_distorted_elements) {
  constexpr double E = 1e6, nu = 0.25, t = 0.001;
  const ParametricSurface sheet = [](double a, double b) { // skewed quads
    return SurfacePoint{{0.24 * a + 0.03 * b * (1 - a), 0.12 * b + 0.02 * a * b, 0}, {0, 0, 1}};
  };
  for (const auto& [name, membrane] : membranes) {
    const Model model =
        shell_model(mesh_surface(sheet, 3, 2, t), {.E = E, .nu = nu, .rho = 1}, membrane);
    VectorXd u(dof_count(model));
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
      const double x = model.mesh.nodes[n].x(), y = model.mesh.nodes[n].y();
      u.segment<6>(6 * Eigen::Index(n)) << x + y / 2, y + x / 2, (x * x + x * y + y * y) / 2,
          y + x / 2, -(x + y / 2), 0;
    }
    const StressField field = recover_stress(model, 1e-3 * u);
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
      for (int face : {0, 1}) {
        const double bending = face == 0 ? 1 : -1; // w,xx > 0 pulls below
        const Vector6 s = field.shell.middleRows<6>(12 * Eigen::Index(n) + 6 * face);
        EXPECT_NEAR(s[0], 4000. / 3 + bending * 2 / 3, 1e-6) << name;
        EXPECT_NEAR(s[1], 4000. / 3 + bending * 2 / 3, 1e-6) << name;
        EXPECT_NEAR(s[3], 400 + bending * 0.2, 1e-6) << name;
        EXPECT_NEAR(s[2], 0, 1e-6) << name;
      }
  }
}

// Curvature 1/m: a ply of two that slip sees E/(1-nu^2) k t_ply/2, half of the solid wall.
TEST(ShellStress, of_slipping_plies_is_that_of_the_bending_of_one_ply) {
  constexpr double E = 200e9, nu = 0.3, t = 0.0005;
  const ParametricSurface sheet = [](double a, double b) {
    return SurfacePoint{{0.01 * a, 0.01 * b, 0}, {0, 0, 1}};
  };
  const auto largest = [&](double factor) {
    const Model model = shell_model(mesh_surface(sheet, 2, 2, t),
                                    {.E = E, .nu = nu, .rho = 1, .bending_factor = factor});
    VectorXd u = no_force(model);
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
      const double x = model.mesh.nodes[n].x();
      u[6 * Eigen::Index(n) + 2] = x * x / 2;
      u[6 * Eigen::Index(n) + 4] = -x;
    }
    return recover_stress(model, u).shell.row(12 * 4).maxCoeff();
  };
  EXPECT_NEAR(largest(1) / (E / (1 - nu * nu) * t / 2), 1, 1e-9);
  EXPECT_NEAR(largest(0.25) / (E / (1 - nu * nu) * t / 4), 1, 1e-9);
}

// Tube under internal pressure: hoop stress p R / t away from the ends.
TEST(ShellStress, of_a_tube_under_pressure_is_the_membrane_stress) {
  constexpr double R = 0.1, t = 0.001, p = 1e5;
  const ParametricSurface tube = [=](double a, double b) {
    const double phi = pi / 2 * a;
    const Eigen::Vector3d n(std::cos(phi), 0, std::sin(phi));
    return SurfacePoint{R * n - 0.4 * b * Eigen::Vector3d::UnitY(), n};
  };
  Model model = shell_model(mesh_surface(tube, 24, 48, t), {.E = 200e9, .nu = 0.3, .rho = 1});
  hold_symmetry(model, "a0", 2);
  hold_symmetry(model, "a1", 0);
  hold(model, "b0", {1});
  VectorXd load = no_force(model);
  for (const ShellQuad& quad : model.mesh.quads)
    for (int i = 0; i < 4; ++i) // each element pushes along its own normal
      for (int k = 0; k < 3; ++k) {
        const auto g = shell_geometry(model.mesh, quad);
        const Eigen::Vector3d n = quad.directors.rowwise().mean().normalized();
        load[6 * quad.nodes[i] + k] += shell_mitc4_area_load(g, p * n)[6 * i + k];
      }
  const StressField field = recover_stress(model, solve_static(model, load));
  const int node = node_at(model.mesh, {0, -0.2, R});
  for (int face : {0, 1}) {
    const Vector6 s = field.shell.middleRows<6>(12 * node + 6 * face);
    expect_ratio(s[0], p * R / t, 0.01, "hoop");
    EXPECT_NEAR(s[1], 0, 0.01 * p * R / t);
  }
}

// Two plates at a right angle: a point for each side of the kink, the bending of one does not
// dilute the other.
TEST(ShellStress, of_a_kink_keeps_a_value_for_each_side) {
  Model model;
  model.mesh.nodes = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}};
  for (const bool upright : {false, true}) {
    ShellQuad quad{
        .nodes = {0, 2, 3, 1}, .directors = {}, .thickness = Eigen::Vector4d::Constant(0.01)};
    if (upright) quad.nodes = {2, 4, 5, 3};
    quad.directors.colwise() = upright ? Eigen::Vector3d(-1, 0, 0) : Eigen::Vector3d(0, 0, 1);
    model.mesh.quads.push_back(quad);
  }
  model.shells.push_back({{.E = 1e9, .nu = 0, .rho = 1}, MembraneStrain::displacement});
  VectorXd u = no_force(model);
  for (int node : {2, 3, 4, 5})
    u[6 * node] = 1e-3; // the flat plate is pulled, the other moves along
  const StressField field = recover_stress(model, u);
  EXPECT_EQ(field.node_of_point, (std::vector<int>{0, 1, 2, 2, 3, 3, 4, 5}));
  EXPECT_NEAR(field.shell(12 * 2, 0), 1e6, 1e-3);
  EXPECT_NEAR(field.shell.middleRows<12>(12 * 3).norm(), 0, 1e-3);
  const StressPeaks peaks = stress_peaks(
      field, 6, [](const auto& s) { return von_mises(s.col(0)); }, [](const auto&) { return 0.; });
  EXPECT_NEAR(peaks.above[2], 1e6, 1e-3) << "the larger side";
}

// Cantilever under a tip force: F (L - x) c / I at the ends of every element, exact.
TEST(BeamStress, of_a_cantilever_is_the_moment_over_the_section_modulus) {
  constexpr double L = 2, F = 1000, b = 0.04, h = 0.06;
  for (int elements : {1, 5}) {
    Model model;
    const BeamProperties section = rectangle_section({.E = 210e9, .nu = 0.3, .rho = 7800}, b, h);
    for (int i = 0; i <= elements; ++i) model.mesh.nodes.emplace_back(L * i / elements, 0, 0);
    for (int i = 0; i < elements; ++i)
      model.beams.push_back({.node1 = i, .node2 = i + 1, .section = section});
    add_support(model, {0}, all_dofs, "root");
    VectorXd load = no_force(model);
    load[6 * elements + 2] = F;
    load[6 * elements] = 500;
    const StressField field = recover_stress(model, solve_static(model, load));
    ASSERT_EQ(field.beam.rows(), 8 * elements); // four fibres at both ends
    for (Eigen::Index row = 0; row < field.beam.rows(); ++row) {
      const double x = model.mesh.nodes[field.node_of_row[row]].x();
      const double bending = F * (L - x) / (b * h * h / 6), pull = 500 / (b * h);
      const bool top = row % 4 < 2; // local z up: the first two fibres
      EXPECT_NEAR(field.beam(row, 0), pull + (top ? -bending : bending),
                  1e-6 * F * L / (b * h * h));
    }
  }
}

TEST(BeamStress, of_a_round_section_misses_less_than_one_percent_in_any_plane) {
  constexpr double r = 0.02, L = 1, F = 100;
  Model model;
  model.mesh.nodes = {{0, 0, 0}, {L, 0, 0}};
  const BeamProperties section = round_section({.E = 210e9, .nu = 0.3, .rho = 7800}, r);
  model.beams.push_back({.node1 = 0, .node2 = 1, .section = section});
  add_support(model, {0}, all_dofs, "root");
  for (double angle : {0., 0.1, pi / 24, 0.7}) {
    VectorXd load = no_force(model);
    load[7] = F * std::cos(angle);
    load[8] = F * std::sin(angle);
    const double largest =
        recover_stress(model, solve_static(model, load)).beam.cwiseAbs().maxCoeff();
    const double exact = F * L * 4 / (pi * r * r * r);
    EXPECT_LE(largest, exact * (1 + 1e-9));
    EXPECT_GE(largest, exact * 0.991);
  }
}

TEST(VonMises, is_the_textbook_number) {
  Vector6 uniaxial = Vector6::Zero(), shear = Vector6::Zero();
  uniaxial[1] = -3;
  shear[4] = 2;
  EXPECT_NEAR(von_mises(uniaxial), 3, 1e-14);
  EXPECT_NEAR(von_mises(shear), 2 * std::sqrt(3.), 1e-14);
  EXPECT_NEAR(von_mises(Vector6(5, 5, 5, 0, 0, 0)), 0, 1e-7);
}

TEST(VonMises, of_a_cycle_is_the_largest_over_all_phases) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const VectorXd numbers = random_vector(12, seed);
    Eigen::Matrix<std::complex<double>, 6, 1> s;
    s.real() = numbers.head<6>();
    s.imag() = numbers.tail<6>();
    double largest = 0;
    for (int k = 0; k < 3600; ++k) {
      const std::complex<double> turn = std::polar(1., 2 * pi * k / 3600);
      largest = std::max(largest, von_mises(Vector6((s * turn).real())));
    }
    EXPECT_NEAR(von_mises_of_cycle(s) / largest, 1, 2e-6) << seed;
  }
}

// Against the mean over drawn samples of the same covariance, 2 % for 20,000 samples.
TEST(VonMises, rms_is_that_of_drawn_samples) {
  const MatrixXd stress = random_vector(18, 5).reshaped(6, 3);
  const MatrixXd root = random_vector(9, 6).reshaped(3, 3);
  const MatrixXd C = root * root.transpose();
  double square = 0;
  constexpr int samples = 20000;
  for (int k = 0; k < samples; ++k) {
    const VectorXd uniform = std::sqrt(3.) * random_vector(3, 100 + unsigned(k)); // variance 1
    square += std::pow(von_mises(Vector6(stress * root * uniform)), 2) / samples;
  }
  EXPECT_NEAR(von_mises_rms(stress, C) / std::sqrt(square), 1, 0.02);
}

} // namespace
} // namespace plica::test
