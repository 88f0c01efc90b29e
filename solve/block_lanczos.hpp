// The pairs of lanczos.hpp by Lanczos with blocks of vectors, for large models: a solve with eight
// right-hand sides costs a third of eight solves, the cores share it, and a pair of equal
// eigenvalues is found at once.
//
//   S V = V T + Q R E'        S the operator of shift_invert.hpp, V orthonormal, E the last block
//
// Every block is made orthogonal to all before it, twice, so T = V' S V is what it is in exact
// arithmetic, and the residual of a Ritz pair (theta, V s) is |R E' s|. A full basis restarts with
// the best Ritz vectors and the block Q (thick restart: Wu & Simon, SIAM J. Matrix Anal. Appl. 22
// (2000) 602; blocks: Grimes, Lewis & Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228).
// A block whose columns depend on each other shrinks; where nothing is left the space is invariant
// and is gone on with from new directions.
#pragma once

#include "solve/lanczos.hpp"

namespace plica {

EigenPairs block_lanczos(const SparseMatrix& M, const SparseFactor& factor, double sigma,
                         const LanczosSettings& settings);

} // namespace plica
