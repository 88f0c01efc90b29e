#include "diagnose/effects/places.hpp"

#include "diagnose/effects/on_table.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plica {
namespace {

using Eigen::Vector3d;

double mean_y(const Mesh& mesh, const std::vector<int>& nodes) {
  double sum = 0;
  for (int node : nodes) sum += mesh.nodes[node].y();
  return sum / double(nodes.size());
}

void set_places_along(WallElements& wall, const Model& model) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int q : wall.quads)
    for (int node : model.mesh.quads[std::size_t(q)].nodes) {
      low = std::min(low, model.mesh.nodes[std::size_t(node)].y());
      high = std::max(high, model.mesh.nodes[std::size_t(node)].y());
    }
  for (int q : wall.quads) wall.along.push_back((quad_centre(model, q).y() - low) / (high - low));
}

} // namespace

std::vector<double> roots(const Mesh& mesh, const std::string& part) {
  std::vector<double> y;
  for (int k = 1; mesh.sets.contains(part + ".root[" + std::to_string(k) + "]"); ++k)
    y.push_back(mean_y(mesh, mesh.sets.at(part + ".root[" + std::to_string(k) + "]")));
  return y;
}

bool PartGroup::holds(const Model& model, int component) const {
  return std::find(parts.begin(), parts.end(), model.components[std::size_t(component)]) !=
         parts.end();
}

std::vector<PartGroup> part_groups(const Structure& s) {
  std::vector<PartGroup> found, alike;
  std::vector<const Bellows*> drawn; // of the groups alike
  for (const Part& part : s.data.parts) {
    const auto* bellows = std::get_if<Bellows>(&part.body);
    if (!bellows && !std::holds_alternative<Plate>(part.body) &&
        !std::holds_alternative<BeamPart>(part.body))
      continue;
    found.push_back({part.name, {part.name}});
    if (!bellows) continue;
    const auto same = std::find_if(drawn.begin(), drawn.end(), [&](const Bellows* other) {
      return other->material == bellows->material && other->profile == bellows->profile &&
             other->root_radius == bellows->root_radius && other->wall == bellows->wall;
    });
    if (same == drawn.end()) {
      drawn.push_back(bellows);
      alike.push_back({part.name, {part.name}});
      continue;
    }
    PartGroup& group = alike[std::size_t(same - drawn.begin())];
    group.place += " and " + part.name;
    group.parts.push_back(part.name);
  }
  for (PartGroup& group : alike)
    if (group.parts.size() > 1) found.push_back(std::move(group));
  return found;
}

std::vector<WallElements> walls(const Structure& s) {
  const Model& model = s.built.model;
  std::vector<WallElements> found;
  for (const Part& part : s.data.parts) {
    const auto* bellows = std::get_if<Bellows>(&part.body);
    if (!bellows) continue;
    WallElements wall{.part = part.name,
                      .quads = {},
                      .convolution = {},
                      .along = {},
                      .root_radius = bellows->root_radius,
                      .plies = bellows->wall.plies,
                      .bond = bellows->wall.bond,
                      .thickness_field = bellows->wall.thickness_field};
    const std::vector<double> y = roots(model.mesh, part.name);
    wall.convolutions = std::max(0, int(y.size()) - 1);
    for (std::size_t q = 0; q < model.mesh.quads.size(); ++q) {
      const ShellProperties& section = model.shells[model.mesh.quads[q].section];
      if (model.components[std::size_t(section.component)] != part.name) continue;
      const auto above =
          std::upper_bound(y.begin(), y.end(), quad_centre(model, int(q)).y()) - y.begin();
      wall.quads.push_back(int(q));
      wall.convolution.push_back(above == std::ptrdiff_t(y.size()) ? 0 : int(above));
    }
    set_places_along(wall, model);
    found.push_back(std::move(wall));
  }
  return found;
}

int cap_node(const Structure& s, const std::string& cap) {
  const auto found = s.built.cap_nodes.find(cap);
  return found == s.built.cap_nodes.end() ? -1 : found->second;
}

std::vector<std::string> sensor_names(const Structure& s) {
  std::vector<std::string> names;
  for (const BuiltSensor& sensor : s.built.sensors) names.push_back(sensor.name);
  for (const MeasuredSensor& sensor : s.measured.sensors)
    if (!sensor.on.empty()) names.push_back(sensor.name);
  return names;
}

std::vector<HeldEnds> held_ends(const Structure& s, bool rigid) {
  std::vector<HeldEnds> found;
  HeldEnds all{.place = all_mounts, .nodes = {}};
  for (const Mount& m : s.data.mount) {
    if (m.kind == MountKind::free || (rigid && m.kind != MountKind::rigid)) continue;
    const int node = node_on_table(s.built, m);
    HeldEnds own{.place = place_of(m), .nodes = {node}};
    if (const auto fixture = s.built.fixture_nodes.find(m.cap);
        fixture != s.built.fixture_nodes.end())
      own.fixtures.push_back(fixture->second);
    all.nodes.push_back(node);
    all.fixtures.insert(all.fixtures.end(), own.fixtures.begin(), own.fixtures.end());
    found.push_back(std::move(own));
  }
  if (all.nodes.size() > 1) found.push_back(std::move(all));
  return found;
}

ModelChange ground_springs(const std::vector<int>& nodes, double translation, double rotation) {
  return {[nodes, translation, rotation](Model& model) {
            for (int node : nodes)
              add_ground_spring(
                  model, node,
                  {translation, translation, translation, rotation, rotation, rotation});
          },
          Follow::series};
}

Vector3d quad_centre(const Model& model, int quad) {
  Vector3d centre = Vector3d::Zero();
  for (int node : model.mesh.quads[std::size_t(quad)].nodes) centre += model.mesh.nodes[node] / 4;
  return centre;
}

void add_point_mass(Model& model, int node, double mass) {
  MassElement point{.node = node, .body = {}};
  point.body.mass = mass;
  model.masses.push_back(point);
}

void add_ground_spring(Model& model, int node, const std::array<double, 6>& stiffness) {
  BushingElement spring{.node1 = node, .node2 = -1, .bushing = {}};
  for (int i = 0; i < 6; ++i) spring.bushing.law(i, i) = stiffness[std::size_t(i)];
  model.bushings.push_back(spring);
}

} // namespace plica
