// The part that a superelement stands for, computed without it.
#pragma once

#include "reduction/certificate.hpp"
#include "run/routes/route.hpp"

namespace plica {

struct Boundary {
  std::vector<std::string> names;
  std::vector<int> nodes;
  int caps = 0; // they come first
};

// Frequencies with the boundary free and held up to `high` (Hz), statics between two caps by
// another way than the reduction. `grounded`: something inside holds it; `nested`: its superelement
// is one of superelements.
PartReference part_reference(const BuiltCase& built, const SymmetricView& view,
                             const Boundary& boundary, double high, bool grounded, bool nested);

} // namespace plica
