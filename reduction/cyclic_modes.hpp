// Modes of a part with rotational symmetry, harmonic by harmonic, each of them counted.
//
// The harmonics 0 and 1 are solved first; their modes bound what is asked for. A higher harmonic
// whose K - sigma M has a Cholesky factor there has no mode below and is left; the others are
// solved. At the end the eigenvalues below one sigma in a gap are counted by inertia in every
// harmonic, those of pairs twice, and must be as many as were found.
#pragma once

#include "reduction/cyclic_model.hpp"
#include "solve/modes.hpp"

namespace plica {

// One family: its system, what is free of the mount, and the modes found in it.
struct CyclicFamily {
  HarmonicSystem system;
  std::vector<int> free; // of the independent unknowns
  SparseMatrix K, M;     // over the free ones
  double shift = 0;      // below the spectrum; 0 when K is definite
  Eigen::VectorXd lambda, residual, rounding;
  Eigen::MatrixXd Phi; // over the free ones; Phi' M Phi = 1 for the whole part
  double orthogonality = 0;
};

struct CyclicMode {
  int family = 0, column = 0;
  bool sine = false;
  double lambda = 0, residual = 0, rounding = 0;
};

struct CyclicModes {
  std::vector<CyclicFamily> families; // cosine alone where both are the same
  std::vector<CyclicMode> modes;      // increasing lambda; a pair is never cut
  ModesProof proof;
  std::map<std::string, double> timing;
};

// `held`: nodes on the axis whose DOFs are zero. Throws std::runtime_error as
// factor_below_spectrum.
CyclicModes find_cyclic_modes(const CyclicModel& model, const std::vector<int>& held,
                              const ModesRequest& request);

// One family with its free part.
CyclicFamily cyclic_family(const CyclicModel& model, const Harmonic& harmonic,
                           const std::vector<int>& held);

} // namespace plica
