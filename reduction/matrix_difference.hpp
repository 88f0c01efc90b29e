// What the matrices of a changed model have more than those of the nominal one.
#pragma once

#include "solve/assembly.hpp"

namespace plica {

// A mass that takes part in motions that are sums over DOFs of nodes, kg, and a spring from each of
// them to the ground, N/m.
struct OnMotion {
  std::vector<int> nodes;
  Eigen::MatrixXd rows; // a motion each: its factors on the six DOFs of every node
  double mass = 0, stiffness = 0;
};

// On the mean translation of nodes along x, y and z.
OnMotion on_mean_motion(std::vector<int> nodes, double mass, double stiffness);

// One DOF of a motion that is a sum over DOFs, each times the coefficient of its change: a spring
// of 1 N/m to the ground, or a mass of 1 kg, on that motion adds coefficient_i coefficient_j
// between DOFs i and j. The terms of one motion follow each other. A resonator is a mass that hangs
// on the motion by a spring: coefficients are those of the spring, and behind them comes a term
// without nodes whose coefficient is its frequency, rad/s.
struct MotionTerm {
  enum class Of { spring, mass, resonator };
  std::vector<int> nodes; // their mean; of several at once
  int dof = 0;            // 0 to 5
  Of of = Of::spring;
  bool begins = false; // a motion
};

// Over the independent DOFs that differ.
struct MatrixDifference {
  SparseMatrix K, M;     // lower triangles
  std::vector<int> dofs; // independent ones
};

// What the mean of one DOF of nodes is over the independent ones, as a column over `dofs`.
struct DofColumn {
  std::vector<int> dofs;
  Eigen::VectorXd factors;
};
DofColumn dof_column(const DofMap& map, const std::vector<int>& nodes, int dof);

// From the elements that differ, or, where most do or the shape is another, by assembling anew.
// `system`: that of the nominal model. Throws std::invalid_argument when the unknowns differ.
MatrixDifference matrix_difference(const Model& changed, const Model& nominal, const System& system,
                                   const std::vector<OnMotion>& on_motion);

// The first less the two others; entries that rounding leaves are dropped, and DOFs without any.
MatrixDifference difference_of(const MatrixDifference& both, const MatrixDifference& a,
                               const MatrixDifference& b, int unknowns);

} // namespace plica
