// The part that a superelement stands for, computed without it: what its certificate needs.
#pragma once

#include "reduction/certificate.hpp"
#include "run/routes/route.hpp"

namespace plica {

struct Boundary {
  std::vector<std::string> names;
  std::vector<int> nodes;
  int caps = 0; // they come first
};

// `grounded`: something inside holds it. `preloaded`: spectra with the first boundary node held, as
// no rotation of a preloaded part is free. Frequencies up to `high`, Hz.
PartReference part_reference(const BuiltCase& built, const SymmetricView& view,
                             const Boundary& boundary, bool grounded, bool preloaded, double high);

// Its stiffness between two caps, by another way than the reduction. `nested`: the superelement is
// one of superelements.
void add_statics(PartReference& part, const BuiltCase& built, const SymmetricView& view,
                 const Boundary& boundary, bool nested);

} // namespace plica
