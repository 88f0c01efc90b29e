// Many modes by slices of the spectrum (Grimes, Lewis & Simon, SIAM J. Matrix Anal. Appl. 15 (1994)
// 228): Lanczos in shift-invert mode from one shift after the other, each for the modes around it.
//
// One long Lanczos keeps a basis of twice the modes and makes each new vector orthogonal to all of
// it, work and memory that grow with the square of their number; a slice needs a factor and a basis
// of its own alone.
//
//   (K - sigma M)^-1 M v = theta v,   lambda = sigma + 1/theta,   V' M V = I
//
// with K - sigma M = P' L S L' P (solve/signed_cholesky.hpp), whose negative pivots count the
// eigenvalues below sigma: so many must the slice bring the list to, and Lanczos goes on until it
// has them. The next shift lies where the spacing of the last modes puts half a slice. Slices
// overlap: the lowest pairs of one must be the last of the list before, or a mode was missed there,
// and the slice reaches further down; the list changes over in the widest gap of the overlap, so
// that no pair is taken from two slices.
//
// Counts steer; the proof (solve/modes.hpp) counts once more, above all modes.
#pragma once

#include "solve/lanczos.hpp"

#include <optional>

namespace plica {

struct SliceSettings {
  int count = 0;     // pairs wanted, from the lowest
  int slice = 64;    // pairs of one
  unsigned seed = 1; // of the start vectors
};

// `factor`: of K - sigma M with sigma below the spectrum, which serves the first slice. `count`
// pairs or a few more. Vectors are M-orthonormal. Where a slice does not bring what its count says,
// or no count can be believed, `converged` is false and `reason` says why.
EigenPairs spectrum_slices(const SparseMatrix& K, const SparseMatrix& M, const SparseFactor& factor,
                           double sigma, const SliceSettings& settings);

// How many eigenvalues lie below sigma, by the signs of a factor alone: to plan a search, not to
// prove it. `factor` has the pattern of K analysed. Empty where digits were lost.
std::optional<int> count_roughly(const SparseMatrix& K, const SparseMatrix& M, double sigma,
                                 const SparseFactor& factor);

} // namespace plica
