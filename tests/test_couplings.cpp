// Couplings and constraints: exact rigid motion, force distribution, errors that name both rows.
#include "mesh/plate.hpp"
#include "tests/support/fields.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// u + w x (x - x0) and w at every node.
VectorXd rigid_motion(const Model& model, const Vector3d& u, const Vector3d& w,
                      const Vector3d& x0) {
  VectorXd motion(dof_count(model));
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
    motion.segment<6>(6 * n) << u + w.cross(model.mesh.nodes[n] - x0), w;
  return motion;
}

// Independent DOFs of a motion of all DOFs.
VectorXd reduced(const DofMap& map, const VectorXd& u) {
  return u(map.full);
}

const Vector3d shift(0.3, -0.2, 0.5), turn(0.1, 0.4, -0.3);

// Nodes in no particular order, the reference last, off their centre.
Model scattered() {
  Model model;
  for (const Vector3d& x : {Vector3d(0, 0, 0), Vector3d(1, 0.2, 0), Vector3d(0.3, 1, 0.4),
                            Vector3d(-0.5, 0.6, 1), Vector3d(0.8, -0.7, 0.2)})
    add_node(model, x);
  add_node(model, {2, 1, -1});
  return model;
}
const std::vector<int> five{0, 1, 2, 3, 4};
constexpr int reference = 5;

TEST(KinematicCoupling, moves_every_node_rigidly) {
  Model model = scattered();
  add_kinematic_coupling(model, reference, five, all_dofs, "spider");
  const DofMap map = eliminate(model);
  ASSERT_EQ(map.size(), 6);
  const VectorXd wanted = rigid_motion(model, shift, turn, model.mesh.nodes[reference]);
  EXPECT_LE((expand(map, reduced(map, wanted)) - wanted).norm(), 1e-15 * wanted.norm());
}

TEST(KinematicCoupling, binds_only_the_chosen_dofs) {
  Model model = scattered();
  add_kinematic_coupling(model, reference, {0, 1}, {0, 2, 4}, "spider");
  const DofMap map = eliminate(model);
  EXPECT_EQ(map.size(), 36 - 6);
  for (int node : {0, 1})
    for (int dof = 0; dof < 6; ++dof)
      EXPECT_EQ(map.independent[6 * node + dof] < 0, dof == 0 || dof == 2 || dof == 4);
}

TEST(KinematicCoupling, of_a_whole_plate_leaves_a_rigid_body) {
  Model model =
      shell_model(mesh_plate({Vector3d(0, 0, 0), {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 4, 3, 0.1),
                  {.E = 2e11, .nu = 0.3, .rho = 1000});
  const double largest = dense(assemble(model).K).cwiseAbs().maxCoeff();
  const int centre = add_node(model, {1, 0.5, 0});
  add_kinematic_coupling(model, centre, model.mesh.sets["all"], all_dofs, "spider");
  const System system = assemble(model);
  ASSERT_EQ(system.map.size(), 6);
  EXPECT_LE(dense(system.K).cwiseAbs().maxCoeff(), 1e-11 * largest);
  VectorXd wanted(6); // 200 kg, the drilling rotation of the wall has no inertia of its own
  wanted << 200, 200, 200, 200 * 1.01 / 12, 200 * 4.01 / 12, 200 * 5. / 12;
  const MatrixXd diagonal = wanted.asDiagonal();
  EXPECT_LE((dense(system.M) - diagonal).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(DistributingCoupling, follows_rigid_motion_exactly) {
  Model model = scattered();
  add_distributing_coupling(model, reference, five, "spread");
  const DofMap map = eliminate(model);
  ASSERT_EQ(map.size(), 30);
  const VectorXd wanted = rigid_motion(model, shift, turn, {0.1, 0.2, 0.3});
  EXPECT_LE((expand(map, reduced(map, wanted)) - wanted).norm(), 1e-13 * wanted.norm());
}

// A moment about the axis of a circle of n nodes: tangential forces M / (n R). Across the axis:
// axial forces 2 M r / (n R2), r the distance from the bending axis.
TEST(DistributingCoupling, spreads_a_moment_on_a_circle) {
  constexpr int n = 12;
  constexpr double R = 0.4;
  Model model;
  std::vector<int> circle;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    circle.push_back(add_node(model, {R * std::cos(angle), 0, R * std::sin(angle)}));
  }
  const int centre = add_node(model, Vector3d::Zero());
  add_distributing_coupling(model, centre, circle, "cap");
  const DofMap map = eliminate(model);
  for (int axis : {0, 1, 2}) {
    VectorXd load = no_force(model);
    load[6 * centre + 3 + axis] = 7;
    const VectorXd force = gather(map, load);
    for (int k = 0; k < n; ++k) {
      const Vector3d x = model.mesh.nodes[circle[k]];
      const double moment = axis == 1 ? 7 / (n * R * R) : 14 / (n * R * R);
      Vector3d wanted = moment * Vector3d::Unit(axis).cross(x);
      EXPECT_LE((force.segment<3>(6 * k) - wanted).norm(), 1e-13 * 7 / R) << axis << " " << k;
      EXPECT_EQ(force.segment<3>(6 * k + 3).norm(), 0); // no moments on the nodes
    }
  }
}

// F / n + J^-1 (M + (x_ref - x_c) x F) x r_i with r_i from the centroid x_c and J their inertia.
TEST(DistributingCoupling, spreads_force_and_moment_of_an_eccentric_reference) {
  Model model = scattered();
  add_distributing_coupling(model, reference, five, "spread");
  const auto& x = model.mesh.nodes;
  const Vector3d F(3, -1, 2), M(0.5, 0.7, -1);
  VectorXd load = no_force(model);
  load.segment<6>(6 * reference) << F, M;
  const VectorXd force = gather(eliminate(model), load);
  Vector3d centroid = Vector3d::Zero();
  for (int i : five) centroid += x[i] / 5;
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  for (int i : five) {
    const Vector3d r = x[i] - centroid;
    J += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
  }
  const Vector3d w = J.inverse() * (M + (x[reference] - centroid).cross(F));
  for (int i : five)
    EXPECT_LE((force.segment<3>(6 * i) - F / 5 - w.cross(x[i] - centroid)).norm(), 1e-13) << i;
}

TEST(DistributingCoupling, adds_no_stiffness) {
  Model plate =
      shell_model(mesh_plate({Vector3d(0, 0, 0), {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 4, 3, 0.1),
                  {.E = 2e11, .nu = 0.3, .rho = 1000});
  const MatrixXd without = dense(assemble(plate).K);
  const int centre = add_node(plate, {2.5, 0.5, 0.2});
  add_distributing_coupling(plate, centre, {0, 4, 9, 17}, "spread");
  EXPECT_LE((dense(assemble(plate).K) - without).norm(), 1e-14 * without.norm());
}

TEST(DistributingCoupling, needs_nodes_that_determine_a_rotation) {
  Model model = scattered();
  EXPECT_THROW(add_distributing_coupling(model, reference, {0, 1}, "two"), std::invalid_argument);
  const int a = add_node(model, {3, 0, 0}), b = add_node(model, {4, 0, 0}),
            c = add_node(model, {6, 0, 0});
  EXPECT_THROW(add_distributing_coupling(model, reference, {a, b, c}, "line"),
               std::invalid_argument);
}

// The message of the error that eliminate() throws.
std::string complaint(const Model& model) {
  try {
    eliminate(model);
  } catch (const ConstraintError& error) {
    return error.what();
  }
  return "";
}

void expect_names(const std::string& message, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    EXPECT_NE(message.find(name), std::string::npos) << "'" << name << "' not in: " << message;
}

TEST(Constraints, two_spiders_on_one_node_are_named) {
  Model model = scattered();
  add_kinematic_coupling(model, 5, {0, 1}, all_dofs, "spider of cap left");
  add_kinematic_coupling(model, 4, {1, 2}, {1}, "spider of cap right");
  expect_names(complaint(model), {"spider of cap left", "spider of cap right", "node 2", "uy"});
}

TEST(Constraints, a_support_on_a_dependent_dof_is_named) {
  for (bool support_first : {false, true}) {
    Model model = scattered();
    if (support_first) add_support(model, {2}, {5}, "mount");
    add_kinematic_coupling(model, 5, five, all_dofs, "spider of cap left");
    if (!support_first) add_support(model, {2}, {5}, "mount");
    expect_names(complaint(model), {"mount", "spider of cap left", "node 3", "rz"});
  }
}

TEST(Constraints, a_circle_is_named) {
  Model model = scattered();
  add_kinematic_coupling(model, 5, {0}, all_dofs, "first spider");
  add_kinematic_coupling(model, 0, {3}, all_dofs, "second spider");
  add_kinematic_coupling(model, 3, {5}, all_dofs, "third spider");
  const std::string message = complaint(model);
  expect_names(message, {"circle", "spider (node"});
  // Two different rows of the circle.
  const int named = int(message.find("first") != std::string::npos) +
                    int(message.find("second") != std::string::npos) +
                    int(message.find("third") != std::string::npos);
  EXPECT_EQ(named, 2) << message;
}

TEST(Constraints, a_dof_that_follows_itself_is_named) {
  Model model = scattered();
  model.constraints.push_back({.node = 0, .dof = 1, .terms = {{0, 1, 1.}}, .origin = "loop"});
  expect_names(complaint(model), {"loop", "node 1", "uy"});
}

TEST(Constraints, chains_are_followed) {
  Model model = scattered();
  add_kinematic_coupling(model, 1, {0}, all_dofs, "first");
  add_kinematic_coupling(model, 5, {1}, all_dofs, "second");
  add_support(model, {5}, {0}, "mount");
  const DofMap map = eliminate(model);
  const VectorXd wanted =
      rigid_motion(model, Vector3d(0, -0.2, 0.5), turn, model.mesh.nodes[reference]);
  const VectorXd u = expand(map, reduced(map, wanted));
  EXPECT_LE((u.head(12) - wanted.head(12)).norm(), 1e-15);
}

TEST(Constraints, a_dof_held_twice_is_held_once) {
  Model model = scattered();
  add_support(model, {0, 1}, all_dofs, "mount");
  add_support(model, {1, 0, 1}, {0, 1, 2}, "pin");
  EXPECT_EQ(eliminate(model).size(), 36 - 12);
}

} // namespace
