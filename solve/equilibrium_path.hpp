// The path of equilibrium beyond the points where its load turns back (snap-through, snap-back), by
// arc length.
//
// Unknown are all displacements and the share of the loads; a step has a length in displacements,
// and its iteration moves across its present direction (Ramm 1981; Crisfield, Non-linear Finite
// Element Analysis 1, ch. 9). On the full mesh; the stiffness may be indefinite on the way (LDL',
// which also counts how often).
#pragma once

#include "solve/base_state.hpp"

namespace plica {

struct PathPoint {
  double share = 0; // of the loads
  int negative = 0; // eigenvalues of the stiffness below zero: 0 where it is stable
  const std::vector<Eigen::Vector3d>* nodes = nullptr; // where they are
};

struct PathResult {
  BaseState state;
  double turned_at = 0; // share of the loads at which they first turned back; 0 = they did not
  int points = 0;
};

struct PathSettings {
  double first_share = 0.05; // of the loads, of the first step
  int most_points = 400;
  double longest = 1e9; // step, against the first
};

// From rest to all of the loads, in a stable state. Throws StateError when the path does not lead
// there. `at_point` hears every point.
PathResult follow_state(const Model& at_rest, const StateLoads& loads,
                        const std::function<void(const PathPoint&)>& at_point,
                        const PathSettings& settings = {});

} // namespace plica
