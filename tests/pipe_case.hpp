// A straight pipe between two caps, as decks of it are put beside another solver's.
#pragma once

#include "tests/bellows_case.hpp"

namespace plica::test {

// 0.3 m long, 30 mm in radius, of shells that are nearly square; walls in m.
inline Case pipe_of(const std::vector<double>& plies) {
  Case data = verification_case("bellows_a");
  data.name = "pipe";
  Bellows& pipe = bellows_of(data);
  MeridianSection cuff;
  cuff.shape = SectionShape::cuff;
  cuff.length = 0.3;
  cuff.elements = 24;
  pipe.profile = {cuff};
  pipe.root_radius = 0.03;
  pipe.wall = {.plies = plies, .bond = 1};
  pipe.mesh = {.around = 32, .arc = 1, .wall = 24};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  return data;
}

} // namespace plica::test
