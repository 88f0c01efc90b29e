#include "mesh/mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plica {

using Eigen::Vector3d;

MeshQuality mesh_quality(const Mesh& mesh) {
  MeshQuality quality;
  const std::size_t shells = mesh.quads.size() + mesh.triangles.size();
  if (shells == 0) return quality;
  const auto add_aspect = [&](double aspect) {
    quality.max_aspect = std::max(quality.max_aspect, aspect);
    quality.mean_aspect += aspect / double(shells);
  };
  quality.min_jacobian = mesh.quads.empty() ? 1 : std::numeric_limits<double>::infinity();
  for (const ShellQuad& quad : mesh.quads) {
    std::array<Vector3d, 4> x;
    for (int i = 0; i < 4; ++i) x[i] = mesh.nodes[quad.nodes[i]];
    const double a = ((x[1] - x[0]).norm() + (x[2] - x[3]).norm()) / 2;
    const double b = ((x[3] - x[0]).norm() + (x[2] - x[1]).norm()) / 2;
    const Vector3d normal = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
    const double warp = std::abs((x[0] - x[1] + x[2] - x[3]).dot(normal)) / 4;
    quality.max_warp = std::max(quality.max_warp, warp / ((a + b) / 2));
    add_aspect(std::max(a, b) / std::min(a, b));
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int i = 0; i < 4; ++i) {
      const double J = (x[(i + 1) % 4] - x[i]).cross(x[(i + 3) % 4] - x[i]).dot(normal);
      low = std::min(low, J);
      high = std::max(high, J);
    }
    quality.min_jacobian = std::min(quality.min_jacobian, low / high);
  }
  for (const ShellTriangle& triangle : mesh.triangles) {
    Vector3d edges;
    for (int i = 0; i < 3; ++i)
      edges[i] = (mesh.nodes[triangle.nodes[(i + 1) % 3]] - mesh.nodes[triangle.nodes[i]]).norm();
    add_aspect(edges.maxCoeff() / edges.minCoeff());
  }
  return quality;
}

std::array<std::array<int, 3>, 2> halves(const std::array<int, 4>& quad) {
  return {{{quad[0], quad[1], quad[2]}, {quad[0], quad[2], quad[3]}}};
}

int append(Mesh& mesh, const Mesh& part, const std::string& name, int section) {
  const int first = static_cast<int>(mesh.nodes.size());
  mesh.nodes.insert(mesh.nodes.end(), part.nodes.begin(), part.nodes.end());
  const auto add = [&](const auto& shells, auto& to) {
    for (auto shell : shells) {
      for (int& node : shell.nodes) node += first;
      shell.section = section;
      to.push_back(shell);
    }
  };
  add(part.quads, mesh.quads);
  add(part.triangles, mesh.triangles);
  for (Ring ring : part.rings) {
    for (int& node : ring.nodes) node += first;
    mesh.rings.push_back(std::move(ring));
  }
  for (const auto& [set, nodes] : part.sets) {
    std::string path = name;
    path.append(".").append(set);
    std::vector<int>& moved = mesh.sets[path];
    for (int node : nodes) moved.push_back(node + first);
  }
  return first;
}

std::pair<int, double> nearest_node(const Mesh& mesh, const Vector3d& point) {
  if (mesh.nodes.empty()) throw std::invalid_argument("nearest_node: the mesh has no nodes");
  int nearest = 0;
  for (int i = 1; i < static_cast<int>(mesh.nodes.size()); ++i)
    if ((mesh.nodes[i] - point).squaredNorm() < (mesh.nodes[nearest] - point).squaredNorm())
      nearest = i;
  return {nearest, (mesh.nodes[nearest] - point).norm()};
}

int nearest_of(const Mesh& mesh, const std::vector<int>& nodes, const Vector3d& point) {
  return *std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) {
    return (mesh.nodes[a] - point).squaredNorm() < (mesh.nodes[b] - point).squaredNorm();
  });
}

} // namespace plica
