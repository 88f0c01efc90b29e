// A place where something may touch a structure or sit on it.
#pragma once

#include "mesh/mesh.hpp"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// Where a mass or a support may be put: nodes that share it, and the one a support touches.
struct Spot {
  std::string place;
  std::vector<int> nodes;
  int touched = 0;
  // Of a part any place of which is looked at (beam_path.hpp, plate_places.hpp).
  bool anywhere = false;
  std::optional<Eigen::Vector3d> normal = {}; // of a plate, which gives way along it alone
};

} // namespace plica
