// Motions that supports, caps on the table or a deck itself hold.
#pragma once

#include "diagnose/effects/spot.hpp"
#include "model/shape/build.hpp"

#include <set>
#include <utility>

namespace plica {

class HeldMotions {
public:
  explicit HeldMotions(const BuiltCase& built);
  // Whether a spot may move, along its normal where it has one.
  bool let_move(const Spot& spot) const;

private:
  std::set<std::pair<int, int>> held_; // nodes and DOFs
};

} // namespace plica
