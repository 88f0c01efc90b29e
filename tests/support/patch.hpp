// The patch of MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20, and fields over it.
//
//   4-----------------3     0.24 x 0.12, E = 1e6, nu = 0.25, t = 0.001
//   | \    8----7   / |
//   |  5 ------- 6    |
//   1-----------------2
#pragma once

#include "tests/support/fields.hpp"

#include <functional>

namespace plica::test {

constexpr double E = 1e6, nu = 0.25, t = 0.001;

using NodeMotion = Eigen::Matrix<double, 6, 1>;
using Field = std::function<NodeMotion(double x, double y)>;

inline Mesh patch_mesh(double thickness) {
  Mesh mesh;
  for (const auto& [x, y] : {std::pair{0., 0.},
                             {0.24, 0.},
                             {0.24, 0.12},
                             {0., 0.12},
                             {0.04, 0.02},
                             {0.18, 0.03},
                             {0.16, 0.08},
                             {0.08, 0.08}})
    mesh.nodes.emplace_back(x, y, 0);
  for (const auto& nodes : std::initializer_list<std::array<int, 4>>{
           {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}) {
    ShellQuad quad{
        .nodes = nodes, .directors = {}, .thickness = Eigen::Vector4d::Constant(thickness)};
    quad.directors.colwise() = Eigen::Vector3d::UnitZ();
    mesh.quads.push_back(quad);
  }
  return mesh;
}

inline Eigen::VectorXd nodal_values(const Mesh& mesh, const Field& field) {
  Eigen::VectorXd u(6 * mesh.nodes.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    u.segment<6>(6 * n) = field(mesh.nodes[n].x(), mesh.nodes[n].y());
  return u;
}

} // namespace plica::test
