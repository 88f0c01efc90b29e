// SLEPc's Krylov-Schur on the operator (K - sigma M)^-1 M, symmetric in the inner product of M.
#pragma once

#include "engine/mumps_factor.hpp"

#include <slepceps.h>

namespace plica {

struct EigenColumns {
  Eigen::VectorXd lambda; // increasing
  Eigen::MatrixXd Phi;    // own rows, mass-normalised
  bool converged = false;
  std::string reason; // why not
};

// Collective: the `count` eigenvalues next above sigma, which lies below all. `factor`: of
// K - sigma M.
EigenColumns krylov_schur(const DistributedMatrix& K, const DistributedMatrix& M,
                          const MumpsFactor& factor, double sigma, int count, unsigned seed,
                          const Ranks& ranks);

// What a solver found, in order; `most`: of them at most so many, -1 = all.
EigenColumns eigen_columns(EPS eps, const DistributedMatrix& K, const DistributedMatrix& M,
                           int most, const Ranks& ranks);

// Own rows of a vector that is the same on any number of ranks.
Eigen::MatrixXd start_vector(const DistributedMatrix& K, unsigned seed);

} // namespace plica
