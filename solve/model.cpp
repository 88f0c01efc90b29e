#include "solve/model.hpp"

namespace plica {
namespace {

template <class Geometry, class Shell> Geometry geometry_of(const Mesh& mesh, const Shell& shell) {
  Geometry g;
  for (std::size_t i = 0; i < shell.nodes.size(); ++i)
    g.X.col(Eigen::Index(i)) = mesh.nodes[shell.nodes[i]];
  g.directors = shell.directors;
  g.thickness = shell.thickness;
  return g;
}

} // namespace

int add_node(Model& model, const Eigen::Vector3d& position) {
  model.mesh.nodes.push_back(position);
  return static_cast<int>(model.mesh.nodes.size()) - 1;
}

int dof_count(const Model& model) {
  return 6 * static_cast<int>(model.mesh.nodes.size());
}

int element_count(const Model& model) {
  return static_cast<int>(model.mesh.quads.size() + model.mesh.triangles.size() +
                          model.beams.size() + model.masses.size() + model.bushings.size() +
                          model.matrices.size() + model.pressed_ends.size());
}

ShellGeometry shell_geometry(const Mesh& mesh, const ShellQuad& quad) {
  return geometry_of<ShellGeometry>(mesh, quad);
}

TriangleGeometry shell_geometry(const Mesh& mesh, const ShellTriangle& triangle) {
  return geometry_of<TriangleGeometry>(mesh, triangle);
}

namespace {

template <class Shell> auto with_areas_at_rest(const Model& model, const Shell& shell) {
  auto g = shell_geometry(model.mesh, shell);
  if (model.rest)
    for (std::size_t i = 0; i < shell.nodes.size(); ++i)
      g.X.col(Eigen::Index(i)) = model.rest->nodes[std::size_t(shell.nodes[i])];
  return g;
}

} // namespace

ShellGeometry mass_geometry(const Model& model, const ShellQuad& quad) {
  return with_areas_at_rest(model, quad);
}

TriangleGeometry mass_geometry(const Model& model, const ShellTriangle& triangle) {
  return with_areas_at_rest(model, triangle);
}

BeamGeometry beam_geometry(const Mesh& mesh, const BeamElement& b) {
  return {mesh.nodes[b.node1], mesh.nodes[b.node2], b.up, b.offset1, b.offset2};
}

BeamGeometry beam_at_rest(const Model& model, const BeamElement& b) {
  const auto first = std::size_t(b.node1), second = std::size_t(b.node2);
  const Eigen::Matrix3d back1 = model.rest->turned[first].transpose();
  const Eigen::Matrix3d back2 = model.rest->turned[second].transpose();
  return {model.rest->nodes[first], model.rest->nodes[second], back1 * b.up, back1 * b.offset1,
          back2 * b.offset2};
}

Eigen::MatrixXd bushing_matrix(const Mesh& mesh, const BushingElement& b) {
  if (b.node2 < 0) return ground_bushing_matrix(b.bushing);
  const Eigen::Vector3d &x1 = mesh.nodes[b.node1], &x2 = mesh.nodes[b.node2];
  return bushing_matrix(b.bushing, x1, x2, (x1 + x2) / 2);
}

} // namespace plica
