// Stiffness and mass by rows of ranks: every rank assembles the rows of its own nodes.
//
// Nodes go to ranks in their order, so that the ranks have equally many independent DOFs. A rank
// computes the elements that reach one of its rows, those at a border on both sides of it, and adds
// them in their order: no entry is sent, and a row is bitwise the same on any number of ranks.
// Constraints are eliminated as solve/assembly.hpp does. No rank has the whole matrix.
#pragma once

#include "engine/distributed_matrix.hpp"
#include "solve/constraints.hpp"

namespace plica {

struct RowShare {
  int first_node = 0, end_node = 0;
  int first = 0, end = 0; // independent DOFs
};

RowShare share_of(const DofMap& map, const Ranks& ranks);

struct DistributedSystem {
  DistributedMatrix K, M; // over the independent DOFs, whole rows
};

// Collective. An element of no shape is an std::invalid_argument on every rank, whoever met it.
DistributedSystem assemble_rows(const Model& model, const DofMap& map, const Ranks& ranks);

} // namespace plica
