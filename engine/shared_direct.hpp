// The direct solution beside the modal one (run/analyses/direct_solution.hpp) with its frequencies
// over ranks: each rank assembles the whole mesh and factors K + iD - w^2 M at its share of them.
#pragma once

#include "engine/orders.hpp"
#include "run/analyses/direct_solution.hpp"

namespace plica {

// For the first rank, while the others answer(): the answers at all frequencies. Throws
// std::runtime_error with the words of the rank that fails.
DirectSolver direct_over_ranks(const Ranks& ranks);

// On the others: the order `direct` of the first, about the same case.
void answer_direct(const Case& data, const BuiltCase& built, const Ranks& ranks);

} // namespace plica
