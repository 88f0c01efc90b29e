// A = P' L S L' P with S of +1 and -1: Cholesky for matrices that are not definite, by supernodes.
//
// Left-looking (Ng & Peyton, SIAM J. Sci. Comput. 14 (1993) 1034), with the supernodes that CHOLMOD
// finds, so it costs what one Cholesky factorisation costs, whatever the signs; the cores share the
// subtrees of supernodes (solve/supernodes.hpp), with the same numbers on any number of threads. It
// does not pivot for size: where a pivot is small beside what it came from, L grows and digits are
// lost. squares() says how much, after which the user decides whether to believe it.
#pragma once

#include "solve/supernodes.hpp"

#include <memory>

namespace plica {

class SignedCholesky {
public:
  // Factors a symmetric matrix (lower triangle) in an order of its rows, that of a SparseFactor.
  // Throws std::runtime_error when memory is short.
  SignedCholesky(const SparseMatrix& lower, const Eigen::VectorXi& order);
  // With supernodes of the same pattern that are known.
  SignedCholesky(const SparseMatrix& lower, std::shared_ptr<const Supernodes> nodes);

  bool ok() const { return ok_; } // false: a pivot is zero or not finite
  int negative_pivots() const { return negative_; }

  // Per row of A: sum of the squares of L in it. The factor is that of A + E with
  //   |E_ij| <= c eps sqrt(squares_i squares_j),   c the terms in the longest row
  // (as of Cholesky, where squares_i = A_ii: Higham, Accuracy and Stability, 2nd ed., th. 10.3).
  const Eigen::VectorXd& squares() const { return squares_; }

  // That ok() and no row has grown a millionfold beside its stiffness (K: lower triangle).
  bool keeps_digits(const SparseMatrix& K) const;

  // A^-1 b. Needs ok().
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

private:
  std::shared_ptr<const Supernodes> nodes_;
  std::unique_ptr<double[]> numbers_; // of L, supernode by supernode, by columns
  Eigen::VectorXd sign_, squares_;
  bool ok_ = false;
  int negative_ = 0;
};

} // namespace plica
