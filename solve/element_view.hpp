// Quads, triangles, beams, masses, bushings, matrix elements and pressed ends of a model under one
// running number.
#pragma once

#include "solve/model.hpp"
#include "solve/state_elements.hpp"

namespace plica {

struct ElementView {
  const Model& model;

  int size() const { return element_count(model); }

  // Index into Model::components; -1 for a mass, which has no stiffness.
  int component(int e) const {
    const int quads = static_cast<int>(model.mesh.quads.size());
    if (e < quads) return model.shells[model.mesh.quads[e].section].component;
    e -= quads;
    const int triangles = static_cast<int>(model.mesh.triangles.size());
    if (e < triangles) return model.shells[model.mesh.triangles[e].section].component;
    e -= triangles;
    const int beams = static_cast<int>(model.beams.size());
    if (e < beams) return model.beams[e].component;
    e -= beams;
    const int masses = static_cast<int>(model.masses.size());
    if (e < masses) return -1;
    e -= masses;
    const int bushings = static_cast<int>(model.bushings.size());
    if (e < bushings) return model.bushings[e].component;
    e -= bushings;
    return e < static_cast<int>(model.matrices.size()) ? model.matrices[e].component : -1;
  }

  // Calls f(nodes, K, M) with the matrices of element e; at a state, K is that to further motion.
  template <class F> void visit(int e, F&& f) const {
    const int quads = static_cast<int>(model.mesh.quads.size());
    if (e < quads) {
      const ShellQuad& quad = model.mesh.quads[e];
      const ShellProperties& p = model.shells[quad.section];
      const Matrix24 M = shell_mitc4_mass(mass_geometry(model, quad), p.section);
      if (model.rest) return f(quad.nodes, state_tangent(model, quad).K, M);
      const ShellGeometry g = shell_geometry(model.mesh, quad);
      return f(quad.nodes, shell_mitc4_stiffness(g, p.section, p.membrane), M);
    }
    e -= quads;
    const int triangles = static_cast<int>(model.mesh.triangles.size());
    if (e < triangles) {
      const ShellTriangle& triangle = model.mesh.triangles[e];
      const ShellSection& section = model.shells[triangle.section].section;
      const Matrix18 M = shell_mitc3_mass(mass_geometry(model, triangle), section);
      if (model.rest) return f(triangle.nodes, state_tangent(model, triangle).K, M);
      const TriangleGeometry g = shell_geometry(model.mesh, triangle);
      return f(triangle.nodes, shell_mitc3_stiffness(g, section), M);
    }
    e -= triangles;
    if (e < static_cast<int>(model.beams.size())) {
      const BeamElement& b = model.beams[e];
      const BeamGeometry g = beam_geometry(model.mesh, b);
      const Matrix12 M = beam_mass(g, b.section);
      if (model.rest) return f(std::array{b.node1, b.node2}, state_tangent(model, b).K, M);
      return f(std::array{b.node1, b.node2}, beam_stiffness(g, b.section), M);
    }
    e -= static_cast<int>(model.beams.size());
    if (e < static_cast<int>(model.masses.size())) {
      const MassElement& m = model.masses[e];
      return f(std::array{m.node}, Matrix6(Matrix6::Zero()), rigid_mass_matrix(m.body));
    }
    e -= static_cast<int>(model.masses.size());
    if (e < static_cast<int>(model.bushings.size())) {
      const BushingElement& b = model.bushings[e];
      const Eigen::MatrixXd K =
          model.rest ? Eigen::MatrixXd(state_tangent(model, b).K) : bushing_matrix(model.mesh, b);
      const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(K.rows(), K.cols());
      if (b.node2 < 0) return f(std::array{b.node1}, K, none);
      return f(std::array{b.node1, b.node2}, K, none);
    }
    e -= static_cast<int>(model.bushings.size());
    if (e < static_cast<int>(model.matrices.size())) {
      const MatrixElement& m = model.matrices[e];
      if (model.rest && model.rest->part == StiffnessPart::by_stress)
        return f(m.nodes, Eigen::MatrixXd(0 * m.K), m.M);
      return f(m.nodes, m.K, m.M);
    }
    const PressedEnd& end = model.pressed_ends[e - static_cast<int>(model.matrices.size())];
    const Matrix6 K = model.rest ? state_tangent(model, end).K : Matrix6(Matrix6::Zero());
    f(std::array{end.node}, K, Matrix6(Matrix6::Zero()));
  }

  std::vector<int> nodes(int e) const {
    const int quads = static_cast<int>(model.mesh.quads.size());
    if (e < quads) return {model.mesh.quads[e].nodes.begin(), model.mesh.quads[e].nodes.end()};
    e -= quads;
    const int triangles = static_cast<int>(model.mesh.triangles.size());
    if (e < triangles)
      return {model.mesh.triangles[e].nodes.begin(), model.mesh.triangles[e].nodes.end()};
    e -= triangles;
    const int beams = static_cast<int>(model.beams.size());
    if (e < beams) return {model.beams[e].node1, model.beams[e].node2};
    e -= beams;
    const int masses = static_cast<int>(model.masses.size());
    if (e < masses) return {model.masses[e].node};
    e -= masses;
    const int bushings = static_cast<int>(model.bushings.size());
    if (e < bushings) {
      const BushingElement& b = model.bushings[e];
      return b.node2 < 0 ? std::vector{b.node1} : std::vector{b.node1, b.node2};
    }
    e -= bushings;
    if (e < static_cast<int>(model.matrices.size())) return model.matrices[e].nodes;
    return {model.pressed_ends[e - static_cast<int>(model.matrices.size())].node};
  }
};

} // namespace plica
