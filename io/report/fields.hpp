// Fields on the faces of the shells as pictures show them: stress of every load case, damage.
#pragma once

#include "run/results/results.hpp"

namespace plica {

struct ShownField {
  std::string name, unit;           // "1 mm axial", "MPa"
  Eigen::VectorXd below, above;     // shares of the largest value per node, 0 to 1
  std::array<std::string, 2> scale; // what the shares 0 and 1 stand for
  std::string spot;                 // name of the place where it is largest
  std::array<double, 3> at{};       // m
  bool spot_above = true;           // its face
};

// Damage first, over six decades; then the stresses in their order, at most `most` in all.
std::vector<ShownField> shown_fields(const Results& results, std::size_t most);

} // namespace plica
