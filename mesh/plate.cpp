#include "mesh/plate.hpp"

#include "mesh/machine_memory.hpp"

#include <Eigen/Geometry>

namespace plica {
namespace {

using Eigen::Vector3d;

struct Patch {
  std::array<Vector3d, 4> corners;
  Vector3d at(double a, double b) const {
    return (1 - a) * (1 - b) * corners[0] + a * (1 - b) * corners[1] + a * b * corners[2] +
           (1 - a) * b * corners[3];
  }
  Vector3d normal(double a, double b) const {
    const Vector3d along = (1 - b) * (corners[1] - corners[0]) + b * (corners[2] - corners[3]);
    const Vector3d across = (1 - a) * (corners[3] - corners[0]) + a * (corners[2] - corners[1]);
    return along.cross(across).normalized();
  }
};

void name_sets(Mesh& mesh, int along, int across) {
  const auto node = [&](int i, int j) { return j * (along + 1) + i; };
  for (int i = 0; i <= along; ++i) {
    mesh.sets["edge1"].push_back(node(i, 0));
    mesh.sets["edge3"].push_back(node(along - i, across));
  }
  for (int j = 0; j <= across; ++j) {
    mesh.sets["edge2"].push_back(node(along, j));
    mesh.sets["edge4"].push_back(node(0, across - j));
  }
  mesh.sets["corner1"] = {node(0, 0)};
  mesh.sets["corner2"] = {node(along, 0)};
  mesh.sets["corner3"] = {node(along, across)};
  mesh.sets["corner4"] = {node(0, across)};
  for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) mesh.sets["all"].push_back(i);
}

} // namespace

Mesh mesh_plate(const std::array<Vector3d, 4>& corners, int along, int across, double thickness) {
  require_memory(leanest_bytes_per_node * (along + 1.) * (across + 1.),
                 "a plate of " + std::to_string(along) + " by " + std::to_string(across) +
                     " elements",
                 "A coarser mesh needs less.");
  const Patch patch{corners};
  Mesh mesh;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i <= along; ++i)
      mesh.nodes.push_back(patch.at(double(i) / along, double(j) / across));
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i) {
      ShellQuad quad;
      const int first = j * (along + 1) + i;
      quad.nodes = {first, first + 1, first + along + 2, first + along + 1};
      const double a0 = double(i) / along, a1 = double(i + 1) / along;
      const double b0 = double(j) / across, b1 = double(j + 1) / across;
      quad.directors << patch.normal(a0, b0), patch.normal(a1, b0), patch.normal(a1, b1),
          patch.normal(a0, b1);
      quad.thickness.setConstant(thickness);
      mesh.quads.push_back(quad);
    }
  name_sets(mesh, along, across);
  return mesh;
}

} // namespace plica
