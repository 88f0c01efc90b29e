// Smallest eigenpairs of K phi = lambda M phi by Lanczos in shift-invert mode (Spectra).
//
//   (K - sigma M)^-1 M phi = theta phi,   lambda = sigma + 1/theta
//
// K - sigma M is given by its Cholesky factor, so sigma lies below the spectrum. M may be
// semidefinite (massless rotations): the start vector is taken from the range of the operator and
// each vector is passed through it once more at the end. Vectors are M-orthonormal.
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
  int subspace = 0;  // 0 = 3 count + 16; never less than that or 2 count + 20
  unsigned seed = 1; // of the start vector
};

EigenPairs lanczos(const SparseMatrix& M, const SparseFactor& factor, double sigma,
                   const LanczosSettings& settings);

} // namespace plica
