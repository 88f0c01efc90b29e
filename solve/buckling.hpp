// Linearised buckling loads.
//
//   (K_0 + gamma K_s) phi = 0
//
// K_0: stiffness at rest; K_s: what stress and pressure add to it (StiffnessPart::by_stress), in
// the first order of the loads, which gamma multiplies (Bathe, Finite Element Procedures,
// sec. 6.8.2; what displacements before buckling do to the stiffness is left out, as is usual: they
// are small). As -K_s phi = mu K_0 phi, gamma = 1/mu, it is solved by Lanczos with the factor of
// K_0. That none is missing is proved by the inertia of K_0 + gamma* K_s at a gamma* above them.
#pragma once

#include "solve/assembly.hpp"

#include <string>

namespace plica {

struct BucklingLoads {
  Eigen::VectorXd factor; // gamma, increasing, above 0
  Eigen::MatrixXd shapes; // columns; largest component 1
  bool proved = false;
  double proved_below = 0; // gamma*
  std::string reason;      // why not proved
};

// Lower triangles. `beyond`: factors above it are of no interest and left out. Throws
// std::runtime_error when K_0 is not positive definite: nothing holds the part.
BucklingLoads buckling_loads(const SparseMatrix& K_rest, const SparseMatrix& K_stress, int count,
                             double beyond);

} // namespace plica
