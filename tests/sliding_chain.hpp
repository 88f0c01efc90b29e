// A connector with friction between two caps, for closed forms.
#pragma once

#include "model/description/case.hpp"

namespace plica::test {

// 20 kN/m with a slider of 60 kN/m and 3 N beside it in each of two elements, along y; 0.5 kg in
// the middle.
inline Case sliding_chain() {
  ConnectorChain chain;
  chain.length = 0.2;
  chain.count = 2;
  chain.spring = {.axial = 2e4, .transverse = 1e6, .bending = 1e3, .torsion = 1e3};
  chain.mass = 1;
  chain.friction.emplace().axial.emplace().sliders = {{6e4, 3}};
  Case data;
  data.name = "sliders";
  data.parts.push_back({"chain", chain});
  data.caps = {{.name = "left", .of = {"chain.left"}}, {.name = "right", .of = {"chain.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  return data;
}

} // namespace plica::test
