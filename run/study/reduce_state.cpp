#include "run/study/reduce_state.hpp"

#include "model/description/place_keys.hpp"
#include "run/routes/operating_state.hpp"
#include "words/input_error.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

std::string path_of(const OperatingState& state) {
  return state.name.empty() ? "state" : "states." + state.name;
}

// What acts on a cap from outside, in the state.
void add_end_force(const Case& data, const StateResult& state, const std::string& cap,
                   Vector3d& force, Vector3d& moment) {
  for (const EndReaction& r : state.reactions)
    if (r.cap == cap) {
      force -= Vector3d::Map(r.force.data());
      moment -= Vector3d::Map(r.moment.data());
    }
  for (const EndLoad& load : data.state->force)
    if (load.cap == cap) {
      force += Vector3d::Map(load.force.data());
      moment += Vector3d::Map(load.moment.data());
    }
}

} // namespace

ReleasedCase released_in_state(const Case& data, const StageListener& stage,
                               std::map<std::string, double>& timing) {
  ReleasedCase released{build(data), {}};
  released.state = move_into_state(data, released.built, stage, timing);
  BuiltCase& built = released.built;
  built.held_nodes.clear();
  const auto is_cap = [&](int node) {
    return std::any_of(built.cap_nodes.begin(), built.cap_nodes.end(),
                       [&](const auto& cap) { return cap.second == node; });
  };
  std::erase_if(built.model.bushings,
                [&](const BushingElement& b) { return b.node2 < 0 && is_cap(b.node1); });
  std::erase_if(built.dampers, [](const BuiltDamper& d) { return d.node1 < 0; });
  built.joints.clear(); // they stick, as springs of the model
  return released;
}

MatrixXd forces_of_rigid_motions(const Case& data, const ReleasedCase& released,
                                 const std::vector<int>& nodes) {
  MatrixXd raised = MatrixXd::Zero(6 * Eigen::Index(nodes.size()), 6);
  for (const auto& [cap, node] : released.built.cap_nodes) {
    const auto at = std::find(nodes.begin(), nodes.end(), node);
    if (at == nodes.end()) continue;
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    add_end_force(data, released.state, cap, force, moment);
    for (int d = 0; d < 3; ++d) {
      const Eigen::Index row = 6 * (at - nodes.begin());
      raised.block<3, 1>(row, 3 + d) = Vector3d::Unit(d).cross(force);
      raised.block<3, 1>(row + 3, 3 + d) = Vector3d::Unit(d).cross(moment) / 2;
    }
  }
  return raised;
}

void check_reducible(const Case& data, const std::vector<std::string>& boundary) {
  const OperatingState& state = *data.state;
  const std::string path = path_of(state);
  if (state.gravity != Triple{})
    input_error(path + ".gravity",
                "and a superelement are not possible together: its stiffness would be that of the "
                "weight too",
                "the state without gravity");
  if (!data.supports.empty() || held_by_deck(data))
    input_error(path,
                "and supports inside the superelement are not possible together: what they "
                "bear would be inside",
                "a case whose caps alone are held");
  const auto inside = [&](const std::string& cap) {
    return std::find(boundary.begin(), boundary.end(), cap) == boundary.end();
  };
  for (const EndLoad& load : state.force)
    if (inside(load.cap))
      input_error(path + ".force." + load.cap, "acts on a cap inside the superelement",
                  "a boundary with that cap");
  for (const Mount& mount : data.mount)
    if (mount.kind != MountKind::free && inside(mount.cap))
      input_error(mount_key(mount.cap), "holds a cap inside the superelement in its state",
                  "a boundary with that cap");
}

} // namespace plica
