// One harness over every element: symmetry, rigid motions, energy, mass of the rigid body.
#include "elements/bushing.hpp"
#include "elements/shell_mitc4.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace plica;
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

VectorXd random_vector(int size, unsigned seed) {
  std::mt19937 random(seed);
  VectorXd v(size);
  for (double& x : v) x = 2 * double(random()) / double(std::mt19937::max()) - 1;
  return v;
}

ShellGeometry quad(std::initializer_list<Vector3d> corners, double thickness) {
  ShellGeometry g;
  int i = 0;
  for (const Vector3d& x : corners) g.X.col(i++) = x;
  for (i = 0; i < 4; ++i)
    g.directors.col(i) = Vector3d(g.X.col((i + 1) % 4) - g.X.col(i))
                             .cross(Vector3d(g.X.col((i + 3) % 4) - g.X.col(i)))
                             .normalized();
  g.thickness.setConstant(thickness);
  return g;
}

ShellGeometry flat() {
  return quad({{0, 0, 0}, {1.2, 0, 0}, {1.2, 0.8, 0}, {0, 0.8, 0}}, 0.1);
}
ShellGeometry parallelogram() {
  return quad({{0, 0, 0}, {1.2, 0, 0}, {1.7, 0.8, 0}, {0.5, 0.8, 0}}, 0.1);
}
ShellGeometry skewed() {
  return quad({{0, 0, 0}, {1.2, 0.1, 0}, {1.5, 0.9, 0}, {-0.1, 0.6, 0}}, 0.1);
}
ShellGeometry turned() {
  ShellGeometry g = skewed();
  const Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  g.X = R * g.X;
  g.directors = R * g.directors;
  return g;
}
ShellGeometry warped() {
  return quad({{0, 0, 0.1}, {1.2, 0.1, -0.1}, {1.5, 0.9, 0.2}, {-0.1, 0.6, -0.15}}, 0.1);
}
// A piece of a cylinder of radius 0.3: directors well off the normal of the flat corners.
ShellGeometry curved() {
  ShellGeometry g;
  for (int i = 0; i < 4; ++i) {
    const double angle = i == 1 || i == 2 ? 0.3 : -0.2;
    g.directors.col(i) << std::sin(angle), 0, std::cos(angle);
    g.X.col(i) << 0.3 * std::sin(angle), i < 2 ? 0 : 0.2 + 0.1 * angle, 0.3 * std::cos(angle);
  }
  g.thickness << 0.1, 0.08, 0.09, 0.1;
  return g;
}
// Warped corners with directors of a doubly curved surface.
ShellGeometry curved_warped() {
  ShellGeometry g = warped();
  for (int i = 0; i < 4; ++i)
    g.directors.col(i) = Vector3d(0.4 * g.X(0, i) - 0.2, -0.3 * g.X(1, i) + 0.1, 1).normalized();
  return g;
}

struct ShellCase {
  const char* name;
  ShellGeometry geometry;
};
const std::vector<ShellCase>& shell_cases() {
  static const std::vector<ShellCase> cases{{"flat", flat()},
                                            {"parallelogram", parallelogram()},
                                            {"skewed", skewed()},
                                            {"turned", turned()},
                                            {"warped", warped()},
                                            {"curved", curved()},
                                            {"curved_warped", curved_warped()}};
  return cases;
}
const std::vector<std::pair<const char*, MembraneStrain>> membranes{
    {"displacement", MembraneStrain::displacement},
    {"mitc4_plus", MembraneStrain::mitc4_plus},
    {"incompatible", MembraneStrain::incompatible}};
const ShellSection steel{.E = 2e11, .nu = 0.3, .rho = 8000};

// An element as the harness sees it.
struct Element {
  std::string name;
  std::vector<Vector3d> nodes;
  MatrixXd K, M;
};

void PrintTo(const Element& element, std::ostream* out) {
  *out << element.name;
}

std::vector<Vector3d> corners(const ShellGeometry& g) {
  return {g.X.col(0), g.X.col(1), g.X.col(2), g.X.col(3)};
}

Element beam(const std::string& name, const BeamGeometry& g, BeamProperties section) {
  return {name, {g.node1, g.node2}, beam_stiffness(g, section), beam_mass(g, section)};
}

Matrix6 full_law() {
  const MatrixXd A = random_vector(36, 3).reshaped(6, 6);
  return 1e6 * (A * A.transpose() + MatrixXd::Identity(6, 6));
}

std::vector<Element> all_elements() {
  std::vector<Element> elements;
  for (const auto& [name, geometry] : shell_cases())
    for (const auto& [membrane_name, membrane] : membranes)
      for (double factor : {1., 0.25}) {
        ShellSection section = steel;
        section.bending_factor = factor;
        elements.push_back(
            {std::string("shell_") + name + "_" + membrane_name + (factor < 1 ? "_slipping" : ""),
             corners(geometry), shell_mitc4_stiffness(geometry, section, membrane),
             shell_mitc4_mass(geometry, section)});
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

class EveryElement : public testing::TestWithParam<Element> {};

TEST_P(EveryElement, is_symmetric) {
  const auto& [name, nodes, K, M] = GetParam();
  EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm());
  EXPECT_LE((M - M.transpose()).norm(), 1e-14 * M.norm());
}

TEST_P(EveryElement, stores_no_energy_in_rigid_motions) {
  const auto& [name, nodes, K, M] = GetParam();
  const MatrixXd R = rigid_motions(nodes, {0.3, -0.2, 0.1});
  for (int j = 0; j < 6; ++j)
    EXPECT_LE((K * R.col(j)).norm(), 1e-9 * K.norm() * R.col(j).norm()) << "motion " << j;
}

TEST_P(EveryElement, has_exactly_six_zero_eigenvalues) {
  const VectorXd lambda = GetParam().K.selfadjointView<Eigen::Lower>().eigenvalues();
  const double largest = lambda.tail(1)[0];
  EXPECT_LE(lambda.head(6).cwiseAbs().maxCoeff(), 1e-12 * largest);
  EXPECT_GT(lambda[6], 1e-4 * steel.drilling * largest);
}

TEST_P(EveryElement, moves_rigidly_with_its_mass_centre_and_inertia) {
  const auto& [name, nodes, K, M] = GetParam();
  const MatrixXd R = rigid_motions(nodes, Vector3d::Zero());
  const Matrix6 m = R.transpose() * M * R;
  if (M.isZero()) return;
  // Whatever the body, R'MR has the form of a rigid body: one mass, one centre.
  RigidMass body{.mass = m(0, 0), .offset = {m(1, 5), m(2, 3), m(0, 4)}};
  body.offset /= body.mass;
  body.inertia.setZero();
  body.inertia = (m - rigid_mass_matrix(body)).bottomRightCorner<3, 3>();
  EXPECT_LE((m - rigid_mass_matrix(body)).norm(), 1e-12 * m.norm());
  EXPECT_GT(body.inertia.selfadjointView<Eigen::Lower>().eigenvalues()[0], 0);
}

INSTANTIATE_TEST_SUITE_P(Harness, EveryElement, testing::ValuesIn(all_elements()),
                         [](const auto& element) { return element.param.name; });

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
  for (const auto& [name, g] : shell_cases())
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
  for (const ShellGeometry& g : {flat(), parallelogram()})
    for (const auto& [name, membrane] : membranes)
      for (unsigned seed : {1, 2, 3}) {
        const VectorXd u = random_vector(24, seed);
        const double half = u.dot(shell_mitc4_stiffness(g, section, membrane) * u) / 2;
        EXPECT_NEAR(strain_energy(g, section, membrane, u, 3), half, 1e-12 * half) << name;
      }
}

TEST(ShellEnergy, drilling_turn_without_membrane_costs_its_penalty) {
  const ShellGeometry g = flat();
  VectorXd u = VectorXd::Zero(24);
  for (int i = 0; i < 4; ++i) u[6 * i + 5] = 0.01;
  const double half = u.dot(shell_mitc4_stiffness(g, steel, MembraneStrain::displacement) * u) / 2;
  const double G = steel.E / (2 * (1 + steel.nu));
  EXPECT_NEAR(half, steel.drilling * G * 0.1 * 1.2 * 0.8 * 0.01 * 0.01 / 2, 1e-12 * half);
}

TEST(ShellMembrane, mitc4_plus_equals_displacement_on_flat_elements) {
  for (const ShellGeometry& g : {flat(), parallelogram(), skewed(), turned()}) {
    const Matrix24 K = shell_mitc4_stiffness(g, steel, MembraneStrain::displacement);
    const Matrix24 K_plus = shell_mitc4_stiffness(g, steel, MembraneStrain::mitc4_plus);
    EXPECT_LE((K_plus - K).norm(), 1e-13 * K.norm());
  }
}

// Taylor, Beresford & Wilson (1976): the condition for passing the patch test.
TEST(ShellMembrane, incompatible_modes_do_no_work_on_constant_stress) {
  for (const ShellGeometry& g : {flat(), parallelogram(), skewed(), turned()}) {
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
    EXPECT_LE(sum.norm(), 1e-13 * size);
    EXPECT_GT(size, 0);
  }
}

// Mass, centre and inertia of the real bodies.

TEST(RigidBody, flat_shell_has_the_inertia_of_a_plate) {
  const double a = 1.2, b = 0.8, t = 0.1, m = 8000 * a * b * t;
  RigidMass plate{.mass = m, .offset = {a / 2, b / 2, 0}};
  // The drilling rotation of a corner has no inertia; all of J_zz comes from the translations.
  plate.inertia.diagonal() << m * (b * b + t * t) / 12, m * (a * a + t * t) / 12,
      m * (a * a + b * b) / 12;
  const ShellGeometry g = flat();
  const MatrixXd R = rigid_motions(corners(g), Vector3d::Zero());
  const Matrix6 expected = rigid_mass_matrix(plate);
  EXPECT_LE((R.transpose() * shell_mitc4_mass(g, steel) * R - expected).norm(),
            1e-13 * expected.norm());
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
