#include "diagnose/effects/on_table.hpp"

#include "model/description/place_keys.hpp"
#include "solve/couplings.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <set>

namespace plica {
namespace {

const std::string support_key = "supports[";
constexpr const char* ends[] = {".start", ".end", ".left", ".right"};

bool is_end_of_a_part(const Case& data, const std::string& set) {
  return std::any_of(data.parts.begin(), data.parts.end(), [&](const Part& part) {
    return std::any_of(std::begin(ends), std::end(ends),
                       [&](const char* end) { return set == part.name + end; });
  });
}

int node_of_fixture(BuiltCase& built, const Case& data, const std::string& place) {
  const auto mount = std::find_if(data.mount.begin(), data.mount.end(), [&](const Mount& m) {
    return m.kind != MountKind::free && place_of(m) == place;
  });
  if (mount == data.mount.end())
    input_error("sensors", "the case holds nothing at '" + place + "'", "a mount of the case");
  if (mount->kind == MountKind::springs) return node_on_table(built, *mount);
  const auto known = built.fixture_nodes.find(mount->cap);
  if (known != built.fixture_nodes.end()) return known->second;
  Model& model = built.model;
  const int end = built.cap_nodes.at(mount->cap);
  const Eigen::Vector3d at = model.mesh.nodes[std::size_t(end)];
  BushingElement tie{.node1 = end, .node2 = add_node(model, at), .bushing = {}};
  constexpr double too_soft = 1e-3; // N/m and Nm/rad, to hold anything
  tie.bushing.law.diagonal().setConstant(too_soft);
  model.bushings.push_back(tie);
  built.held_nodes.push_back(tie.node2);
  built.fixture_nodes[mount->cap] = tie.node2;
  return tie.node2;
}

void add_sensor_beside_the_part(BuiltCase& built, const Case& data, const Sensor& sensor) {
  const Eigen::Vector3d at(sensor.at[0], sensor.at[1], sensor.at[2]);
  const std::vector<int> all{0, 1, 2, 3, 4, 5};
  int node = -1;
  if (sensor.on == on_the_table) {
    node = add_node(built.model, at);
    for (int dof : all)
      built.model.constraints.push_back({node, dof, {}, "sensor " + sensor.name + " on the table"});
    built.table_nodes.push_back(node);
  } else {
    const int fixture = node_of_fixture(built, data, sensor.on);
    node = add_node(built.model, at);
    add_kinematic_coupling(built.model, fixture, {node}, all, "arm of sensor " + sensor.name);
  }
  built.sensors.push_back({sensor.name, node, 0, {sensor.axes[0], sensor.axes[1], sensor.axes[2]}});
}

} // namespace

Case clamped_by_mounts(Case data) {
  std::vector<Support> others;
  for (std::size_t i = 0; i < data.supports.size(); ++i) {
    const Support& support = data.supports[i];
    const bool all = std::set<int>(support.dofs.begin(), support.dofs.end()).size() == 6;
    const bool capped = std::any_of(data.caps.begin(), data.caps.end(), [&](const Cap& cap) {
      return std::find(cap.of.begin(), cap.of.end(), support.set) != cap.of.end();
    });
    if (!all || capped || !is_end_of_a_part(data, support.set)) {
      others.push_back(support);
      continue;
    }
    const std::string name = support_key + std::to_string(i) + "]";
    data.caps.push_back({.name = name, .of = {support.set}});
    data.mount.push_back({.cap = name});
  }
  data.supports = std::move(others);
  return data;
}

std::string place_of(const Mount& mount) {
  return mount.cap.starts_with(support_key) ? mount.cap : mount_key(mount.cap);
}

std::vector<int> springs_of(const Model& model, const Mount& mount) {
  std::vector<int> found;
  if (mount.kind != MountKind::springs) return found;
  for (std::size_t i = 0; i < model.bushings.size(); ++i)
    if (model.components[std::size_t(model.bushings[i].component)] == mount_key(mount.cap))
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
  for (const Sensor& sensor : data.sensors)
    if (!sensor.on.empty()) add_sensor_beside_the_part(built, data, sensor);
  return built;
}

int node_on_table(const BuiltCase& built, const Mount& mount) {
  const std::vector<int> springs = springs_of(built.model, mount);
  return springs.empty() ? built.cap_nodes.at(mount.cap)
                         : built.model.bushings[std::size_t(springs.front())].node2;
}

} // namespace plica
