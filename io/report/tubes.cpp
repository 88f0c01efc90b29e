#include "io/report/tubes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

constexpr std::size_t many_tubes = 500, most_tubes = 6000;

} // namespace

bool has_tube(const Results& results, std::size_t line) {
  return results.lines.size() <= most_tubes && line < results.line_radii.size() &&
         results.line_radii[line] > 0;
}

void add_tubes(const Results& results, int first, std::vector<DrawnPoint>& points,
               std::vector<std::array<int, 4>>& quads) {
  const int sides = results.lines.size() > many_tubes ? 8 : 20;
  for (std::size_t i = 0; i < results.lines.size(); ++i) {
    if (!has_tube(results, i)) continue;
    const auto [from, to] = results.lines[i];
    const Eigen::Vector3d along =
        results.mesh.nodes[std::size_t(to)] - results.mesh.nodes[std::size_t(from)];
    if (!(along.norm() > 0)) continue;
    const Eigen::Vector3d a = along.unitOrthogonal(), b = along.normalized().cross(a);
    const int start = first + int(points.size());
    for (const int node : {from, to})
      for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        points.push_back(
            {node, results.line_radii[i] * (std::cos(angle) * a + std::sin(angle) * b)});
      }
    for (int k = 0; k < sides; ++k) {
      const int next = (k + 1) % sides;
      quads.push_back({start + k, start + next, start + sides + next, start + sides + k});
    }
  }
}

Eigen::Vector3d place_of(const Results& results, const DrawnPoint& point) {
  return results.mesh.nodes[std::size_t(point.node)] + point.arm;
}

Eigen::MatrixXd motion_of(const std::vector<DrawnPoint>& points, const Eigen::MatrixXd& shape) {
  Eigen::MatrixXd u(Eigen::Index(points.size()), 3);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Eigen::RowVectorXd own = shape.row(points[p].node);
    const Eigen::Vector3d shift = own.head<3>().transpose();
    const Eigen::Vector3d turn = own.tail<3>().transpose();
    Eigen::Vector3d moved = shift + turn.cross(points[p].arm);
    if (!moved.allFinite()) moved.setZero();
    u.row(Eigen::Index(p)) = moved.transpose();
  }
  return u;
}

} // namespace plica
