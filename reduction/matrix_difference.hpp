// What the matrices of a changed model have more than those of the nominal one.
#pragma once

#include "solve/assembly.hpp"

namespace plica {

// A mass on the mean translation of nodes, kg, and a spring from it to the ground, N/m.
struct OnMeanMotion {
  std::vector<int> nodes;
  double mass = 0, stiffness = 0;
};

// Over the independent DOFs that differ.
struct MatrixDifference {
  SparseMatrix K, M;     // lower triangles
  std::vector<int> dofs; // independent ones
};

// From the elements that differ, or, where most do or the shape is another, by assembling anew.
// `system`: that of the nominal model. Throws std::invalid_argument when the unknowns differ.
MatrixDifference matrix_difference(const Model& changed, const Model& nominal, const System& system,
                                   const std::vector<OnMeanMotion>& on_mean);

} // namespace plica
