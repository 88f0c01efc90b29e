// The blocks of a Craig-Bampton reduction of one system: static shapes and modes with the boundary
// held, and static answers to loads on its inside.
#pragma once

#include "reduction/superelement.hpp"
#include "solve/assembly.hpp"

namespace plica {

struct FixedInterface {
  Eigen::MatrixXd K_bb, M_bb, M_bq;
  double unreduced = 0; // largest number of K on the boundary
  Eigen::VectorXd lambda;
  Eigen::MatrixXd Psi, Phi; // all unknowns x boundary unknowns, x modes
  Eigen::MatrixXd X;        // all unknowns x loads: K_ii^-1 loads, the boundary held
  bool proved = false;
  std::string reason;
};

// `boundary`: increasing numbers of unknowns, may be none; `loads`: all unknowns x loads. Modes up
// to `cutoff` (Hz). `rigid`: rigid motions of a free part, all unknowns x motions; Psi then moves
// by them to the last digit, where the rounding of K would cost eight. Throws std::runtime_error
// when the part is a mechanism with its boundary held.
FixedInterface fixed_interface(const SparseMatrix& K, const SparseMatrix& M,
                               const std::vector<int>& boundary, double cutoff,
                               const Eigen::MatrixXd& loads, const Eigen::MatrixXd& rigid);

// Throws std::invalid_argument naming a node that cannot be a boundary node, or is one twice.
void check_boundary(const Model& model, const std::vector<int>& boundary);

// Matrices of zeros with room for the modes.
Superelement empty_superelement(const Model& model, const std::vector<int>& boundary,
                                Eigen::Index modes);

} // namespace plica
