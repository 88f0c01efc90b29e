// What a run over ranks needs of the memory of every node, known before its matrices are assembled.
//
// Fitted to measured peaks of bellows on 1, 2 and 4 ranks (docs/engine.md): mesh, maps and what the
// first rank keeps of fields are on every rank, matrices and factors are shared.
#pragma once

#include "engine/ranks.hpp"

namespace plica {

double memory_of_rank(double unknowns, int ranks); // bytes

// Collective. Throws TooLarge (mesh/machine_memory.hpp) on every rank when the ranks of one node
// need more than it has, with the node and what to do.
void require_memory_of_nodes(double unknowns, const Ranks& ranks);
// Of a model of so many unknowns that needs so many bytes on every rank.
void require_memory_of_nodes(double bytes, double unknowns, const Ranks& ranks);

} // namespace plica
