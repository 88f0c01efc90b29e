// A = P' L S L' P with S of +1 and -1: Cholesky for matrices that are not definite, by supernodes.
//
// Left-looking (Ng & Peyton, SIAM J. Sci. Comput. 14 (1993) 1034), with the supernodes that CHOLMOD
// finds, so it costs what one Cholesky factorisation costs, whatever the signs. It does not pivot
// for size: where a pivot is small beside what it came from, L grows and digits are lost. growth()
// says how much, after which the user decides whether to believe it.
#pragma once

#include "solve/assembly.hpp"

namespace plica {

class SignedCholesky {
public:
  // Factors a symmetric matrix (lower triangle) in an order of its rows, that of a SparseFactor.
  // Throws std::runtime_error when memory is short.
  SignedCholesky(const SparseMatrix& lower, const Eigen::VectorXi& order);

  bool ok() const { return ok_; } // false: a pivot is zero or not finite
  int negative_pivots() const { return negative_; }

  // Per row of A: sum of the squares of L in it. The factor is that of A + E with
  //   |E_ij| <= c eps sqrt(squares_i squares_j),   c the terms in the longest row
  // (as of Cholesky, where squares_i = A_ii: Higham, Accuracy and Stability, 2nd ed., th. 10.3).
  const Eigen::VectorXd& squares() const { return squares_; }

private:
  bool ok_ = false;
  int negative_ = 0;
  Eigen::VectorXd squares_;
};

} // namespace plica
