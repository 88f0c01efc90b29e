#include "places.hpp"

#include <Eigen/Dense>
#include <numbers>

namespace sealed {
namespace {

using Eigen::Triplet;
using std::numbers::pi;

Rows of_triplets(int rows, int unknowns, const std::vector<Triplet<double>>& entries) {
  Rows r(rows, unknowns);
  r.setFromTriplets(entries.begin(), entries.end());
  return r;
}

Rows at_node(int node, const Displacement& displacement, int unknowns) {
  std::vector<Triplet<double>> entries;
  for (int a = 0; a < 3; ++a)
    for (const auto& [unknown, factor] : displacement(node, a))
      entries.emplace_back(a, unknown, factor);
  return of_triplets(3, unknowns, entries);
}

// Rigid motion nearest to that of the circle.
Rows mean_motion(const Circle& circle, const Displacement& displacement, int unknowns) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const auto& x : circle.x) centre += x / double(circle.x.size());
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const auto& x : circle.x) {
    const Eigen::Vector3d d = x - centre;
    inertia += d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose();
  }
  const Eigen::Matrix3d inverse = inertia.inverse();
  std::vector<Triplet<double>> entries;
  for (std::size_t i = 0; i < circle.nodes.size(); ++i) {
    const Eigen::Vector3d d = circle.x[i] - centre;
    for (int a = 0; a < 3; ++a) {
      const Eigen::Vector3d turn = inverse * d.cross(Eigen::Vector3d::Unit(a));
      for (const auto& [unknown, factor] : displacement(circle.nodes[i], a)) {
        entries.emplace_back(a, unknown, factor / double(circle.nodes.size()));
        for (int r = 0; r < 3; ++r) entries.emplace_back(3 + r, unknown, turn[r] * factor);
      }
    }
  }
  return of_triplets(6, unknowns, entries);
}

// Number on the circle of the node at an angle.
int at_angle(const Circle& circle, double angle) {
  const int count = int(circle.nodes.size());
  return (int(std::lround(angle / (2 * pi) * count)) + count) % count;
}

void add_patch(FullWall& wall, const std::string& name, const std::array<Circle, 3>& circles,
               double angle, const Displacement& displacement, int unknowns) {
  const int count = int(circles[1].nodes.size()), middle = at_angle(circles[1], angle);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      wall.read[name + "." + std::to_string(a) + std::to_string(b)] =
          at_node(circles[a].nodes[(middle + b - 1 + count) % count], displacement, unknowns);
  const Eigen::Vector3d here = circles[1].x[middle];
  wall.spacing[name] = {(circles[2].x[middle] - circles[0].x[middle]).norm() / 2,
                        (circles[1].x[(middle + 1) % count] - here).norm()};
}

} // namespace

void add_places(FullWall& wall, const WallSpots& spots, const Displacement& displacement,
                int unknowns) {
  for (const auto& [k, circle] : spots.crowns)
    wall.loaded["ring." + std::to_string(k)] = mean_motion(circle, displacement, unknowns);
  for (const auto& [k, circle] : spots.roots)
    wall.loaded["station." + std::to_string(k)] = mean_motion(circle, displacement, unknowns);
  add_patch(wall, "mid", spots.mid, pi / 2, displacement, unknowns);
  add_patch(wall, "quarter", spots.quarter, 0, displacement, unknowns);
  add_patch(wall, "slant", spots.quarter, pi / 4, displacement, unknowns);
  for (const char* sensor : {"mid", "quarter"})
    wall.loaded[std::string("point.") + sensor] = wall.read.at(std::string(sensor) + ".11");
  const Circle& low = spots.crowns.at(6);
  wall.loaded["point.low"] = at_node(low.nodes[at_angle(low, 3 * pi / 2)], displacement, unknowns);
}

} // namespace sealed
