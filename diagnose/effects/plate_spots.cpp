#include "diagnose/effects/plate_spots.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

using Eigen::Vector3d;

constexpr int most_lines = 5; // either way

// Numbers of the nodes on the lines across an edge of so many elements, the edges among them.
std::set<int> on_lines(int elements) {
  std::set<int> numbers;
  const int steps = std::min(elements, most_lines - 1);
  for (int k = 0; k <= steps; ++k) numbers.insert(int(std::lround(double(k) * elements / steps)));
  return numbers;
}

std::string percent(int i, int of) {
  return "[" + std::to_string(std::lround(100. * i / of)) + "]";
}

// Of the bilinear surface through the corners, at shares of the way along edges 1 and 2.
Vector3d normal_at(const Plate& plate, double a, double b) {
  const auto corner = [&](std::size_t k) {
    return Vector3d(Vector3d::Map(plate.corners[k].data()));
  };
  const Vector3d along = (1 - b) * (corner(1) - corner(0)) + b * (corner(2) - corner(3)),
                 across = (1 - a) * (corner(3) - corner(0)) + a * (corner(2) - corner(1));
  return along.cross(across).normalized();
}

// Nodes and DOFs that supports or caps on the table hold.
std::set<std::pair<int, int>> held_dofs(const BuiltCase& built) {
  const std::set<int> held(built.held_nodes.begin(), built.held_nodes.end());
  std::set<std::pair<int, int>> found;
  for (const Constraint& c : built.model.constraints)
    if (std::all_of(c.terms.begin(), c.terms.end(),
                    [&](const ConstraintTerm& t) { return held.contains(t.node); }))
      found.emplace(c.node, c.dof);
  return found;
}

bool moves_along_normal(const Spot& spot, const std::set<std::pair<int, int>>& held) {
  constexpr double felt = 1e-3;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs((*spot.normal)[axis]) > felt && !held.contains({spot.touched, axis})) return true;
  return false;
}

} // namespace

std::vector<Spot> plate_spots(const BuiltCase& built, const std::string& part, const Plate& plate) {
  std::vector<Spot> found;
  const std::vector<int>& nodes =
      built.model.mesh.sets.at(part + ".all"); // row by row along edge 1
  const int along = plate.elements[0], across = plate.elements[1];
  if (along < 1 || across < 1 || int(nodes.size()) != (along + 1) * (across + 1)) return found;
  for (int j : on_lines(across))
    for (int i : on_lines(along)) {
      const int node = nodes[std::size_t(j * (along + 1) + i)];
      found.push_back({.place = part + ".spot" + percent(i, along) + percent(j, across),
                       .nodes = {node},
                       .touched = node,
                       .normal = normal_at(plate, double(i) / along, double(j) / across)});
    }
  const auto held = held_dofs(built);
  std::erase_if(found, [&](const Spot& spot) { return !moves_along_normal(spot, held); });
  return found;
}

} // namespace plica
