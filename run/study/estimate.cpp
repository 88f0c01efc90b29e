#include "run/analyses/run.hpp"

#include "model/shape/constraint_clash.hpp"

#include <cmath>

namespace plica {

Estimate estimate(const BuiltCase& built, const Analyses& analyses) {
  Estimate cost;
  cost.nodes = static_cast<int>(built.model.mesh.nodes.size());
  cost.elements = element_count(built.model);
  cost.dofs = eliminate_constraints(built.model).size();
  // Measured on bellows from 30 k to 1 M unknowns: entries and operations of the factor.
  const double n = std::max(1, cost.dofs) / 125000.;
  const double entries = 2.5e7 * std::pow(n, 1.1), operations = 9.7e9 * std::pow(n, 1.37);
  const int modes = analyses.modes ? std::max(analyses.modes->count, 20) : 0;
  cost.memory = 1.5e8 + 8 * entries + 4500. * cost.dofs + 8. * cost.dofs * (5 * modes + 120);
  const double factorisations = modes > 0 ? 2 : 1;
  cost.seconds = 0.3 + 3.2e-6 * cost.dofs + factorisations * operations / 1e10 +
                 (4. * modes + 60) * entries * 2e-9;
  return cost;
}

} // namespace plica
