// Lanczos with blocks of vectors, for large models: a solve with eight right-hand sides costs a
// third of eight solves, the cores share it, and a pair of equal eigenvalues is found at once.
//
//   S V = V T + Q R E'        V' B V = I, B S symmetric, E the last block
//
// Every block is made orthogonal to all before it, twice, so T = V' B S V is what it is in exact
// arithmetic, and the residual of a Ritz pair (theta, V s) is |R E' s|. A full basis restarts with
// the best Ritz vectors and the block Q (thick restart: Wu & Simon, SIAM J. Matrix Anal. Appl. 22
// (2000) 602; blocks: Grimes, Lewis & Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228).
// A block whose columns depend on each other shrinks; where nothing is left the space is invariant
// and is gone on with from new directions.
#pragma once

#include "solve/lanczos.hpp"

namespace plica {

class LanczosOperator {
public:
  virtual ~LanczosOperator() = default;
  virtual Eigen::Index rows() const = 0;
  virtual Eigen::MatrixXd weighted(const Eigen::MatrixXd& X) const = 0; // B X
  // S X; BX as from weighted().
  virtual Eigen::MatrixXd applied(const Eigen::MatrixXd& X, const Eigen::MatrixXd& BX) const = 0;
  // Columns drawn from a seed, in the range of S.
  virtual Eigen::MatrixXd random_in_range(int columns, unsigned seed) const = 0;
};

// How many pairs from either end of the spectrum of S: of most negative and of largest theta.
struct RitzRequest {
  int lowest = 0, highest = 0;
  int subspace = 0; // vectors kept; 0: as many as mostly suffice without a restart
  unsigned seed = 1;
};

struct RitzPairs {
  Eigen::VectorXd lowest, highest; // theta from the end of the spectrum inwards
  Eigen::MatrixXd vectors;         // columns: those of lowest, then those of highest
  int converged_lowest = 0, converged_highest = 0;
  bool converged = false; // all
  int operations = 0;     // columns that S was applied to
};

RitzPairs ritz_pairs(const LanczosOperator& S, const RitzRequest& request);

// The pairs of lanczos.hpp: B = I, S the operator of shift_invert.hpp.
EigenPairs block_lanczos(const SparseMatrix& M, const SparseFactor& factor, double sigma,
                         const LanczosSettings& settings);

} // namespace plica
