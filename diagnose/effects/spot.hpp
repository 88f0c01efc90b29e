// A place where something may touch a structure or sit on it.
#pragma once

#include "mesh/mesh.hpp"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plica {

// Of a place between others that are looked at: which, and how much each has of it; they add up
// to 1. It is looked at where these come near. Empty: it is looked at.
using PlaceShares = std::vector<std::pair<std::string, double>>;

// Where a mass or a support may be put: nodes that share it, and the one a support touches.
struct Spot {
  std::string place;
  std::vector<int> nodes;
  int touched = 0;
  // Of a part any place of which is looked at (beam_path.hpp, plate_places.hpp).
  bool anywhere = false;
  // Of a wall, which gives way along it alone.
  std::optional<Eigen::Vector3d> normal = {};
  PlaceShares between = {};
  int free_numbers = 0; // that say where it is, since it is one of many: 2 on a wall
  double weight = 1;    // among places of an effect: all spots of a wall weigh as one place
};

} // namespace plica
