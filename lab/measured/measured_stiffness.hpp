// Dynamic stiffness as a rig measured it, number by number (ISO 10846-2 and -3).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plica {

// Blocked transfer stiffness: the force that the part exerts on its held end over the motion of the
// other one. Driving point: the force at the end that moves.
enum class StiffnessKind { transfer, driving_point };
enum class StiffnessQuantity { storage, loss, magnitude, loss_angle };

struct MeasuredStiffness {
  double hertz = 0;
  double amplitude = 0; // of the moving end, m or rad; 0 = small
  int direction = 1;    // 0..5 = x y z rx ry rz
  StiffnessKind kind = StiffnessKind::transfer;
  StiffnessQuantity quantity = StiffnessQuantity::storage;
  double value = 0; // N/m or Nm/rad; loss angle: rad
};

// A table of one rig test, an entry of measured.yaml.
struct MeasuredStiffnessTable {
  std::string file;              // relative to the file that names it
  std::vector<std::string> ends; // caps: the end that moves, the one that is held; none = those two
  std::optional<double> sigma;   // of the complex stiffness, over its magnitude
  std::string state = {};        // of the specimen; empty = as it stands
  std::string note = {};
  std::vector<MeasuredStiffness> numbers = {}; // what the file holds
};

} // namespace plica
