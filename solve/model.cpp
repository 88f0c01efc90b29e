#include "solve/model.hpp"

#include <array>

namespace plica {

int add_node(Model& model, const Eigen::Vector3d& position) {
  model.mesh.nodes.push_back(position);
  return static_cast<int>(model.mesh.nodes.size()) - 1;
}

int dof_count(const Model& model) {
  return 6 * static_cast<int>(model.mesh.nodes.size());
}

int element_count(const Model& model) {
  return static_cast<int>(model.mesh.quads.size() + model.beams.size() + model.masses.size() +
                          model.bushings.size() + model.matrices.size());
}

ShellGeometry shell_geometry(const Mesh& mesh, const ShellQuad& quad) {
  ShellGeometry g;
  for (int i = 0; i < 4; ++i) g.X.col(i) = mesh.nodes[quad.nodes[i]];
  g.directors = quad.directors;
  g.thickness = quad.thickness;
  return g;
}

const char* dof_name(int dof) {
  constexpr std::array names{"ux", "uy", "uz", "rx", "ry", "rz"};
  return names[dof];
}

} // namespace plica
