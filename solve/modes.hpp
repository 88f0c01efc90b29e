// Modes K phi = lambda M phi with the proof that none is missing.
//
// Lanczos from a shift below the spectrum: zero when K is definite, else negative and scaled to the
// lowest elastic mode. A few more modes than asked for are computed; sigma is put into the widest
// gap above the modes asked for, and the number of modes found below it must equal the number of
// eigenvalues there by inertia (inertia_count.hpp). A mismatch restarts with another start vector
// and more modes; if it stays, the proof has failed and says so. A degenerate pair is never cut.
//
// The count is of the matrices as they are stored. How far these are from the model is bounded too:
// each entry of K is rounded, which moves lambda_i by at most e_i = eps |phi_i|' |K| |phi_i| (first
// order; entrywise absolute values). A spring 1e16 times stiffer than what it holds makes e_i as
// large as the first elastic lambda, and the modes are then those of another model.
#pragma once

#include "solve/inertia_count.hpp"
#include "solve/lanczos.hpp"
#include "solve/mode_selection.hpp"

#include <map>

namespace plica {

struct ModesProof {
  bool made = false, passed = false;
  double sigma = 0;         // rad2/s2
  int inertia_count = 0;    // eigenvalues below sigma
  int found = 0;            // modes found below sigma
  int removed_dofs = 0;     // taken out for the count
  double max_residual = 0;  // ||K phi - lambda M phi|| / ((lambda + |shift|) ||M phi||)
  double orthogonality = 0; // max |Phi' M Phi - I|
  double rounding = 0;      // largest e_i / max(lambda_i, first elastic lambda)
  std::string reason;       // why not passed
};

// Bounds of what the checks of the modes may reach.
constexpr double residual_limit = 1e-5;
constexpr double orthogonality_limit = 1e-8;
constexpr double rounding_limit = 5e-5; // of lambda: half of it of a frequency

struct ModeSet {
  Eigen::VectorXd lambda; // (2 pi f)^2, increasing
  Eigen::MatrixXd Phi;    // columns, Phi' M Phi = I
  Eigen::VectorXd residual;
  Eigen::VectorXd rounding; // e_i, rad2/s2
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
// Throws ModelError when K - sigma M is not positive definite for any of them: K or M is
// then indefinite, or a DOF has neither stiffness nor mass (named by its number in the message).
BaseFactor factor_below_spectrum(const SparseMatrix& K, const SparseMatrix& M);

int dofs_with_mass(const SparseMatrix& M);

// How many modes Lanczos can find: no more than degrees of freedom with mass, and one less than
// unknowns.
int reachable_modes(const SparseMatrix& M);

// `base` is used for the solves and overwritten by the proof. Gives fewer modes than asked for
// where there are no more. Throws ModelError when nothing has mass.
ModeSet find_modes(const SparseMatrix& K, const SparseMatrix& M, const ModesRequest& request,
                   BaseFactor& base);

void drop_lowest(ModeSet& modes, int below);

// Holds found modes against the inertia count below a sigma chosen among lambda[keep-1] and the
// values above it; `small` as in mode_selection.hpp. Fills the count alone.
ModesProof prove_complete(const SparseMatrix& K, const SparseMatrix& M,
                          const Eigen::VectorXd& lambda, const Eigen::MatrixXd& Phi, int keep,
                          SparseFactor& factor, double small = 0);

// Compares the counts of a proof, `what` being counted: "modes by inertia".
void compare_counts(ModesProof& proof, const std::string& what);

// A proof whose residual, orthogonality or rounding is beyond its limit has not passed: says so in
// numbers, and what the likely cause is. The same for every route.
void judge_accuracy(ModesProof& proof);

// e_i of each column of Phi (see above), rad2/s2.
Eigen::VectorXd rounding_errors(const SparseMatrix& K, const Eigen::MatrixXd& Phi);

// The largest of them relative to their lambda; for those up to `small` (mode_selection.hpp) to the
// first one beyond.
double relative_rounding(const Eigen::VectorXd& lambda, const Eigen::VectorXd& errors,
                         double small);

// `small` of mode_selection.hpp: a tenth of the shift, which lies a tenth of the first elastic
// lambda below zero; 0 without a shift.
double rigid_size(double sigma);

double frequency(double lambda); // Hz; negative rounding of rigid modes gives 0

} // namespace plica
