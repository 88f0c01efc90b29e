#include "io/report/drawn_shapes.hpp"

#include "io/tables/text.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {

std::size_t shown_modes(const Results& results) {
  return std::min(results.modes.size(), results.shapes.size());
}

Surface surface_of(const Results& results) {
  Surface s;
  s.nodes = results.mesh.nodes;
  for (const ShellQuad& q : results.mesh.quads)
    for (const auto& half : halves(q.nodes)) s.triangles.push_back(half);
  for (const ShellTriangle& t : results.mesh.triangles) s.triangles.push_back(t.nodes);
  s.lines = results.lines;
  return s;
}

double drawn_scale(const Results& results, std::size_t mode) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : results.mesh.nodes) box.extend(x);
  Eigen::MatrixXd u = results.shapes[mode].leftCols(3);
  u = u.array().isFinite().select(u, 0).eval();
  double largest = u.rowwise().norm().maxCoeff();
  // Where nodes hardly move, as in torsion of a straight line, the skin of the tubes does.
  constexpr double thin = 1e-3; // of the size: what is no tube
  const Eigen::MatrixXd& shape = results.shapes[mode];
  for (std::size_t i = 0; shape.cols() >= 6 && i < results.lines.size(); ++i)
    for (const int node : results.lines[i]) {
      const double radius = i < results.line_radii.size() ? results.line_radii[i] : 0;
      const double turn = shape.row(node).segment<3>(3).norm();
      if (std::isfinite(turn))
        largest = std::max(largest, turn * std::max(radius, thin * box.diagonal().norm()));
    }
  return largest > 0 ? drawn_motion * box.diagonal().norm() / largest : 1;
}

std::vector<SurfaceShape> drawn_shapes(const Results& results) {
  require_one_row_per_node(results);
  std::vector<SurfaceShape> shapes;
  for (std::size_t m = 0; m < shown_modes(results); ++m) {
    Eigen::MatrixXd u = results.shapes[m].leftCols(3);
    u = drawn_scale(results, m) * u.array().isFinite().select(u, 0).eval();
    shapes.push_back({fmt::format("mode {}", m + 1), std::move(u)});
  }
  return shapes;
}

} // namespace plica
