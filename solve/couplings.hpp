// Couplings as rows of constraints.
#pragma once

#include "solve/model.hpp"

namespace plica {

// Kinematic coupling ("spider"): each node follows the rigid motion of the reference node,
// u = u_ref + theta_ref x (x - x_ref), theta = theta_ref, in the chosen DOFs.
void add_kinematic_coupling(Model& model, int reference, const std::vector<int>& nodes,
                            const std::vector<int>& dofs, const std::string& origin);

// Distributing coupling: the reference node follows the nodes without stiffening them, its motion
// being the rigid motion nearest to theirs (least squares of the displacements, weighted; none =
// equal): u_ref + theta_ref x d_i ~ u_i, d_i = x_i - x_ref. Throws std::invalid_argument when the
// nodes do not determine a rotation (fewer than three, or on one line).
void add_distributing_coupling(Model& model, int reference, const std::vector<int>& nodes,
                               const std::string& origin, const std::vector<double>& weights = {});

// Holds DOFs of nodes at zero.
void add_support(Model& model, const std::vector<int>& nodes, const std::vector<int>& dofs,
                 const std::string& origin);

} // namespace plica
