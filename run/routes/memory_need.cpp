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

} // namespace

// The largest part is reduced while the whole mesh and its pieces are held; then the modes are
// recovered on it, or on the nodes that are seen.
double memory_of_superelements(const CutModel& pieces, double unknowns, const Analyses& analyses,
                               bool seen) {
  constexpr int modes_of_a_part = 60;
  constexpr int modes_of_a_band = 100;
  const double of_symmetric_part = seen ? 490 : 200; // bytes an unknown
  const int modes =
      modes_of(analyses) > 0 || !analyses.modes ? modes_of(analyses) : modes_of_a_band;
  double largest = 0;
  std::vector<const Substructure*> different;
  for (const Substructure& part : pieces.parts) {
    if (std::any_of(different.begin(), different.end(),
                    [&](const Substructure* other) { return is_copy(*other, part); }))
      continue;
    different.push_back(&part);
    const double own = unknowns_of(part.model);
    const bool symmetric =
        analyses.symmetry != Symmetry::off &&
        std::holds_alternative<CyclicModel>(symmetric_view(part.model, Symmetry::automatic));
    largest = std::max(largest, symmetric ? of_symmetric_part * own
                                          : memory_of_full_mesh(own, modes_of_a_part));
  }
  if (seen) {
    constexpr double of_meshes = 110;     // bytes an unknown: the whole and its pieces
    constexpr double most_seen = 6 * 3e4; // unknowns
    return largest + program + of_meshes * unknowns + 8 * std::min(unknowns, most_seen) * modes;
  }
  return largest + memory_by_symmetry(unknowns, modes);
}

namespace {

MemoryNeed need_of_superelements(const BuiltCase& built, const CutModel& pieces,
                                 const Analyses& analyses, bool seen) {
  return {memory_of_superelements(pieces, unknowns_of(built.model), analyses, seen),
          seen ? "Caps that cut the part into more superelements and a coarser mesh need less."
               : "Results without the shapes of all nodes ('--only json'), caps that cut the part "
                 "into more superelements and a coarser mesh need less."};
}

// Whichever way, the machine has it.
bool fits_anyhow(const BuiltCase& built, const Analyses& analyses) {
  constexpr int most_modes = 60; // of a part that is reduced
  return memory_of_full_mesh(unknowns_of(built.model), std::max(modes_of(analyses), most_modes)) <
         memory_limit().bytes;
}

void require(const BuiltCase& built, const MemoryNeed& need) {
  require_memory(need.bytes,
                 "the run of this model (" + std::to_string(long(unknowns_of(built.model))) +
                     " unknowns)",
                 need.instead);
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

MemoryNeed memory_need(const BuiltCase& built, const Analyses& analyses, const SymmetricView& view,
                       bool seen) {
  const double unknowns = unknowns_of(built.model);
  if (analyses.reduction)
    return need_of_superelements(built, cut_between_caps(built, analyses.symmetry != Symmetry::off),
                                 analyses, seen);
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

void require_memory_for(const BuiltCase& built, const Analyses& analyses, const SymmetricView& view,
                        bool seen) {
  if (!fits_anyhow(built, analyses)) require(built, memory_need(built, analyses, view, seen));
}

void require_memory_for(const BuiltCase& built, const CutModel& pieces, const Analyses& analyses,
                        bool seen) {
  if (!fits_anyhow(built, analyses))
    require(built, need_of_superelements(built, pieces, analyses, seen));
}

} // namespace plica
