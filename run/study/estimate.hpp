// What a run would cost, before it is assembled.
#pragma once

#include "model/shape/built_case.hpp"
#include "run/routes/symmetric_view.hpp"

namespace plica {

struct Estimate {
  int nodes = 0, elements = 0, dofs = 0;
  double memory = 0;  // bytes
  double seconds = 0; // on two cores
};

// By the way that the run is solved, fitted to measured runs (docs/speed.md). `view`: what
// symmetric_view() finds of the model and the symmetry that the analyses ask for. `seen`: fields
// are those of some nodes alone.
Estimate estimate(const BuiltCase& built, const Analyses& analyses, const SymmetricView& view,
                  bool seen = false);

} // namespace plica
