// Elements at a state of finite displacement and rotation (elements/*_state.hpp).
#include "elements/beam_state.hpp"
#include "elements/shell_mitc3_state.hpp"
#include "elements/shell_mitc4_state.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace plica;

namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Matrix3d rotation_by(const Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Matrix3d(AngleAxisd(angle, vector / angle)) : Matrix3d(Matrix3d::Identity());
}

// Places and rotations of the nodes of one element.
struct NodeStates {
  std::vector<Vector3d> place;
  std::vector<Matrix3d> turned;

  NodeStates moved(const VectorXd& increment) const {
    NodeStates next = *this;
    for (std::size_t i = 0; i < place.size(); ++i) {
      next.place[i] += increment.segment<3>(6 * Eigen::Index(i));
      next.turned[i] = rotation_by(increment.segment<3>(6 * Eigen::Index(i) + 3)) * turned[i];
    }
    return next;
  }
};

VectorXd random_increment(Eigen::Index dofs, double length, double angle, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> even(-1, 1);
  VectorXd q(dofs);
  for (Eigen::Index i = 0; i < dofs; ++i) q[i] = (i % 6 < 3 ? length : angle) * even(random);
  return q;
}

template <int nodes> NodeRotations<nodes> rotations_of(const NodeStates& s) {
  NodeRotations<nodes> r;
  std::copy(s.turned.begin(), s.turned.end(), r.begin());
  return r;
}

const ShellSection steel_wall{.E = 2e11, .nu = 0.3, .rho = 7900, .drilling = 0};

ShellGeometry warped_quad() {
  ShellGeometry g;
  g.X << 0, 11e-3, 10e-3, 1e-3, 0, 0, 9e-3, 8e-3, 0, 1e-3, 0, 1e-3;
  g.directors << -0.1, 0.1, 0.1, -0.1, -0.1, -0.1, 0.1, 0.1, 1, 1, 1, 1;
  g.directors.colwise().normalize();
  g.thickness << 1e-3, 1e-3, 1.2e-3, 1.1e-3;
  return g;
}

TriangleGeometry curved_triangle() {
  TriangleGeometry g;
  g.X << 0, 11e-3, 2e-3, 0, 1e-3, 9e-3, 0, 0, 1e-3;
  g.directors << -0.1, 0.1, 0, -0.1, -0.1, 0.1, 1, 1, 1;
  g.directors.colwise().normalize();
  g.thickness << 1e-3, 1.1e-3, 1.2e-3;
  return g;
}

template <class Geometry> Geometry shape_now(const Geometry& rest, const NodeStates& s) {
  Geometry now = rest;
  for (std::size_t i = 0; i < s.place.size(); ++i) {
    now.X.col(Eigen::Index(i)) = s.place[i];
    now.directors.col(Eigen::Index(i)) = s.turned[i] * rest.directors.col(Eigen::Index(i));
  }
  return now;
}

struct StressedElement {
  NodeStates rest;
  std::function<std::pair<MatrixXd, VectorXd>(const NodeStates&)> tangent;
  MatrixXd at_rest;
  double length; // size of the element
};

NodeStates nodes_at(std::vector<Vector3d> places) {
  const std::vector<Matrix3d> turned(places.size(), Matrix3d::Identity());
  return {std::move(places), turned};
}

StressedElement quad(MembraneStrain membrane, double bending_factor) {
  ShellSection section = steel_wall;
  section.bending_factor = bending_factor;
  const ShellGeometry g = warped_quad();
  return {.rest = nodes_at({g.X.col(0), g.X.col(1), g.X.col(2), g.X.col(3)}),
          .tangent =
              [=](const NodeStates& s) {
                const auto t =
                    shell_mitc4_tangent(g, shape_now(g, s), rotations_of<4>(s), section, membrane);
                return std::pair<MatrixXd, VectorXd>(t.K, t.force);
              },
          .at_rest = shell_mitc4_stiffness(g, section, membrane),
          .length = 0.01};
}

StressedElement triangle() {
  const TriangleGeometry g = curved_triangle();
  return {.rest = nodes_at({g.X.col(0), g.X.col(1), g.X.col(2)}),
          .tangent =
              [=](const NodeStates& s) {
                const auto t =
                    shell_mitc3_tangent(g, shape_now(g, s), rotations_of<3>(s), steel_wall);
                return std::pair<MatrixXd, VectorXd>(t.K, t.force);
              },
          .at_rest = shell_mitc3_stiffness(g, steel_wall),
          .length = 0.01};
}

StressedElement beam() {
  BeamProperties section = rectangle_section({.E = 2e11, .nu = 0.3, .rho = 7900}, 4e-3, 7e-3);
  const BeamGeometry g{.node1 = {0.1, 0.2, 0},
                       .node2 = {0.15, 0.23, 0.02},
                       .offset1 = {1e-3, 2e-3, 0},
                       .offset2 = {0, -1e-3, 2e-3}};
  return {.rest = nodes_at({g.node1, g.node2}),
          .tangent =
              [=](const NodeStates& s) {
                const auto t = beam_tangent(g, section, s.place[0], s.place[1], rotations_of<2>(s));
                return std::pair<MatrixXd, VectorXd>(t.K, t.force);
              },
          .at_rest = beam_stiffness(g, section),
          .length = 0.05};
}

StressedElement bushing() {
  Bushing b;
  b.axes = rotation_by({0.3, -0.2, 0.5});
  const MatrixXd half = MatrixXd::Random(6, 6);
  b.law = 1e4 * (half * half.transpose() + MatrixXd::Identity(6, 6));
  const Vector3d x1{0.1, 0, 0}, x2{0.12, 0.03, 0};
  return {.rest = nodes_at({x1, x2}),
          .tangent =
              [=](const NodeStates& s) {
                const auto t = bushing_tangent(b, {x1, s.place[0], s.turned[0]},
                                               {x2, s.place[1], s.turned[1]}, (x1 + x2) / 2);
                return std::pair<MatrixXd, VectorXd>(t.K, t.force);
              },
          .at_rest = bushing_matrix(b, x1, x2, (x1 + x2) / 2),
          .length = 0.03};
}

std::vector<StressedElement> stressed_elements() {
  return {quad(MembraneStrain::displacement, 1),
          quad(MembraneStrain::mitc4_plus, 1),
          quad(MembraneStrain::incompatible, 1),
          quad(MembraneStrain::incompatible, 0.25),
          triangle(),
          beam(),
          bushing()};
}

// The whole turned by more than a right angle, then strained.
NodeStates far_state(const StressedElement& e, double strain) {
  const Matrix3d turn = rotation_by({1.2, -0.9, 1.1});
  NodeStates s = e.rest;
  for (std::size_t i = 0; i < s.place.size(); ++i) {
    s.place[i] = turn * s.place[i] + Vector3d(0.3, 0.1, -0.2);
    s.turned[i] = turn;
  }
  return s.moved(random_increment(6 * Eigen::Index(s.place.size()), strain * e.length, strain, 7));
}

} // namespace

TEST(ElementStates, AtRestTheyAreTheLinearElements) {
  for (const StressedElement& e : stressed_elements()) {
    const auto [K, force] = e.tangent(e.rest);
    EXPECT_LT((K - e.at_rest).norm(), 1e-12 * e.at_rest.norm());
    EXPECT_LT(force.norm(), 1e-13 * e.at_rest.norm() * e.length);
  }
}

TEST(ElementStates, RigidMotionsLeaveThemUnstressed) {
  for (const StressedElement& e : stressed_elements()) {
    const auto [K, force] = e.tangent(far_state(e, 0));
    EXPECT_LT(force.norm(), 1e-9 * e.at_rest.norm() * e.length);
    EXPECT_NEAR(K.norm() / e.at_rest.norm(), 1, 1e-6);
  }
}

// The stiffness is the symmetric part of the numerical derivative of the forces; the other part
// belongs to the order of finite rotations.
TEST(ElementStates, StiffnessIsTheDerivativeOfTheForces) {
  for (const StressedElement& e : stressed_elements()) {
    const NodeStates s = far_state(e, 0.02);
    const auto [K, force] = e.tangent(s);
    const Eigen::Index n = K.rows();
    MatrixXd numeric(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double step = j % 6 < 3 ? 1e-5 * e.length : 1e-5;
      const VectorXd q = step * VectorXd::Unit(n, j);
      numeric.col(j) = (e.tangent(s.moved(q)).second - e.tangent(s.moved(-q)).second) / (2 * step);
    }
    const MatrixXd symmetric = (numeric + numeric.transpose()) / 2;
    const VectorXd scale = K.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    EXPECT_LT((scale.asDiagonal() * (symmetric - K) * scale.asDiagonal()).cwiseAbs().maxCoeff(),
              2e-7);
    EXPECT_GT((K - e.tangent(far_state(e, 0)).first).norm(), 1e-3 * K.norm());
  }
}

// Held all round, the wall is pressed by E alpha dT / (1 - nu) in its plane.
TEST(ElementStates, HeatedAndHeldAllRound) {
  ShellSection section = steel_wall;
  section.thermal_strain = 1e-3;
  ShellGeometry g;
  g.X << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  g.directors.setZero();
  g.directors.row(2).setOnes();
  g.thickness.setConstant(0.01);
  const NodeRotations<4> still{Matrix3d::Identity(), Matrix3d::Identity(), Matrix3d::Identity(),
                               Matrix3d::Identity()};
  const auto t = shell_mitc4_tangent(g, g, still, section, MembraneStrain::incompatible);
  // Green strain, of lengths that have grown.
  const double pressed = 2e11 / (1 - 0.3) * 1e-3 * (1 + 1e-3 / 2) / (1.001 * 1.001);
  EXPECT_NEAR(t.force[0], 1.001 * pressed * 0.01 / 2, 1e-9 * pressed);
  const auto stress = shell_mitc4_state_stress(g, g, section, MembraneStrain::incompatible);
  EXPECT_NEAR(stress[0], -pressed, 1e-9 * pressed);
}
