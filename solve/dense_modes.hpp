// Eigenpairs of a small system, all at once: M phi = theta (K - sigma M) phi, lambda = sigma +
// 1/theta, by Eigen's dense solver. For superelements and other full matrices of a few hundred
// unknowns it is faster than Lanczos and cannot miss a pair. M may be semidefinite; its infinite
// lambda are left away.
#pragma once

#include "solve/lanczos.hpp"

namespace plica {

// Whether all modes at once are better: few unknowns, or a few hundred and a full K, or massless
// ones among them, which leave Lanczos too small a space.
bool better_dense(const SparseMatrix& K, const SparseMatrix& M);

// All finite pairs; K - sigma M is definite.
EigenPairs dense_modes(const SparseMatrix& K, const SparseMatrix& M, double sigma);

} // namespace plica
