// A plate of steel, 3 mm thick, that nothing holds yet.
#pragma once

#include "model/description/case.hpp"

namespace plica {

inline Case steel_plate(const std::array<Triple, 4>& corners, const std::array<int, 2>& elements) {
  Case c;
  c.name = "plate";
  c.materials["steel"] = {.E = 193e9, .nu = 0.3, .rho = 8000};
  Plate plate;
  plate.material = "steel";
  plate.corners = corners;
  plate.thickness = 3e-3;
  plate.elements = elements;
  c.parts.push_back({"plate", plate});
  return c;
}

} // namespace plica
