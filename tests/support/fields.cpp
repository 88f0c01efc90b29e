#include "tests/support/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plica::test {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Mesh mesh_surface(const ParametricSurface& surface, int along, int across, double thickness) {
  Mesh mesh;
  const auto node = [&](int i, int j) { return i * (across + 1) + j; };
  std::vector<Vector3d> normals;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j) {
      const SurfacePoint p = surface(double(i) / along, double(j) / across);
      mesh.nodes.push_back(p.position);
      normals.push_back(p.normal.normalized());
      mesh.sets["all"].push_back(node(i, j));
    }
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      ShellQuad quad;
      quad.nodes = {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
      for (int k = 0; k < 4; ++k) quad.directors.col(k) = normals[quad.nodes[k]];
      quad.thickness.setConstant(thickness);
      mesh.quads.push_back(quad);
    }
  for (int j = 0; j <= across; ++j) {
    mesh.sets["a0"].push_back(node(0, j));
    mesh.sets["a1"].push_back(node(along, j));
  }
  for (int i = 0; i <= along; ++i) {
    mesh.sets["b0"].push_back(node(i, 0));
    mesh.sets["b1"].push_back(node(i, across));
  }
  return mesh;
}

Model shell_model(Mesh mesh, const ShellSection& section, MembraneStrain membrane) {
  Model model;
  model.mesh = std::move(mesh);
  model.shells.push_back({.section = section, .membrane = membrane});
  return model;
}

void hold(Model& model, const std::string& set, const std::vector<int>& dofs) {
  add_support(model, model.mesh.sets.at(set), dofs, "support of " + set);
}

void hold_symmetry(Model& model, const std::string& set, int axis) {
  hold(model, set, {axis, 3 + (axis + 1) % 3, 3 + (axis + 2) % 3});
}

void hold_along(Model& model, int node, int first, const Vector3d& direction) {
  int pivot = 0;
  direction.cwiseAbs().maxCoeff(&pivot);
  Constraint row{.node = node, .dof = first + pivot, .terms = {}, .origin = "inclined support"};
  for (int j = 0; j < 3; ++j)
    if (j != pivot && std::abs(direction[j]) > 1e-12)
      row.terms.push_back({node, first + j, -direction[j] / direction[pivot]});
  model.constraints.push_back(row);
}

int node_at(const Mesh& mesh, const Vector3d& position) {
  const auto [node, distance] = nearest_node(mesh, position);
  EXPECT_LT(distance, 1e-6 * (1 + position.norm())) << "no node at " << position.transpose();
  return node;
}

VectorXd no_force(const Model& model) {
  return VectorXd::Zero(dof_count(model));
}

VectorXd area_load(const Model& model, const Vector3d& load) {
  VectorXd force = no_force(model);
  for (const ShellQuad& quad : model.mesh.quads) {
    const auto f = shell_mitc4_area_load(shell_geometry(model.mesh, quad), load);
    for (int i = 0; i < 4; ++i) force.segment<6>(6 * quad.nodes[i]) += f.segment<6>(6 * i);
  }
  return force;
}

void add_edge_force(const Model& model, const std::string& set, int dof, double resultant,
                    VectorXd& force) {
  const std::vector<int>& nodes = model.mesh.sets.at(set);
  const double per_edge = resultant / double(nodes.size() - 1);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    force[6 * nodes[i] + dof] += per_edge / 2;
    force[6 * nodes[i + 1] + dof] += per_edge / 2;
  }
}

VectorXd solve_static(const Model& model, const VectorXd& force) {
  const System system = assemble(model);
  SparseFactor factor(system.K);
  const FactorStatus status = factor.factorise(system.K);
  if (!status.ok) throw std::runtime_error(status.reason);
  return expand(system.map, factor.solve(gather(system.map, force)));
}

void expect_ratio(double value, double wanted, double tolerance, const std::string& what) {
  print_for_table(what, value, wanted, tolerance);
  EXPECT_NEAR(value / wanted, 1, tolerance) << what << ": " << value << ", wanted " << wanted;
}

SolvedModes find_modes(const Model& model, int count) {
  SolvedModes modes;
  modes.system = assemble(model);
  const SparseMatrix &K = modes.system.K, &M = modes.system.M;
  BaseFactor base = factor_below_spectrum(K, M);
  modes.set = plica::find_modes(K, M, {.count = count}, base);
  EXPECT_TRUE(modes.set.proof.passed) << modes.set.proof.reason;
  modes.hertz = modes.set.lambda.unaryExpr(&frequency);
  modes.u = expand(modes.system.map, modes.set.Phi);
  return modes;
}

MatrixXd dense(const SparseMatrix& lower) {
  return symmetric_product(lower, MatrixXd::Identity(lower.rows(), lower.cols()));
}

double observed_order(double coarse, double middle, double fine) {
  return std::log2(std::abs((coarse - middle) / (middle - fine)));
}

} // namespace plica::test
