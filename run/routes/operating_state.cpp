#include "run/routes/operating_state.hpp"

#include "reduction/cyclic_state.hpp"
#include "run/routes/route.hpp"
#include "run/routes/state_bolts.hpp"
#include "run/routes/state_buckling.hpp"
#include "run/routes/state_joints.hpp"
#include "run/routes/state_loads.hpp"
#include "run/stages.hpp"
#include "solve/equilibrium_path.hpp"
#include "solve/state_elements.hpp"
#include "solve/state_shape.hpp"
#include "solve/stopwatch.hpp"
#include "words/input_error.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

void add_reactions(const Case& data, const BuiltCase& built, const VectorXd& lacking,
                   StateResult& result) {
  const DofMap map = eliminate(built.model);
  const VectorXd held = gather(map, lacking);
  for (const Mount& mount : data.mount) {
    const int node = built.cap_nodes.at(mount.cap);
    Eigen::Matrix<double, 6, 1> f = Eigen::Matrix<double, 6, 1>::Zero();
    if (mount.kind == MountKind::free) continue;
    if (mount.kind == MountKind::rigid)
      for (int d = 0; d < 6; ++d) {
        const int number = map.independent[std::size_t(6 * node + d)];
        if (number >= 0) f[d] = -held[number];
      }
    for (const BushingElement& b : built.model.bushings)
      if (mount.kind == MountKind::springs && b.node2 < 0 && b.node1 == node)
        f += VectorXd(state_tangent(built.model, b).force);
    EndReaction reaction{.cap = mount.cap, .force = {}, .moment = {}};
    Vector3d::Map(reaction.force.data()) = f.head<3>();
    Vector3d::Map(reaction.moment.data()) = f.tail<3>();
    result.reactions.push_back(reaction);
  }
}

void add_iteration(const StateIteration& i, StateResult& result) {
  result.iterations.push_back({i.share, i.residual, i.step});
}

BaseState equilibrium(const OperatingState& asked, const Model& at_rest, const StateLoads& loads,
                      const StateSolver& solver, const StageListener& stage, StateResult& result) {
  const std::string at = asked.name.empty() ? "state" : "states." + asked.name;
  const auto heard = [&](double share) {
    stage({stages::state, fmt::format(", {:.3g} % of the loads", 100 * share), share});
  };
  try {
    if (!asked.follow)
      return find_state(at_rest, loads, solver, [&](const StateIteration& i) {
        add_iteration(i, result);
        heard(i.share);
      });
    PathResult path =
        follow_state(at_rest, loads, [&](const PathPoint& point) { heard(point.share); });
    result.turned_at = path.turned_at;
    for (const StateIteration& i : path.state.iterations) add_iteration(i, result);
    return std::move(path.state);
  } catch (const StateError& error) {
    throw StateError(std::string(error.what()) + "; less of what acts, or " +
                     (asked.follow ? "another way to it: " : at + ".follow: true beyond a snap, ") +
                     at + ".buckling for the loads at which it buckles");
  }
}

} // namespace

void require_rest(const Case& data, const std::string& what) {
  if (data.state)
    input_error("state", "is not possible here: " + what + " knows the part at rest alone",
                "the case without its state");
}

StateResult move_into_state(const Case& data, BuiltCase& built, const StageListener& stage,
                            std::map<std::string, double>& timing) {
  stage(stages::state);
  Stopwatch watch;
  StateResult result;
  result.name = data.state->name;
  load_joints(built);
  const StateLoads loads = state_loads(data, built, result);
  tighten_bolts(data.state->bolt, built);
  add_squirm(data, result);
  const Model at_rest = built.model;
  const bool symmetric = !data.state->follow && data.analyses.symmetry != Symmetry::off &&
                         is_axisymmetric(at_rest, loads);
  result.route = symmetric ? "rotational symmetry" : "full mesh";
  const StateSolver solver = symmetric ? cyclic_state_solver(at_rest, built.held_nodes)
                                       : full_state_solver(built.held_nodes);
  if (data.state->buckling > 0) {
    stage(stages::buckling);
    add_buckling(data, at_rest, loads, solver, result);
    watch.lap(timing, stages::buckling);
    stage(stages::state);
  }
  BaseState state = equilibrium(*data.state, at_rest, loads, solver, stage, result);
  for (MatrixElement& m : coupling_stiffness(state.model, at_rest, state.lacking, symmetric))
    state.model.matrices.push_back(std::move(m));
  built.model = std::move(state.model);
  result.load_steps = state.load_steps;
  result.largest_displacement = state.largest_displacement;
  result.linear_error = state.linear_error;
  result.displacement.resize(Eigen::Index(at_rest.mesh.nodes.size()), 3);
  for (std::size_t n = 0; n < at_rest.mesh.nodes.size(); ++n)
    result.displacement.row(Eigen::Index(n)) =
        (built.model.mesh.nodes[n] - at_rest.mesh.nodes[n]).transpose();
  add_reactions(data, built, state.lacking, result);
  settle_joints(built, result);
  settle_bolts(data.state->bolt, built, result);
  watch.lap(timing, "state");
  return result;
}

} // namespace plica
