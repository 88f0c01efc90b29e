// Number of eigenvalues of K phi = lambda M phi below sigma, by Sylvester's law of inertia.
//
// count_below: the negative pivots of a supernodal factor L S L' of A = K - sigma M
// (solve/signed_cholesky.hpp). It does not pivot for size: it is believed where its errors, which
// the rows of L bound, move no given vector's eigenvalue by a tenth of its way to sigma. Where not,
// Haynsworth's additivity: a few DOFs p are taken out where the found modes are large (pivoted QR
// of the mass-scaled vectors); Cholesky of the rest proves that it has no eigenvalue below sigma;
// the negative eigenvalues of the Schur complement
//
//   S = A_pp - A_pr A_rr^-1 A_rp
//
// are then all there are (Haynsworth, Linear Algebra Appl. 1 (1968) 73-81). Vectors only steer: a
// wrong or missing vector costs time, never the truth of the count. When no choice leaves a
// definite rest, the count comes from LDL'.
//
// count_below_ldlt: negative pivots of a simplicial LDL'. Slower, independent, not pivoted for
// size; the referee in tests. count_below_by_schur: the second way alone.
#pragma once

#include "solve/sparse_factor.hpp"

#include <optional>

namespace plica {

struct InertiaCount {
  std::optional<int> below; // empty: no statement could be made
  double margin = 0;        // by Schur complement: smallest |eigenvalue| of S / largest
  int removed = 0;          // DOFs taken out
  std::string reason;       // why empty
};

// `factor` has the pattern of K (and M) analysed; its numbers are overwritten.
InertiaCount count_below(const SparseMatrix& K, const SparseMatrix& M, double sigma,
                         const Eigen::MatrixXd& vectors, SparseFactor& factor);

InertiaCount count_below_by_schur(const SparseMatrix& K, const SparseMatrix& M, double sigma,
                                  const Eigen::MatrixXd& vectors, SparseFactor& factor);

InertiaCount count_below_ldlt(const SparseMatrix& K, const SparseMatrix& M, double sigma);

// K - sigma M; both lower triangles of one pattern.
SparseMatrix shifted(const SparseMatrix& K, const SparseMatrix& M, double sigma);

} // namespace plica
