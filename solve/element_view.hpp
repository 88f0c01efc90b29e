// Quads, triangles, beams, masses, bushings, matrix elements and pressed ends of a model under one
// running number.
#pragma once

#include "solve/model.hpp"
#include "solve/state_elements.hpp"

#include <tuple>

namespace plica {

struct ElementView {
  const Model& model;

  int size() const { return element_count(model); }

  // f(element e), of whatever kind it is: the one place that knows their order.
  template <std::size_t kind = 0, class F> decltype(auto) with(int e, F&& f) const {
    const auto lists = std::tie(model.mesh.quads, model.mesh.triangles, model.beams, model.masses,
                                model.bushings, model.matrices, model.pressed_ends);
    const auto& list = std::get<kind>(lists);
    if constexpr (kind + 1 < std::tuple_size_v<decltype(lists)>) {
      const int size = static_cast<int>(list.size());
      if (e >= size) return with<kind + 1>(e - size, f);
    }
    return f(list[static_cast<std::size_t>(e)]);
  }

  // Index into Model::components; -1 for a mass, which has no stiffness, and for a pressed end.
  int component(int e) const {
    return with(e, [&](const auto& element) { return component_of(element); });
  }

  // Calls f(nodes, K, M) with the matrices of element e; at a state, K is that to further motion.
  template <class F> void visit(int e, F&& f) const {
    with(e, [&](const auto& element) { pass_matrices(element, f); });
  }

  std::vector<int> nodes(int e) const {
    return with(e, [&](const auto& element) { return nodes_of(element); });
  }

private:
  int component_of(const ShellQuad& q) const { return model.shells[q.section].component; }
  int component_of(const ShellTriangle& t) const { return model.shells[t.section].component; }
  static int component_of(const BeamElement& b) { return b.component; }
  static int component_of(const MassElement&) { return -1; }
  static int component_of(const BushingElement& b) { return b.component; }
  static int component_of(const MatrixElement& m) { return m.component; }
  static int component_of(const PressedEnd&) { return -1; }

  static std::vector<int> nodes_of(const ShellQuad& q) { return {q.nodes.begin(), q.nodes.end()}; }
  static std::vector<int> nodes_of(const ShellTriangle& t) {
    return {t.nodes.begin(), t.nodes.end()};
  }
  static std::vector<int> nodes_of(const BeamElement& b) { return {b.node1, b.node2}; }
  static std::vector<int> nodes_of(const MassElement& m) { return {m.node}; }
  static std::vector<int> nodes_of(const BushingElement& b) {
    return b.node2 < 0 ? std::vector{b.node1} : std::vector{b.node1, b.node2};
  }
  static std::vector<int> nodes_of(const MatrixElement& m) { return m.nodes; }
  static std::vector<int> nodes_of(const PressedEnd& end) { return {end.node}; }

  template <class F> void pass_matrices(const ShellQuad& quad, F& f) const {
    const ShellProperties& p = model.shells[quad.section];
    const Matrix24 M = shell_mitc4_mass(mass_geometry(model, quad), p.section);
    if (model.rest) return f(quad.nodes, state_tangent(model, quad).K, M);
    const ShellGeometry g = shell_geometry(model.mesh, quad);
    f(quad.nodes, shell_mitc4_stiffness(g, p.section, p.membrane), M);
  }
  template <class F> void pass_matrices(const ShellTriangle& triangle, F& f) const {
    const ShellSection& section = model.shells[triangle.section].section;
    const Matrix18 M = shell_mitc3_mass(mass_geometry(model, triangle), section);
    if (model.rest) return f(triangle.nodes, state_tangent(model, triangle).K, M);
    const TriangleGeometry g = shell_geometry(model.mesh, triangle);
    f(triangle.nodes, shell_mitc3_stiffness(g, section), M);
  }
  template <class F> void pass_matrices(const BeamElement& b, F& f) const {
    const BeamGeometry g = beam_geometry(model.mesh, b);
    const Matrix12 M = beam_mass(g, b.section);
    if (model.rest) return f(std::array{b.node1, b.node2}, state_tangent(model, b).K, M);
    f(std::array{b.node1, b.node2}, beam_stiffness(g, b.section), M);
  }
  template <class F> void pass_matrices(const MassElement& m, F& f) const {
    f(std::array{m.node}, Matrix6(Matrix6::Zero()), rigid_mass_matrix(m.body));
  }
  template <class F> void pass_matrices(const BushingElement& b, F& f) const {
    const Eigen::MatrixXd K =
        model.rest ? Eigen::MatrixXd(state_tangent(model, b).K) : bushing_matrix(model.mesh, b);
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(K.rows(), K.cols());
    if (b.node2 < 0) return f(std::array{b.node1}, K, none);
    f(std::array{b.node1, b.node2}, K, none);
  }
  template <class F> void pass_matrices(const MatrixElement& m, F& f) const {
    if (model.rest && model.rest->part == StiffnessPart::by_stress)
      return f(m.nodes, Eigen::MatrixXd(0 * m.K), m.M);
    f(m.nodes, m.K, m.M);
  }
  template <class F> void pass_matrices(const PressedEnd& end, F& f) const {
    const Matrix6 K = model.rest ? state_tangent(model, end).K : Matrix6(Matrix6::Zero());
    f(std::array{end.node}, K, Matrix6(Matrix6::Zero()));
  }
};

} // namespace plica
