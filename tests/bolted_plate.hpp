// A steel plate of 300 x 200 x 3 mm on bolts near its corners, places on its wall, which one cap
// holds on the table.
#pragma once

#include "model/description/case.hpp"

#include <string>

namespace plica::test {

// The first so many of four bolts; `ends`: those on springs.
inline Case bolted_plate(std::size_t bolts, std::vector<SprungEnd> ends = {}) {
  Case c;
  c.name = "plate";
  c.materials["steel"] = {.E = 210e9, .nu = 0.3, .rho = 7850};
  Plate plate;
  plate.material = "steel";
  plate.corners = {Triple{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}, {0, 0.2, 0}};
  plate.thickness = 3e-3;
  plate.elements = {12, 8};
  plate.places = {{.name = "bolt1", .at = {0.021, 0.022, 0}},
                  {.name = "bolt2", .at = {0.277, 0.018, 0}},
                  {.name = "bolt3", .at = {0.279, 0.181, 0}},
                  {.name = "bolt4", .at = {0.023, 0.177, 0}}};
  c.parts.push_back({"plate", plate});
  Cap table;
  table.name = "table";
  for (std::size_t i = 0; i < bolts; ++i) table.of.push_back("plate.bolt" + std::to_string(i + 1));
  table.ends = std::move(ends);
  c.caps.push_back(table);
  c.mount.push_back({.cap = "table"});
  c.analyses.modes = Modes{.count = 8};
  c.analyses.damping.modal = 0.01;
  return c;
}

} // namespace plica::test
