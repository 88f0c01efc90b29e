#include "run/study/estimate.hpp"

#include "model/shape/constraint_clash.hpp"
#include "run/routes/memory_need.hpp"

#include <cmath>

namespace plica {

Estimate estimate(const BuiltCase& built, const Analyses& analyses, const SymmetricView& view,
                  bool seen) {
  Estimate cost;
  cost.nodes = static_cast<int>(built.model.mesh.nodes.size());
  cost.elements = element_count(built.model);
  cost.dofs = eliminate_constraints(built.model).size();
  cost.memory = memory_need(built, analyses, view, seen).bytes;
  if (std::holds_alternative<CyclicModel>(view)) { // and so are its superelements
    cost.seconds = 0.5 + (seen ? 2e-6 : 6e-6) * cost.dofs;
    return cost;
  }
  const double n = std::max(1, cost.dofs) / 125000., operations = 9.7e9 * std::pow(n, 1.37);
  const int modes = analyses.modes ? std::max(analyses.modes->count, 20) : 0;
  const double factorisations = modes > 0 ? 2 : 1;
  cost.seconds = 0.3 + 3.2e-6 * cost.dofs + factorisations * operations / 1e10 +
                 (2. * modes + 40) * factor_entries_of_full_mesh(cost.dofs) * 2e-9;
  return cost;
}

} // namespace plica
