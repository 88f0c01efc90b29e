// What a run needs of memory by the way it is solved, known before its matrices are assembled.
//
// Fitted to measured runs of bellows (docs/speed.md, bench/memory.mjs): within a tenth from 60 k to
// 380 k unknowns on the full mesh and to 5 M by symmetry, with 10 to 100 modes.
#pragma once

#include "model/shape/built_case.hpp"
#include "reduction/substructures.hpp"
#include "run/routes/symmetric_view.hpp"

#include <string>

namespace plica {

double memory_of_full_mesh(double unknowns, int modes); // bytes
double memory_by_symmetry(double unknowns, int modes);  // bytes
double factor_entries_of_full_mesh(double unknowns);    // Cholesky, nested dissection

struct MemoryNeed {
  double bytes = 0;
  std::string instead; // what would need less, a sentence
};

// By symmetry, by superelements or on the full mesh, as choose_route() takes it. `view`: what
// symmetric_view() finds of the model and the symmetry that the analyses ask for; of no matter to
// superelements. `seen`: fields are those of some nodes alone (seen_case.hpp).
MemoryNeed memory_need(const BuiltCase& built, const Analyses& analyses, const SymmetricView& view,
                       bool seen = false);

// Of superelements that are cut already.
double memory_of_superelements(const CutModel& pieces, double unknowns, const Analyses& analyses,
                               bool seen); // bytes

// Throws TooLarge (mesh/machine_memory.hpp) when the machine does not have it.
void require_memory_for(const BuiltCase& built, const Analyses& analyses, const SymmetricView& view,
                        bool seen = false);

// As of superelements that are cut already.
void require_memory_for(const BuiltCase& built, const CutModel& pieces, const Analyses& analyses,
                        bool seen);

} // namespace plica
