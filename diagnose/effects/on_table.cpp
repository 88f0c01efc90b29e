#include "diagnose/effects/on_table.hpp"

namespace plica {

std::vector<int> springs_of(const Model& model, const Mount& mount) {
  std::vector<int> found;
  if (mount.kind != MountKind::springs) return found;
  for (std::size_t i = 0; i < model.bushings.size(); ++i)
    if (model.components[std::size_t(model.bushings[i].component)] == "mount." + mount.cap)
      found.push_back(int(i));
  return found;
}

BuiltCase build_on_table(const Case& data) {
  BuiltCase built = build(data);
  Model& model = built.model;
  for (const Mount& mount : data.mount) {
    const std::vector<int> springs = springs_of(model, mount);
    if (springs.empty()) continue;
    const Eigen::Vector3d place = model.mesh.nodes[built.cap_nodes.at(mount.cap)];
    const int foot = add_node(model, place);
    for (int i : springs) model.bushings[std::size_t(i)].node2 = foot;
    built.held_nodes.push_back(foot);
  }
  return built;
}

int node_on_table(const BuiltCase& built, const Mount& mount) {
  const std::vector<int> springs = springs_of(built.model, mount);
  return springs.empty() ? built.cap_nodes.at(mount.cap)
                         : built.model.bushings[std::size_t(springs.front())].node2;
}

} // namespace plica
