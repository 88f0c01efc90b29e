// A point that follows the mean of others, of any of their DOFs: RBE3 in general.
//
//   sum w_i c_i |u_i - S_i u|^2 -> min,   u = A^-1 sum S_i' W_i u_i,   A = sum S_i' W_i S_i
//
// S_i u: rigid motion of the point at node i; W_i: weight of the node times the components that
// count along its axes, those of rotations times Lc^2, Lc the mean distance of the nodes from the
// point, which makes the rows the same in every unit of length (MSC Nastran, Quick Reference Guide,
// RBE3, remark 8 and later).
#pragma once

#include "model/description/deck_model.hpp"

namespace plica {

struct AveragedNode {
  int node = 0;
  double weight = 1;
  std::vector<int> dofs; // 0..5, along its axes
};

// Rows along the axes of the point, one for each of `dofs`. Throws std::invalid_argument where the
// nodes do not determine the motion of the point.
std::vector<Constraint> average_rows(const DeckModel& deck, int point, const std::vector<int>& dofs,
                                     const std::vector<AveragedNode>& nodes,
                                     const std::string& origin);

// The same rows, solved for other DOFs than those that lead them, as many (UM of RBE3). Throws
// std::invalid_argument where the rows do not determine them.
struct NodeDof {
  int node = 0, dof = 0;
  auto operator<=>(const NodeDof&) const = default;
};
std::vector<Constraint> solved_for(const std::vector<NodeDof>& following,
                                   const std::vector<Constraint>& rows);

} // namespace plica
