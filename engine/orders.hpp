// What the first rank asks of the others while it runs the analyses.
#pragma once

#include "engine/ranks.hpp"

namespace plica {

enum class Order { end_stiffness, follow, modes, part_fields, direct, done };

// Collective: what the first rank says.
inline Order tell(const Ranks& ranks, Order order) {
  return Order(ranks.broadcast(std::vector<int>{int(order)}).front());
}

} // namespace plica
