#include "run/routes/moved_ends.hpp"

#include "model/description/place_keys.hpp"
#include "run/routes/route.hpp"
#include "solve/model_error.hpp"
#include "solve/statics.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Forces of the springs of a mount on its cap, all DOFs, when the ground behind them moves by one.
VectorXd spring_forces(const BuiltCase& built, const MovedCap& moved) {
  const Model& model = built.model;
  VectorXd F = VectorXd::Zero(dof_count(model));
  const int node = built.cap_nodes.at(moved.cap);
  for (const BushingElement& b : model.bushings)
    if (b.node2 < 0 && b.node1 == node &&
        model.components[std::size_t(b.component)] == mount_key(moved.cap))
      F.segment<6>(6 * Index(node)) += bushing_matrix(model.mesh, b).col(moved.direction).head<6>();
  return F;
}

} // namespace

MatrixXd fields_of_moved_caps(const BuiltCase& built, const std::vector<MovedCap>& moved) {
  const System system = assemble(built.model);
  const std::vector<int> held = node_dofs(system.map, built.held_nodes);
  const std::vector<int> free = complement(system.map.size(), held);
  const SparseMatrix K = restrict_to(system.K, free);
  SparseFactor factor(K);
  if (!factor.factorise(K).ok)
    throw ModelError("motion of chosen ends: nothing holds the part when they are held");
  MatrixXd fields(dof_count(built.model), Index(moved.size()));
  for (Index k = 0; k < fields.cols(); ++k) {
    const MovedCap& own = moved[std::size_t(k)];
    const int node = built.cap_nodes.at(own.cap);
    VectorXd all = VectorXd::Zero(system.map.size());
    if (std::find(built.held_nodes.begin(), built.held_nodes.end(), node) !=
        built.held_nodes.end()) {
      VectorXd at_held = VectorXd::Zero(Index(held.size()));
      const int dof = system.map.independent[6 * node + own.direction];
      at_held[std::lower_bound(held.begin(), held.end(), dof) - held.begin()] = 1;
      all = follow_boundary(system.K, held, factor, at_held);
    } else {
      all(free) = factor.solve(MatrixXd(gather(system.map, spring_forces(built, own))(free)));
    }
    fields.col(k) = expand(system.map, all);
  }
  return fields;
}

} // namespace plica
