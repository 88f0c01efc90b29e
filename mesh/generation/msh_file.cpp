#include "mesh/generation/msh_file.hpp"

#include "mesh/generation/gmsh_session.hpp"

#include <numeric>

namespace plica {
namespace {

void add_discrete_elements(const Mesh& mesh, const std::vector<std::array<int, 2>>& lines) {
  std::vector<std::size_t> node_tags(mesh.nodes.size());
  std::iota(node_tags.begin(), node_tags.end(), 1);
  std::vector<double> coordinates;
  for (const Eigen::Vector3d& p : mesh.nodes)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  gmsh::model::addDiscreteEntity(2, 1);
  gmsh::model::mesh::addNodes(2, 1, node_tags, coordinates);
  const auto add = [](int dimension, int type, const auto& elements) {
    std::vector<std::size_t> connectivity;
    for (const auto& e : elements)
      for (int node : e) connectivity.push_back(static_cast<std::size_t>(node) + 1);
    if (connectivity.empty()) return;
    if (dimension != 2) gmsh::model::addDiscreteEntity(dimension, 1);
    gmsh::model::mesh::addElementsByType(1, type, {}, connectivity);
  };
  std::vector<std::array<int, 4>> quads;
  for (const ShellQuad& quad : mesh.quads) quads.push_back(quad.nodes);
  std::vector<std::array<int, 3>> triangles;
  for (const ShellTriangle& triangle : mesh.triangles) triangles.push_back(triangle.nodes);
  constexpr int line_type = 1, triangle_type = 2, quad_type = 3;
  add(2, quad_type, quads);
  add(2, triangle_type, triangles);
  add(1, line_type, lines);
}

void add_sets(const Mesh& mesh) {
  constexpr int point_type = 15;
  int tag = 100;
  for (const auto& [name, nodes] : mesh.sets) {
    gmsh::model::addDiscreteEntity(0, ++tag);
    std::vector<std::size_t> points;
    for (int node : nodes) points.push_back(static_cast<std::size_t>(node) + 1);
    gmsh::model::mesh::addElementsByType(tag, point_type, {}, points);
    gmsh::model::setPhysicalName(0, gmsh::model::addPhysicalGroup(0, {tag}), name);
  }
}

} // namespace

void write_msh(const Mesh& mesh, const std::vector<std::array<int, 2>>& lines,
               const std::filesystem::path& file) {
  in_gmsh([&] {
    add_discrete_elements(mesh, lines);
    add_sets(mesh);
    gmsh::option::setNumber("Mesh.SaveAll", 1);
    gmsh::write(file.string());
  });
}

} // namespace plica
