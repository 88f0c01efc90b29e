#include "diagnose/effects/held_motions.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

HeldMotions::HeldMotions(const BuiltCase& built) {
  const std::set<int> nodes(built.held_nodes.begin(), built.held_nodes.end());
  for (const Constraint& c : built.model.constraints)
    if (std::all_of(c.terms.begin(), c.terms.end(),
                    [&](const ConstraintTerm& t) { return nodes.contains(t.node); }))
      held_.emplace(c.node, c.dof);
  for (int node : nodes)
    for (int dof = 0; dof < 6; ++dof) held_.emplace(node, dof);
}

bool HeldMotions::leave(const Spot& spot) const {
  constexpr double felt = 1e-3; // of the normal
  for (int axis = 0; axis < 3; ++axis)
    if ((!spot.normal || std::abs((*spot.normal)[axis]) > felt) &&
        !held_.contains({spot.touched, axis}))
      return true;
  return false;
}

} // namespace plica
