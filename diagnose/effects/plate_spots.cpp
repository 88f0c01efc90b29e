#include "diagnose/effects/plate_spots.hpp"

#include "diagnose/effects/held_motions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

using Eigen::Vector3d;

constexpr int cells_of_spots = 4; // either way

std::string percent(int i, int of) {
  return "[" + std::to_string(std::lround(100. * i / of)) + "]";
}

// Whether the mesh is the grid of nodes that the plate asks for, line by line along edge 1.
bool is_grid(const BuiltCase& built, const std::string& part, const Plate& plate) {
  const auto& [along, across] = plate.elements;
  return along >= 1 && across >= 1 &&
         int(built.model.mesh.sets.at(part + ".all").size()) == (along + 1) * (across + 1);
}

} // namespace

std::set<int> lines_across(int elements, int most) {
  std::set<int> numbers;
  const int steps = std::min(elements, most);
  for (int k = 0; k <= steps; ++k) numbers.insert(int(std::lround(double(k) * elements / steps)));
  return numbers;
}

Triple point_at(const Plate& plate, double a, double b) {
  Triple x{};
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = (1 - b) * ((1 - a) * plate.corners[0][i] + a * plate.corners[1][i]) +
           b * ((1 - a) * plate.corners[3][i] + a * plate.corners[2][i]);
  return x;
}

Vector3d normal_at(const Plate& plate, double a, double b) {
  const auto corner = [&](std::size_t k) {
    return Vector3d(Vector3d::Map(plate.corners[k].data()));
  };
  const Vector3d along = (1 - b) * (corner(1) - corner(0)) + b * (corner(2) - corner(3)),
                 across = (1 - a) * (corner(3) - corner(0)) + a * (corner(2) - corner(1));
  return along.cross(across).normalized();
}

std::vector<Spot> plate_spots(const BuiltCase& built, const std::string& part, const Plate& plate) {
  std::vector<Spot> found;
  const std::vector<int>& nodes =
      built.model.mesh.sets.at(part + ".all"); // row by row along edge 1
  const int along = plate.elements[0], across = plate.elements[1];
  if (!is_grid(built, part, plate)) return found;
  for (int j : lines_across(across, cells_of_spots))
    for (int i : lines_across(along, cells_of_spots)) {
      const int node = nodes[std::size_t(j * (along + 1) + i)];
      found.push_back({.place = part + ".spot" + percent(i, along) + percent(j, across),
                       .nodes = {node},
                       .touched = node,
                       .anywhere = true,
                       .normal = normal_at(plate, double(i) / along, double(j) / across)});
    }
  const HeldMotions held(built);
  std::erase_if(found, [&](const Spot& spot) { return !held.let_move(spot); });
  return found;
}

} // namespace plica
