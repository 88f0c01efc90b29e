// The modes of one run found again in another of the same part on another mesh, by their shapes.
#pragma once

#include "run/results/results.hpp"

#include <vector>

namespace plica {

struct SameMode {
  int index = -1;       // in the other run; -1 = the shape is not among its modes
  double frequency = 0; // Hz; of a degenerate pair the mean of both, as much as each is like it
};

// One per mode of `results`. Shapes are compared at a few hundred nodes and those next to them in
// the other mesh (modal assurance criterion; a degenerate pair of the other run as one space).
std::vector<SameMode> match_modes(const Results& results, const Results& other);

} // namespace plica
