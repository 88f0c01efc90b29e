// The structure of a sparse factor P A P' = L S L': columns of L that have one pattern below them
// are one dense block, a supernode. CHOLMOD finds them.
//
// Supernodes form a forest: each adds to those above it alone. A part of it are subtrees of about
// equal work that share nothing, for the cores to work at side by side; what stands above them is
// the trunk. What a subtree adds to rows of the trunk goes to rows of its own first, and these are
// summed in one order, so that a result does not depend on the number of threads.
#pragma once

#include "solve/assembly.hpp"

#include <cstdint>
#include <vector>

namespace plica {

struct Supernodes {
  std::vector<int> first_column;     // per supernode, and the end
  std::vector<std::int64_t> rows_at; // into rows, per supernode, and the end
  std::vector<std::int64_t> numbers_at;
  std::vector<int> rows; // of a supernode: its columns, then those below, increasing
  // Where each of `rows` is summed: the row itself; in a subtree, for a row of the trunk, one of
  // the rows that follow those of the matrix.
  std::vector<int> sum_at;
  std::vector<int> of_column; // supernode
  Eigen::VectorXi order;      // row of the factor -> row of A

  struct Subtree {
    int first = 0, root = 0; // all supernodes from the one to the other
    int sums = 0;            // first of its rows of sums; as many as lie below the root
  };
  std::vector<Subtree> subtrees;
  std::vector<int> trunk; // increasing
  int sums = 0;           // rows, those of the matrix included

  int count() const { return static_cast<int>(first_column.size()) - 1; }
  int size() const { return first_column.back(); }
  int columns(int s) const { return first_column[s + 1] - first_column[s]; }
  int height(int s) const { return static_cast<int>(rows_at[s + 1] - rows_at[s]); }
  const int* row_numbers(int s) const { return rows.data() + rows_at[s]; }
  const int* sum_numbers(int s) const { return sum_at.data() + rows_at[s]; }
};

// Of a symmetric matrix (lower triangle) in an order of its rows. Throws std::runtime_error when
// memory is short.
Supernodes supernodes(const SparseMatrix& lower, const Eigen::VectorXi& order);

} // namespace plica
