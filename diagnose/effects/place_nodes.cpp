#include "diagnose/effects/place_nodes.hpp"

#include "diagnose/effects/beam_path.hpp"
#include "diagnose/effects/joint_groups.hpp"
#include "diagnose/effects/places.hpp"
#include "diagnose/effects/plate_places.hpp"
#include "diagnose/effects/spots.hpp"
#include "diagnose/effects/wall_spots.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>
#include <set>

namespace plica {
namespace {

void add_component(std::set<int>& nodes, const Model& model, const std::string& name) {
  const auto own = [&](int component) {
    return component >= 0 && model.components[std::size_t(component)] == name;
  };
  for (const ShellQuad& quad : model.mesh.quads)
    if (own(model.shells[std::size_t(quad.section)].component))
      nodes.insert(quad.nodes.begin(), quad.nodes.end());
  for (const BeamElement& b : model.beams)
    if (own(b.component)) nodes.insert({b.node1, b.node2});
  for (const BushingElement& b : model.bushings)
    if (own(b.component))
      for (int node : {b.node1, b.node2})
        if (node >= 0) nodes.insert(node);
}

// "bellows.convolution[4]", "beam.stretch[4]": between the fourth and the fifth root or point.
std::vector<std::string> ends_of(const std::string& name) {
  for (const auto& [between, at] :
       {std::pair<std::string, std::string>{".convolution[", ".root["}, {".stretch[", ".point["}}) {
    const std::size_t found = name.find(between);
    if (found == std::string::npos) continue;
    const int number = std::stoi(name.substr(found + between.size()));
    const std::string head = name.substr(0, found) + at;
    return {head + std::to_string(number) + "]", head + std::to_string(number + 1) + "]"};
  }
  return {};
}

// What one name says.
std::set<int> nodes_named(const Structure& s, const std::string& name) {
  const Model& model = s.built.model;
  std::set<int> nodes;
  for (const BuiltSensor& sensor : s.built.sensors)
    if (name == sensor_place(sensor.name)) nodes.insert(sensor.node);
  for (const auto& [cap, node] : s.built.cap_nodes)
    if (name == cap_key(cap) || name == mount_key(cap) ||
        (name == cap && cap.starts_with("supports[")))
      nodes.insert(node);
  for (const Cap& cap : s.data.caps)
    for (const std::string& end : cap.of)
      if (name == sprung_end_key(cap.name, end)) nodes.insert(s.built.end_nodes.at(end));
  for (const Mount& m : s.data.mount)
    if (name == all_mounts && m.kind != MountKind::free) nodes.insert(cap_node(s, m.cap));
  for (const auto& [all, rigid] : {std::pair{"joints", false}, {"clamps", true}})
    if (name == all)
      for (const JointGroup& group : joint_groups(s))
        if (!group.mount && group.rigid == rigid) add_component(nodes, model, group.place);
  for (const Spot& spot : contact_spots(s, part_of_set(name)))
    if (spot.place == name) nodes.insert(spot.nodes.begin(), spot.nodes.end());
  if (name.find(".spot[") != std::string::npos && nodes.empty())
    for (const Spot& spot : damage_spots(s.built, part_of_set(name)))
      if (spot.place == name) nodes.insert(spot.touched);
  for (const Part& part : s.data.parts)
    if (const auto* body = std::get_if<PointMass>(&part.body); body && part.name == name) {
      const std::vector<int>& on = model.mesh.sets.at(body->at);
      nodes.insert(on.begin(), on.end());
    }
  std::vector<std::string> sets{name, name + ".all"};
  if (nodes.empty())
    for (std::string& end : ends_of(name)) sets.push_back(std::move(end));
  for (const std::string& of : sets)
    if (const auto set = model.mesh.sets.find(of); set != model.mesh.sets.end())
      nodes.insert(set->second.begin(), set->second.end());
  if (nodes.empty()) add_component(nodes, model, name);
  return nodes;
}

} // namespace

std::vector<int> nodes_at(const Structure& s, const std::string& place,
                          const std::vector<double>& along) {
  if (along.size() == 1)
    for (const BeamPath& path : line_paths(s))
      if (path.part == place) return {path.nodes[nearest_of(path.at, along[0])]};
  if (along.size() == 2)
    for (const PlateGrid& grid : plate_grids(s))
      if (grid.part == place) return {grid.nearest(along[0], along[1])};
  std::set<int> nodes;
  const std::string between = " and ";
  for (std::size_t from = 0; from <= place.size();) {
    const std::size_t to = std::min(place.find(between, from), place.size());
    nodes.merge(nodes_named(s, place.substr(from, to - from)));
    from = to + between.size();
  }
  std::erase_if(nodes, [](int node) { return node < 0; });
  return {nodes.begin(), nodes.end()};
}

} // namespace plica
