// Modes K phi = lambda M phi with the proof that none is missing.
//
// Lanczos from a shift below the spectrum: zero when K is definite, else negative and scaled to the
// lowest elastic mode. A few more modes than asked for are computed; sigma is put into the widest
// gap above the modes asked for, and the number of modes found below it must equal the number of
// eigenvalues there by inertia (inertia_count.hpp). A mismatch restarts with another start vector
// and more modes; if it stays, the proof has failed and says so. A degenerate pair is never cut.
#pragma once

#include "solve/inertia_count.hpp"
#include "solve/lanczos.hpp"

#include <array>
#include <map>

namespace plica {

struct ModesRequest {
  int count = 0;                    // number of modes, or 0 and
  std::array<double, 2> band{0, 0}; // every mode with a frequency in [low, high], Hz
  bool proof = true;
};

struct ModesProof {
  bool made = false, passed = false;
  double sigma = 0;         // rad2/s2
  int inertia_count = 0;    // eigenvalues below sigma
  int found = 0;            // modes found below sigma
  int removed_dofs = 0;     // taken out for the count
  double max_residual = 0;  // ||K phi - lambda M phi|| / ((lambda + |shift|) ||M phi||)
  double orthogonality = 0; // max |Phi' M Phi - I|
  std::string reason;       // why not passed
};

struct ModeSet {
  Eigen::VectorXd lambda; // (2 pi f)^2, increasing
  Eigen::MatrixXd Phi;    // columns, Phi' M Phi = I
  Eigen::VectorXd residual;
  ModesProof proof;
  int operations = 0; // solves
  int restarts = 0;
  std::map<std::string, double> timing; // seconds
};

// Factor of K - sigma M with sigma at or below the whole spectrum.
struct BaseFactor {
  SparseFactor factor;
  double sigma = 0;
};

// Tries sigma = 0; when K is singular (a free body, a mechanism) a small negative sigma.
// Throws std::runtime_error when K - sigma M is not positive definite for any of them: K or M is
// then indefinite, or a DOF has neither stiffness nor mass (named by its number in the message).
BaseFactor factor_below_spectrum(const SparseMatrix& K, const SparseMatrix& M);

// How many modes Lanczos can find: no more than degrees of freedom with mass, and one less than
// unknowns.
int reachable_modes(const SparseMatrix& M);

// `base` is used for the solves and overwritten by the proof. Gives fewer modes than asked for
// where there are no more. Throws std::runtime_error when nothing has mass.
ModeSet find_modes(const SparseMatrix& K, const SparseMatrix& M, const ModesRequest& request,
                   BaseFactor& base);

// Holds found modes against the inertia count below a sigma chosen among lambda[keep-1] and the
// values above it. Fills everything but residual and orthogonality.
ModesProof prove_complete(const SparseMatrix& K, const SparseMatrix& M,
                          const Eigen::VectorXd& lambda, const Eigen::MatrixXd& Phi, int keep,
                          SparseFactor& factor);

double frequency(double lambda); // Hz; negative rounding of rigid modes gives 0

} // namespace plica
