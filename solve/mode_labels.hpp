// Names of modes and the convention for degenerate pairs.
#pragma once

#include "solve/model.hpp"

namespace plica {

struct ModeLabel {
  std::string shape;     // one of mode_kind (words/mode_kinds.hpp)
  std::string direction; // "x", "y", "z" or empty
  int order = 0;         // half waves along the axis, from 1; 0 = not counted
  int harmonic = -1;     // circumferential order; -1 = the model has no rings
};

// `u`: one displacement vector over all DOFs (6 per node). From the Fourier series round the
// rings: n = 0 axial or torsion (or breathing, a shell mode), n = 1 transverse, n >= 2 shell.
// Beams and springs along the axis alone: the largest of their motions along, across and about it.
// Another model without rings, and a mode in which the rings stand still, is labelled by the
// direction of its largest effective mass (six numbers).
ModeLabel label_mode(const Model& model, const Eigen::VectorXd& u, bool rigid,
                     const Eigen::Matrix<double, 6, 1>& effective_mass_fraction);

// Turns the two vectors of each degenerate pair (columns of Phi and of the full vectors u) so that
// the first responds as much as possible along x at the sensor nodes, or, where the sensors stand
// still, on the line of each ring that lies along x. Signs: the largest component is positive.
void orient_modes(const Model& model, const std::vector<int>& sensor_nodes,
                  const Eigen::VectorXd& lambda, Eigen::MatrixXd& Phi, Eigen::MatrixXd& u);

} // namespace plica
