#include "model/shape/unused_nodes.hpp"

#include "solve/couplings.hpp"

#include <algorithm>
#include <set>

namespace plica {
namespace {

using Eigen::Vector3d;

template <class F> void for_each_node_number(Model& model, F&& f) {
  for (ShellQuad& q : model.mesh.quads) std::for_each(q.nodes.begin(), q.nodes.end(), f);
  for (ShellTriangle& t : model.mesh.triangles) std::for_each(t.nodes.begin(), t.nodes.end(), f);
  for (BeamElement& b : model.beams) f(b.node1), f(b.node2);
  for (MassElement& m : model.masses) f(m.node);
  for (BushingElement& b : model.bushings) {
    f(b.node1);
    if (b.node2 >= 0) f(b.node2);
  }
  for (MatrixElement& m : model.matrices) std::for_each(m.nodes.begin(), m.nodes.end(), f);
  for (Constraint& c : model.constraints) {
    const bool holds = std::all_of(c.terms.begin(), c.terms.end(),
                                   [&](const ConstraintTerm& t) { return t.node == c.node; });
    if (holds) continue; // which makes no use of a node
    f(c.node);
    for (ConstraintTerm& t : c.terms) f(t.node);
  }
}

// DOFs with stiffness, or, unless those without are held, with mass.
std::vector<bool> reached_by_elements(const Model& model, bool by_stiffness_alone) {
  std::vector<bool> reached(6 * model.mesh.nodes.size(), false);
  const auto reach = [&](int node, int first = 0, int last = 6) {
    for (int dof = first; dof < last; ++dof) reached[6 * node + dof] = true;
  };
  const auto reach_by_shell = [&](const auto& shell) {
    const ShellSection& wall = model.shells[std::size_t(shell.section)].section;
    for (int node : shell.nodes) reach(node, 0, wall.bending_factor > 0 ? 6 : 3);
  };
  for (const ShellQuad& q : model.mesh.quads) reach_by_shell(q);
  for (const ShellTriangle& t : model.mesh.triangles) reach_by_shell(t);
  for (const BeamElement& b : model.beams) reach(b.node1), reach(b.node2);
  const auto reach_by = [&](const Eigen::MatrixXd& K, const std::vector<int>& nodes) {
    for (Eigen::Index i = 0; i < K.rows(); ++i)
      if (!K.row(i).isZero(0)) reach(nodes[i / 6], int(i % 6), int(i % 6) + 1);
  };
  for (const BushingElement& b : model.bushings)
    reach_by(bushing_matrix(model.mesh, b), {b.node1, b.node2});
  for (const MatrixElement& m : model.matrices) reach_by(m.K, m.nodes);
  if (by_stiffness_alone) return reached;
  for (const MassElement& m : model.masses)
    reach(m.node, 0, m.body.inertia.isZero() && m.body.offset.isZero() ? 3 : 6);
  for (const MatrixElement& m : model.matrices)
    if (m.K.isZero(0)) reach_by(m.M, m.nodes);
  return reached;
}

} // namespace

std::vector<int> drop_unused_nodes(Model& model) {
  std::vector<int> number(model.mesh.nodes.size(), -1);
  for_each_node_number(model, [&](int node) { number[node] = 0; });
  std::vector<Vector3d> kept;
  std::set<int> scalars;
  for (std::size_t node = 0; node < number.size(); ++node)
    if (number[node] == 0) {
      number[node] = static_cast<int>(kept.size());
      if (model.scalar_nodes.contains(int(node))) scalars.insert(number[node]);
      kept.push_back(model.mesh.nodes[node]);
    }
  model.scalar_nodes = std::move(scalars);
  std::erase_if(model.constraints, [&](const Constraint& c) { return number[c.node] < 0; });
  std::vector<Constraint> constraints = std::move(model.constraints);
  model.constraints.clear();
  for_each_node_number(model, [&](int& node) { node = number[node]; });
  for (Constraint& c : constraints) {
    c.node = number[c.node];
    for (ConstraintTerm& t : c.terms) t.node = number[t.node];
  }
  model.constraints = std::move(constraints);
  for (auto& [name, nodes] : model.mesh.sets) {
    for (int& node : nodes) node = number[node];
    std::erase(nodes, -1);
  }
  std::erase_if(model.mesh.sets, [](const auto& set) { return set.second.empty(); });
  model.mesh.nodes = std::move(kept);
  return number;
}

void hold_what_nothing_reaches(Model& model, bool by_stiffness_alone) {
  std::vector<bool> reached = reached_by_elements(model, by_stiffness_alone);
  for (const Constraint& c : model.constraints) {
    reached[6 * c.node + c.dof] = true;
    for (const ConstraintTerm& t : c.terms)
      if (t.node != c.node) reached[6 * t.node + t.dof] = true;
  }
  for (int node = 0; node < static_cast<int>(model.mesh.nodes.size()); ++node)
    for (int dof = 0; dof < 6; ++dof)
      if (!reached[6 * node + dof]) add_support(model, {node}, {dof}, "nothing reaches it");
}

} // namespace plica
