#include "mesh/dent.hpp"

#include <Eigen/Geometry>

namespace plica {
namespace {

using Eigen::Vector3d;

// Per node: sum of the normals of the quads that meet there, weighted by area.
std::vector<Vector3d> normals(const Mesh& mesh) {
  std::vector<Vector3d> sum(mesh.nodes.size(), Vector3d::Zero());
  for (const ShellQuad& quad : mesh.quads) {
    const auto& x = mesh.nodes;
    const Vector3d normal =
        (x[quad.nodes[2]] - x[quad.nodes[0]]).cross(x[quad.nodes[3]] - x[quad.nodes[1]]);
    for (int node : quad.nodes) sum[node] += normal;
  }
  return sum;
}

} // namespace

int press(Mesh& mesh, const Dent& dent) {
  const std::vector<Vector3d> before = normals(mesh);
  const Vector3d e = Vector3d(dent.at.x(), 0, dent.at.z()).normalized();
  std::vector<bool> moved(mesh.nodes.size(), false);
  int count = 0;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const double s = (mesh.nodes[node] - dent.at).norm() / dent.radius;
    if (s >= 1) continue;
    mesh.nodes[node] -= dent.depth * (1 - s * s) * (1 - s * s) * e;
    moved[node] = true;
    ++count;
  }
  const std::vector<Vector3d> after = normals(mesh);
  for (ShellQuad& quad : mesh.quads)
    for (int a = 0; a < 4; ++a)
      if (const int node = quad.nodes[a]; moved[node])
        quad.directors.col(a) =
            Eigen::Quaterniond::FromTwoVectors(before[node], after[node]) * quad.directors.col(a);
  return count;
}

} // namespace plica
