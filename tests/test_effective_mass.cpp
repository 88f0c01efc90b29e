// Effective masses: fractions of a cantilever, sums over all modes, free bodies.
#include "mesh/plate.hpp"
#include "solve/effective_mass.hpp"
#include "tests/support/fields.hpp"
#include "words/directions.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::vector<int> all_free(const System& system) {
  std::vector<int> free(system.map.size());
  std::iota(free.begin(), free.end(), 0);
  return free;
}

// Every mode with mass, mass-normalised: M phi = mu K phi, 1/mu = lambda. K is definite; massless
// rotations give mu = 0.
MatrixXd all_modes(const System& system) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(dense(system.M), dense(system.K));
  const VectorXd& mu = eigen.eigenvalues();
  const auto with_mass = (mu.array() > 1e-13 * mu.tail(1)[0]).count();
  return eigen.eigenvectors().rightCols(with_mass).rowwise().reverse() *
         mu.tail(with_mass).reverse().cwiseSqrt().cwiseInverse().asDiagonal();
}

// One row of six per mode.
MatrixXd effective_masses(const FreeMass& free, const SparseMatrix& M, const MatrixXd& Phi) {
  return (Phi.transpose() * symmetric_product(M, free.R)).array().square();
}

// Clamped bar of 60 elements, shear rigid, without rotary inertia; length 2, 3 kg/m.
Model cantilever() {
  Model model;
  const BeamProperties section{.EA = 1e6, .EI_y = 40, .EI_z = 70, .GJ = 30, .mass = 3};
  add_node(model, Vector3d::Zero());
  for (int i = 1; i <= 60; ++i) {
    add_node(model, {i / 30., 0, 0});
    model.beams.push_back({.node1 = i - 1, .node2 = i, .section = section});
  }
  add_support(model, {0}, all_dofs, "clamp");
  return model;
}

// Fractions of the whole mass: closed form of Euler's beam; sum 1 - (264/420)/60, the share of the
// clamped node in the consistent mass. Rod: 8/(n pi)2, n odd.
TEST(EffectiveMass, cantilever_fractions) {
  Model model = cantilever();
  for (int node = 1; node <= 60; ++node) add_support(model, {node}, {3}, "no twist");
  const System system = assemble(model);
  const FreeMass free = free_mass(model, system.map, all_free(system), system.M);
  const MatrixXd Phi = all_modes(system);
  const MatrixXd masses = effective_masses(free, system.M, Phi) / 6; // of 6 kg
  const auto largest = [&](int direction) {
    std::vector<double> sorted;
    for (Eigen::Index i = 0; i < masses.rows(); ++i)
      if (masses(i, direction) > 1e-9) sorted.push_back(masses(i, direction));
    std::sort(sorted.rbegin(), sorted.rend());
    return sorted;
  };
  for (int direction : {1, 2}) {
    const std::vector<double> wanted{0.61307, 0.18829, 0.06472, 0.03307, 0.02000, 0.01338};
    const auto found = largest(direction);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-5);
    EXPECT_NEAR(masses.col(direction).sum(), 0.98952, 1e-5);
    EXPECT_NEAR(masses.col(direction).sum(), 1 - 264. / 420 / 60, 1e-9);
  }
  const auto rod = largest(0);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(rod[k], 8 / std::pow((2 * k + 1) * std::numbers::pi, 2), 1e-3);
}

TEST(EffectiveMass, lanczos_modes_give_the_same_fractions) {
  const Model model = cantilever();
  const SolvedModes modes = find_modes(model, 8);
  const FreeMass free = free_mass(model, modes.system.map, all_free(modes.system), modes.system.M);
  const MatrixXd masses = effective_masses(free, modes.system.M, modes.set.Phi) / 6;
  std::vector<double> found; // first bending in z, then in y, ...
  for (Eigen::Index i = 0; i < masses.rows(); ++i) found.push_back(masses(i, 2));
  std::sort(found.rbegin(), found.rend());
  EXPECT_NEAR(found[0], 0.61307, 1e-5);
  EXPECT_NEAR(found[1], 0.18829, 1e-5);
  EXPECT_NEAR(found[2], 0.06472, 1e-5);
}

// A warped shell held along one edge, with a rigid body on a corner.
TEST(EffectiveMass, all_modes_of_a_shell_carry_its_free_mass) {
  Model model = shell_model(
      mesh_plate({Vector3d(0, 0, 0), {1, 0, 0.1}, {1.2, 0.7, -0.1}, {0, 0.6, 0.2}}, 4, 3, 0.01),
      {.E = 2e11, .nu = 0.3, .rho = 8000});
  hold(model, "edge4", all_dofs);
  RigidMass body{.mass = 5, .offset = {0.1, 0, 0.05}};
  body.inertia.diagonal() << 0.02, 0.03, 0.04;
  model.masses.push_back({model.mesh.sets["corner2"][0], body});
  const System system = assemble(model);
  const FreeMass free = free_mass(model, system.map, all_free(system), system.M);
  const VectorXd sum = effective_masses(free, system.M, all_modes(system)).colwise().sum();
  for (int j = 0; j < 6; ++j) EXPECT_NEAR(sum[j] / free.total[j], 1, 1e-9) << dof_name(j);
}

// About its centre of mass a free body moves in six modes; elastic ones carry nothing.
TEST(EffectiveMass, rigid_modes_of_a_free_body_carry_all) {
  Model model = shell_model(
      mesh_plate({Vector3d(0, 0, 0), {1, 0, 0.1}, {1.2, 0.7, -0.1}, {0, 0.6, 0.2}}, 6, 5, 0.01),
      {.E = 2e11, .nu = 0.3, .rho = 8000});
  model.masses.push_back({0, {.mass = 5, .offset = {-0.1, 0.2, 0.3}}});
  const SolvedModes modes = find_modes(model, 12);
  const FreeMass free = free_mass(model, modes.system.map, all_free(modes.system), modes.system.M);
  const MatrixXd masses = effective_masses(free, modes.system.M, modes.set.Phi);
  for (int j = 0; j < 6; ++j) {
    EXPECT_NEAR(masses.col(j).head(6).sum() / free.total[j], 1, 1e-6) << dof_name(j);
    EXPECT_LT(masses.col(j).tail(masses.rows() - 6).sum() / free.total[j], 1e-6) << dof_name(j);
  }
}

// What is free: mass, centre and inertia of a plate with nothing held.
TEST(EffectiveMass, free_mass_of_a_plate) {
  const Model model =
      shell_model(mesh_plate({Vector3d(1, 2, 3), {3, 2, 3}, {3, 3, 3}, {1, 3, 3}}, 4, 2, 0.1),
                  {.E = 2e11, .nu = 0.3, .rho = 1000});
  const System system = assemble(model);
  const FreeMass free = free_mass(model, system.map, all_free(system), system.M);
  EXPECT_NEAR(free.mass, 200, 1e-10);
  EXPECT_LT((free.centre - Vector3d(2, 2.5, 3)).norm(), 1e-12);
  EXPECT_NEAR(free.total[3], 200 * (1 + 0.01) / 12, 1e-9);
  EXPECT_NEAR(free.total[4], 200 * (4 + 0.01) / 12, 1e-9);
  EXPECT_NEAR(free.total[5], 200 * (4 + 1.) / 12, 1e-9);
}

} // namespace
