#include "diagnose/effects/held_motions.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

// What follows held motions alone is held, and what follows that.
HeldMotions::HeldMotions(const BuiltCase& built) {
  for (int node : built.held_nodes)
    for (int dof = 0; dof < 6; ++dof) held_.emplace(node, dof);
  for (std::size_t before = 0, count = 1; count > before;) {
    before = held_.size();
    for (const Constraint& c : built.model.constraints)
      if (std::all_of(c.terms.begin(), c.terms.end(), [&](const ConstraintTerm& t) {
            return t.factor == 0 || held_.contains({t.node, t.dof});
          }))
        held_.emplace(c.node, c.dof);
    count = held_.size();
  }
}

bool HeldMotions::let_move(const Spot& spot) const {
  constexpr double felt = 1e-3; // of the normal
  for (int axis = 0; axis < 3; ++axis)
    if ((!spot.normal || std::abs((*spot.normal)[axis]) > felt) &&
        !held_.contains({spot.touched, axis}))
      return true;
  return false;
}

} // namespace plica
