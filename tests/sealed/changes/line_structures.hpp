// The structures of the suite "changes" by name, and the steel of all of them.
#pragma once

#include "structures.hpp"

namespace sealed {

namespace steel {
constexpr double E = 210e9, nu = 0.3, rho = 7850;
}

struct PlateShape {
  double length = 0.3, width = 0.2, thickness = 0.003; // m
  double sensor_mass = 0.004;                          // kg
};
std::unique_ptr<ChangedStructure> clamped_plate(const PlateShape& shape);

void add_line_structures(std::vector<std::unique_ptr<ChangedStructure>>& all);
void add_frame(std::vector<std::unique_ptr<ChangedStructure>>& all);
void add_plate(std::vector<std::unique_ptr<ChangedStructure>>& all);
void add_bellows(std::vector<std::unique_ptr<ChangedStructure>>& all);

} // namespace sealed
