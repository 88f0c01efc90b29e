// One harness over every element: symmetry, rigid motions, energy, mass of the rigid body.
#include "elements/bushing.hpp"
#include "elements/shell_mitc3.hpp"
#include "tests/support/shell_cases.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Six rigid motions of nodes about a point, column by column.
MatrixXd rigid_motions(const std::vector<Vector3d>& nodes, const Vector3d& about) {
  MatrixXd R = MatrixXd::Zero(6 * nodes.size(), 6);
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (int j = 0; j < 3; ++j) {
      const Vector3d e = Vector3d::Unit(j);
      R.block<3, 1>(6 * n, j) = e;
      R.block<3, 1>(6 * n, 3 + j) = e.cross(nodes[n] - about);
      R.block<3, 1>(6 * n + 3, 3 + j) = e;
    }
  return R;
}

const ShellSection steel{.E = 2e11, .nu = 0.3, .rho = 8000};

// An element as the harness sees it.
struct Element {
  std::string name;
  std::vector<Vector3d> nodes;
  MatrixXd K, M;
};

Element beam(const std::string& name, const BeamGeometry& g, BeamProperties section) {
  return {name, {g.node1, g.node2}, beam_stiffness(g, section), beam_mass(g, section)};
}

Matrix6 full_law() {
  const MatrixXd A = random_vector(36, 3).reshaped(6, 6);
  return 1e6 * (A * A.transpose() + MatrixXd::Identity(6, 6));
}

std::vector<Element> all_elements() {
  std::vector<Element> elements;
  for (const auto& [name, geometry] : all_shells())
    for (const auto& [membrane_name, membrane] : membranes)
      for (double factor : {1., 0.25}) {
        ShellSection section = steel;
        section.bending_factor = factor;
        elements.push_back({"shell_" + name + "_" + membrane_name + (factor < 1 ? "_slipping" : ""),
                            corners(geometry), shell_mitc4_stiffness(geometry, section, membrane),
                            shell_mitc4_mass(geometry, section)});
      }
  for (const auto& [name, g] : all_shells())
    for (double factor : {1., 0.25}) {
      ShellSection section = steel;
      section.bending_factor = factor;
      const TriangleGeometry triangle{g.X.leftCols<3>(), g.directors.leftCols<3>(),
                                      g.thickness.head<3>()};
      elements.push_back({"triangle_" + name + (factor < 1 ? "_slipping" : ""),
                          {g.X.col(0), g.X.col(1), g.X.col(2)},
                          shell_mitc3_stiffness(triangle, section),
                          shell_mitc3_mass(triangle, section)});
    }
  const BeamProperties bar = rectangle_section({2e11, 0.3, 8000}, 0.2, 0.1);
  BeamProperties rigid_shear = bar, half_rigid = bar;
  rigid_shear.GA_y = rigid_shear.GA_z = half_rigid.GA_y = std::numeric_limits<double>::infinity();
  BeamGeometry g{{0, 0, 0}, {1, 0, 0}};
  elements.push_back(beam("beam_straight", g, bar));
  g.node2 = {0.7, -0.4, 0.5};
  elements.push_back(beam("beam_skew", g, bar));
  elements.push_back(beam("beam_rigid_shear", g, rigid_shear));
  elements.push_back(beam("beam_half_rigid_shear", g, half_rigid));
  g.offset1 = {0.1, 0.3, -0.2};
  g.offset2 = {-0.2, 0.1, 0.4};
  elements.push_back(beam("beam_offset", g, bar));
  const Vector3d a(0.3, 0.2, -0.1), b(-0.4, 0.6, 0.5);
  const Matrix3d axes = Eigen::AngleAxisd(1.1, Vector3d(1, -1, 2).normalized()).toRotationMatrix();
  elements.push_back({"bushing_off_centre",
                      {a, b},
                      bushing_matrix({full_law(), axes}, a, b, {1, -0.5, 0.7}),
                      MatrixXd::Zero(12, 12)});
  return elements;
}

TEST(EveryElement, is_symmetric) {
  for (const auto& [name, nodes, K, M] : all_elements()) {
    EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm()) << name;
    EXPECT_LE((M - M.transpose()).norm(), 1e-14 * M.norm()) << name;
  }
}

TEST(EveryElement, stores_no_energy_in_rigid_motions) {
  for (const auto& [name, nodes, K, M] : all_elements()) {
    const MatrixXd R = rigid_motions(nodes, {0.3, -0.2, 0.1});
    for (int j = 0; j < 6; ++j)
      EXPECT_LE((K * R.col(j)).norm(), 1e-9 * K.norm() * R.col(j).norm()) << name << ", " << j;
  }
}

TEST(EveryElement, has_exactly_six_zero_eigenvalues) {
  for (const auto& [name, nodes, K, M] : all_elements()) {
    const VectorXd lambda = K.selfadjointView<Eigen::Lower>().eigenvalues();
    const double largest = lambda.tail(1)[0];
    EXPECT_LE(lambda.head(6).cwiseAbs().maxCoeff(), 1e-13 * largest) << name;
    // The twist of the tied shear of a triangle is soft, by design.
    const double least = name.starts_with("triangle") ? 1e-6 : 1e-4;
    EXPECT_GT(lambda[6], least * steel.drilling * largest) << name;
  }
}

// Whatever the body, R'MR has the form of a rigid body: one mass, one centre, some inertia.
TEST(EveryElement, moves_rigidly_with_one_mass_and_centre) {
  for (const auto& [name, nodes, K, M] : all_elements()) {
    if (M.isZero()) continue;
    const MatrixXd R = rigid_motions(nodes, Vector3d::Zero());
    const Matrix6 m = R.transpose() * M * R;
    RigidMass body{.mass = m(0, 0), .offset = Vector3d(m(1, 5), m(2, 3), m(0, 4)) / m(0, 0)};
    body.inertia = (m - rigid_mass_matrix(body)).bottomRightCorner<3, 3>();
    EXPECT_LE((m - rigid_mass_matrix(body)).norm(), 1e-12 * m.norm()) << name;
    EXPECT_GT(body.inertia.selfadjointView<Eigen::Lower>().eigenvalues()[0], 0) << name;
  }
}

// Mass, centre and inertia of the real bodies.

TEST(RigidBody, flat_shell_has_the_inertia_of_a_plate) {
  const double a = 1.2, b = 0.8, t = 0.1, m = 8000 * a * b * t;
  RigidMass plate{.mass = m, .offset = {a / 2, b / 2, 0}};
  // The drilling rotation of a corner has no inertia; all of J_zz comes from the translations.
  plate.inertia.diagonal() << m * (b * b + t * t) / 12, m * (a * a + t * t) / 12,
      m * (a * a + b * b) / 12;
  const ShellGeometry g = flat_shell();
  const MatrixXd R = rigid_motions(corners(g), Vector3d::Zero());
  const Matrix6 expected = rigid_mass_matrix(plate);
  EXPECT_LE((R.transpose() * shell_mitc4_mass(g, steel) * R - expected).norm(),
            1e-13 * expected.norm());
}

// rho times the integral of t |x_r x x_s|, wherever the directors point.
TEST(RigidBody, shell_weighs_its_mid_surface) {
  for (const auto& [name, g] : all_shells()) {
    double mass = 0;
    for (double r : {-std::sqrt(1. / 3), std::sqrt(1. / 3)})
      for (double s : {-std::sqrt(1. / 3), std::sqrt(1. / 3)}) {
        const Eigen::Vector4d N((1 - r) * (1 - s), (1 + r) * (1 - s), (1 + r) * (1 + s),
                                (1 - r) * (1 + s));
        const Vector3d x_r = g.X * Eigen::Vector4d(s - 1, 1 - s, 1 + s, -1 - s) / 4;
        const Vector3d x_s = g.X * Eigen::Vector4d(r - 1, -1 - r, 1 + r, 1 - r) / 4;
        mass += steel.rho * g.thickness.dot(N) / 4 * x_r.cross(x_s).norm();
      }
    const MatrixXd R = rigid_motions(corners(g), Vector3d::Zero());
    const Matrix24 M = shell_mitc4_mass(g, steel);
    EXPECT_NEAR(R.col(0).dot(M * R.col(0)), mass, 1e-13 * mass) << name;
  }
}

TEST(RigidBody, beam_with_offsets_has_the_inertia_of_a_bar) {
  const BeamProperties s = rectangle_section({2e11, 0.3, 8000}, 0.2, 0.1);
  const BeamGeometry g{.node1 = {0.1, 0.2, 0.3},
                       .node2 = {0.8, -0.2, 0.9},
                       .offset1 = {0.1, 0.3, -0.2},
                       .offset2 = {-0.2, 0.1, 0.4}};
  const Vector3d start = g.node1 + g.offset1, end = g.node2 + g.offset2;
  const double L = (end - start).norm(), m = s.mass * L;
  const Vector3d x = (end - start) / L;
  const Vector3d z = (Vector3d::UnitZ() - x.z() * x).normalized();
  Matrix3d axes;
  axes << x, z.cross(x), z;
  const Vector3d J(s.inertia_x * L, m * L * L / 12 + s.inertia_y * L,
                   m * L * L / 12 + s.inertia_z * L);
  const RigidMass bar{
      .mass = m, .offset = (start + end) / 2, .inertia = axes * J.asDiagonal() * axes.transpose()};
  const MatrixXd R = rigid_motions({g.node1, g.node2}, Vector3d::Zero());
  const Matrix6 expected = rigid_mass_matrix(bar);
  EXPECT_LE((R.transpose() * beam_mass(g, s) * R - expected).norm(), 1e-13 * expected.norm());
}

TEST(RigidBody, point_mass_obeys_the_parallel_axis_theorem) {
  RigidMass body{.mass = 3, .offset = {0.1, -0.2, 0.4}};
  body.inertia.diagonal() << 0.5, 0.4, 0.3;
  const Matrix6 M = rigid_mass_matrix(body);
  const Vector3d c = body.offset;
  EXPECT_NEAR(M(3, 3), 0.5 + 3 * (c.y() * c.y() + c.z() * c.z()), 1e-15);
  EXPECT_NEAR(M(3, 4), -3 * c.x() * c.y(), 1e-15);
  // Kinetic energy of a turn about the node: the centre moves with w x c.
  const Vector3d w(0.3, -0.7, 0.2);
  Eigen::Matrix<double, 6, 1> v;
  v << 1, 2, 3, w;
  const Vector3d centre = Vector3d(1, 2, 3) + w.cross(c);
  EXPECT_NEAR(v.dot(M * v), 3 * centre.squaredNorm() + w.dot(body.inertia * w), 1e-13);
}

TEST(GroundBushing, resists_along_its_own_axes) {
  Bushing spring;
  spring.law(0, 0) = 7;
  spring.axes = Eigen::AngleAxisd(std::acos(-1.) / 2, Vector3d::UnitZ()).toRotationMatrix();
  const Matrix6 K = ground_bushing_matrix(spring); // local x lies along global y
  EXPECT_NEAR(K(1, 1), 7, 1e-14);
  EXPECT_NEAR(K.norm(), 7, 1e-14);
}

} // namespace
