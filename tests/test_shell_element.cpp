// MITC4 by itself: energy against an integration of its own, the drilling tie, the membranes.
#include "tests/support/shell_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

const ShellSection steel{.E = 2e11, .nu = 0.3, .rho = 8000};

// Gauss points of one direction.
std::vector<std::pair<double, double>> gauss(int points) {
  if (points == 2) return {{-std::sqrt(1. / 3), 1}, {std::sqrt(1. / 3), 1}};
  return {{-std::sqrt(0.6), 5. / 9}, {0, 8. / 9}, {std::sqrt(0.6), 5. / 9}};
}

double strain_energy(const ShellGeometry& g, const ShellSection& section, MembraneStrain membrane,
                     const VectorXd& u, int points) {
  const ShellLaw law = shell_law(section);
  double energy = 0;
  for (const auto& [r, wr] : gauss(points))
    for (const auto& [s, ws] : gauss(points))
      for (const auto& [zeta, wz] : gauss(points)) {
        const double t = (g.thickness[0] * (1 - r) * (1 - s) + g.thickness[1] * (1 + r) * (1 - s) +
                          g.thickness[2] * (1 + r) * (1 + s) + g.thickness[3] * (1 - r) * (1 + s)) /
                         4;
        const double z = zeta * std::sqrt(section.bending_factor) * t / 2;
        const ShellStrainMatrix B = shell_mitc4_strain(g, section, membrane, r, s, z);
        const Vector3d eps = B.in_plane * u;
        const Eigen::Vector2d gamma = B.shear * u;
        energy += wr * ws * wz * t / 2 * B.volume *
                  (eps.dot(law.in_plane * eps) + gamma.dot(law.shear * gamma)) / 2;
      }
  return energy;
}

TEST(ShellEnergy, quadratic_form_equals_integrated_strain_energy) {
  ShellSection section = steel;
  section.drilling = 0; // its penalty is no strain
  for (const auto& [name, g] : all_shells())
    for (const auto& [membrane_name, membrane] : membranes)
      for (double factor : {1., 0.25})
        for (unsigned seed : {1, 2, 3}) {
          section.bending_factor = factor;
          const VectorXd u = random_vector(24, seed);
          const double half = u.dot(shell_mitc4_stiffness(g, section, membrane) * u) / 2;
          EXPECT_NEAR(strain_energy(g, section, membrane, u, 2), half, 1e-12 * half)
              << name << " " << membrane_name;
        }
}

// On a parallelogram the metric is constant and 3x3x3 points are exact too.
TEST(ShellEnergy, two_points_integrate_a_parallelogram_exactly) {
  ShellSection section = steel;
  section.drilling = 0;
  for (const auto& [name, g] : flat_shells()) {
    if (name != "flat" && name != "parallelogram") continue;
    for (const auto& [membrane_name, membrane] : membranes) {
      const VectorXd u = random_vector(24, 4);
      const double half = u.dot(shell_mitc4_stiffness(g, section, membrane) * u) / 2;
      EXPECT_NEAR(strain_energy(g, section, membrane, u, 3), half, 1e-12 * half) << membrane_name;
    }
  }
}

TEST(ShellEnergy, drilling_turn_without_membrane_costs_its_penalty) {
  const ShellGeometry g = flat_shell();
  VectorXd u = VectorXd::Zero(24);
  for (int i = 0; i < 4; ++i) u[6 * i + 5] = 0.01;
  const double half = u.dot(shell_mitc4_stiffness(g, steel, MembraneStrain::displacement) * u) / 2;
  const double G = steel.E / (2 * (1 + steel.nu));
  EXPECT_NEAR(half, steel.drilling * G * 0.1 * 1.2 * 0.8 * 0.01 * 0.01 / 2, 1e-12 * half);
}

TEST(ShellMembrane, mitc4_plus_equals_displacement_on_flat_elements) {
  for (const auto& [name, g] : flat_shells()) {
    const Matrix24 K = shell_mitc4_stiffness(g, steel, MembraneStrain::displacement);
    const Matrix24 K_plus = shell_mitc4_stiffness(g, steel, MembraneStrain::mitc4_plus);
    EXPECT_LE((K_plus - K).norm(), 1e-13 * K.norm()) << name;
  }
}

// Taylor, Beresford & Wilson (1976): the condition for passing the patch test.
TEST(ShellMembrane, incompatible_modes_do_no_work_on_constant_stress) {
  for (const auto& [name, g] : flat_shells()) {
    const auto with = shell_mitc4_points(g, steel, MembraneStrain::incompatible);
    const auto without = shell_mitc4_points(g, steel, MembraneStrain::displacement);
    // Constant stress is the same tensor everywhere: sum the strains in global axes.
    const VectorXd u = random_vector(24, 5);
    Matrix3d sum = Matrix3d::Zero();
    double size = 0;
    for (std::size_t p = 0; p < with.size(); ++p) {
      const Vector3d e = (with[p].strain.in_plane - without[p].strain.in_plane) * u;
      Eigen::Matrix2d local;
      local << e[0], e[2] / 2, e[2] / 2, e[1];
      const auto axes = with[p].strain.basis.leftCols<2>();
      const Matrix3d strain = with[p].weight * axes * local * axes.transpose();
      sum += strain;
      size += strain.norm();
    }
    EXPECT_LE(sum.norm(), 1e-13 * size) << name;
    EXPECT_GT(size, 0);
  }
}

} // namespace
