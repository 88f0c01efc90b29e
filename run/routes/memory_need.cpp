#include "run/routes/memory_need.hpp"

#include "mesh/machine_memory.hpp"
#include "reduction/substructures.hpp"
#include "run/routes/built_reduced.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

constexpr double program = 1.1e8; // libraries and what does not grow with the mesh

double unknowns_of(const Model& model) {
  return 6. * double(model.mesh.nodes.size());
}

int modes_of(const Analyses& analyses) {
  return analyses.modes ? analyses.modes->count : 0;
}

// The largest part is reduced while the whole mesh is held; then the modes are recovered on it.
double memory_of_superelements(const BuiltCase& built, const Analyses& analyses) {
  constexpr int modes_of_a_part = 60;
  const bool symmetry = analyses.symmetry != Symmetry::off;
  double largest = 0;
  for (const Substructure& part : cut(built.model, interface_nodes(built, symmetry)).parts) {
    const double unknowns = unknowns_of(part.model);
    const bool symmetric = symmetry && std::holds_alternative<CyclicModel>(
                                           symmetric_view(part.model, Symmetry::automatic));
    largest = std::max(largest,
                       symmetric ? 200 * unknowns : memory_of_full_mesh(unknowns, modes_of_a_part));
  }
  return largest + memory_by_symmetry(unknowns_of(built.model), modes_of(analyses));
}

} // namespace

double factor_entries_of_full_mesh(double unknowns) {
  return 2.5e7 * std::pow(std::max(1., unknowns) / 125000, 1.1);
}

double memory_of_full_mesh(double unknowns, int modes) {
  const double vectors = 5. * std::max(modes, 20) + 120;
  return program + 14 * factor_entries_of_full_mesh(unknowns) + (2500 + 8 * vectors) * unknowns;
}

double memory_by_symmetry(double unknowns, int modes) {
  return program + (400 + 24. * modes) * unknowns;
}

MemoryNeed memory_need(const BuiltCase& built, const Analyses& analyses,
                       const SymmetricView& view) {
  const double unknowns = unknowns_of(built.model);
  if (analyses.reduction)
    return {memory_of_superelements(built, analyses),
            "Caps that cut the part into more superelements and a coarser mesh need less."};
  if (std::holds_alternative<CyclicModel>(view))
    return {memory_by_symmetry(unknowns, modes_of(analyses)),
            "A coarser mesh and fewer modes need less."};
  const std::string symmetry =
      analyses.symmetry == Symmetry::off
          ? "'symmetry: automatic' takes far less where the part repeats around its axis; "
          : "By symmetry it would be far less, but " + std::get<std::string>(view) + "; ";
  return {memory_of_full_mesh(unknowns, modes_of(analyses)),
          symmetry + "superelements ('reduction'), a coarser mesh and fewer modes need less."};
}

void require_memory_for(const BuiltCase& built, const Analyses& analyses,
                        const SymmetricView& view) {
  const double unknowns = unknowns_of(built.model);
  constexpr int most_modes = 60; // of a part that is reduced
  if (memory_of_full_mesh(unknowns, std::max(modes_of(analyses), most_modes)) <
      memory_limit().bytes)
    return; // whichever way
  const MemoryNeed need = memory_need(built, analyses, view);
  require_memory(need.bytes,
                 "the run of this model (" + std::to_string(long(unknowns)) + " unknowns)",
                 need.instead);
}

} // namespace plica
