// Smallest eigenpairs of K phi = lambda M phi by Lanczos in shift-invert mode (Spectra).
//
//   K - sigma M = P' L L' P,   L^-1 P M P' L'^-1 y = theta y,   lambda = sigma + 1/theta,
//   phi = P' L'^-1 y
//
// sigma lies below the spectrum. M may be semidefinite (massless rotations): the operator is
// symmetric in the plain inner product, where its null space has eigenvalue zero and stays apart.
// (With (K - sigma M)^-1 M and the inner product of M, what M does not see grows from rounding in
// each step: Nour-Omid, Parlett, Ericsson & Jensen, Math. Comp. 48 (1987) 663. A free body whose
// rigid modes are 1e6 times nearer to the shift than its elastic ones then overflows.) Vectors are
// M-orthonormal.
#pragma once

#include "solve/sparse_factor.hpp"

namespace plica {

struct EigenPairs {
  Eigen::VectorXd values;  // lambda, increasing
  Eigen::MatrixXd vectors; // columns
  bool converged = false;
  std::string reason; // why not converged
  int operations = 0; // solves with the factor
};

struct LanczosSettings {
  int count = 10;    // pairs wanted
  int subspace = 0;  // vectors kept; 0: as many as mostly suffice without a restart
  unsigned seed = 1; // of the start vector
};

EigenPairs lanczos(const SparseMatrix& M, const SparseFactor& factor, double sigma,
                   const LanczosSettings& settings);

// One pass x = A^-1 M v, A = K - sigma M, removes what is not in the range of the operator; then
// Rayleigh-Ritz on the span of x, whose stiffness x' A x = x' M v needs no product with A.
void purify(EigenPairs& pairs, const SparseMatrix& M, const SparseFactor& factor, double sigma);

} // namespace plica
