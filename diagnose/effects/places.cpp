#include "diagnose/effects/places.hpp"

#include "diagnose/effects/on_table.hpp"
#include "diagnose/effects/plate_spots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plica {
namespace {

using Eigen::Vector3d;

double mean_y(const Mesh& mesh, const std::vector<int>& nodes) {
  double sum = 0;
  for (int node : nodes) sum += mesh.nodes[node].y();
  return sum / double(nodes.size());
}

// y of the root circles of a bellows, from left to right.
std::vector<double> roots(const Mesh& mesh, const std::string& part) {
  std::vector<double> y;
  for (int k = 1; mesh.sets.contains(part + ".root[" + std::to_string(k) + "]"); ++k)
    y.push_back(mean_y(mesh, mesh.sets.at(part + ".root[" + std::to_string(k) + "]")));
  return y;
}

// The widest ring between two places along the axis; none = null.
const Ring* crown(const Mesh& mesh, double from, double to) {
  const Ring* widest = nullptr;
  for (const Ring& ring : mesh.rings)
    if (ring.y > from && ring.y < to && (!widest || ring.radius > widest->radius)) widest = &ring;
  return widest;
}

// Its uppermost node: what touches from above touches there.
int top_of(const Mesh& mesh, const std::vector<int>& nodes) {
  return *std::max_element(nodes.begin(), nodes.end(),
                           [&](int a, int b) { return mesh.nodes[a].z() < mesh.nodes[b].z(); });
}

void add_convolutions(std::vector<Spot>& found, const Structure& s, const std::string& part,
                      int most) {
  const Mesh& mesh = s.built.model.mesh;
  const std::vector<double> y = roots(mesh, part);
  for (int k : stations_of(int(y.size()) - 1, most))
    if (const Ring* ring = crown(mesh, y[std::size_t(k) - 1], y[std::size_t(k)]))
      found.push_back({part + ".convolution[" + std::to_string(k) + "]", ring->nodes,
                       top_of(mesh, ring->nodes)});
}

void add_points(std::vector<Spot>& found, const Structure& s, const std::string& part) {
  const auto& sets = s.built.model.mesh.sets;
  int points = 0;
  while (sets.contains(part + ".point[" + std::to_string(points + 1) + "]")) ++points;
  for (int k : stations_of(points)) {
    const std::string place = part + ".point[" + std::to_string(k) + "]";
    found.push_back({place, sets.at(place), sets.at(place).front(), true});
  }
}

void add_along(std::vector<Spot>& found, const Structure& s, const std::string& part) {
  const std::vector<int>& nodes = s.built.model.mesh.sets.at(part + ".all");
  if (nodes.size() < 3) return;
  for (int k : stations_of(int(nodes.size()) - 2))
    found.push_back({part + ".node[" + std::to_string(k) + "]",
                     {nodes[std::size_t(k)]},
                     nodes[std::size_t(k)],
                     true});
}

bool is_held(const Structure& s, int node) {
  return std::find(s.built.held_nodes.begin(), s.built.held_nodes.end(), node) !=
         s.built.held_nodes.end();
}

// Of the law of a spring: the pipe lies along y.
std::vector<int> rows_of(JointDirection motion) {
  static const std::array<std::vector<int>, 5> rows{{{0, 1, 2, 3, 4, 5}, {1}, {0, 2}, {3, 5}, {4}}};
  return rows[static_cast<std::size_t>(motion)];
}

// Stiffnesses of a beam that bear a motion; what it has across follows from bending.
std::vector<double*> numbers_of(BeamProperties& section, JointDirection motion) {
  switch (motion) {
  case JointDirection::all:
    return {&section.EA, &section.EI_y, &section.EI_z, &section.GJ};
  case JointDirection::axial:
    return {&section.EA};
  case JointDirection::lateral:
    return {};
  case JointDirection::bending:
    return {&section.EI_y, &section.EI_z};
  case JointDirection::torsion:
    return {&section.GJ};
  }
  return {};
}

double largest_translation(const BushingElement& b) {
  return b.bushing.law.diagonal().head<3>().maxCoeff();
}

} // namespace

std::vector<int> stations_of(int count, int most) {
  std::vector<int> chosen;
  const int even = std::min(count, 8);
  for (int i = 0; i < even; ++i)
    chosen.push_back(even == count ? i + 1 : 1 + ((2 * i + 1) * count) / (2 * even));
  const auto away = [&](int k) {
    int nearest = count;
    for (int other : chosen) nearest = std::min(nearest, std::abs(other - k));
    return nearest;
  };
  while (int(chosen.size()) < std::min(count, most)) {
    int farthest = 1;
    for (int k = 2; k <= count; ++k)
      if (away(k) > away(farthest)) farthest = k;
    chosen.insert(std::upper_bound(chosen.begin(), chosen.end(), farthest), farthest);
  }
  return chosen;
}

namespace {

std::vector<Spot> spots_of(const Structure& s, int crowns, bool on_plates) {
  std::vector<Spot> found;
  for (const BuiltSensor& sensor : s.built.sensors)
    found.push_back({"sensor." + sensor.name, {sensor.node}, sensor.node});
  for (const Part& part : s.data.parts) {
    if (std::holds_alternative<Bellows>(part.body)) add_convolutions(found, s, part.name, crowns);
    if (std::holds_alternative<BeamPart>(part.body)) add_points(found, s, part.name);
    if (std::holds_alternative<EquivalentPipe>(part.body) ||
        std::holds_alternative<ConnectorChain>(part.body))
      add_along(found, s, part.name);
    if (const auto* plate = std::get_if<Plate>(&part.body); plate && on_plates)
      for (Spot& spot : plate_spots(s.built, part.name, *plate)) found.push_back(std::move(spot));
  }
  std::erase_if(found, [&](const Spot& spot) { return is_held(s, spot.touched); });
  return found;
}

} // namespace

std::vector<Spot> spots(const Structure& s) {
  return spots_of(s, 8, false);
}

std::vector<Spot> contact_spots(const Structure& s) {
  return spots_of(s, 16, true);
}

std::vector<JointGroup> joint_groups(const Structure& s) {
  const Model& model = s.built.model;
  std::vector<JointGroup> groups;
  const auto group_of = [&](int component) -> JointGroup& {
    const std::string& name = model.components[std::size_t(component)];
    for (JointGroup& g : groups)
      if (g.place == name) return g;
    groups.push_back({.place = name, .bushings = {}, .beams = {}});
    return groups.back();
  };
  for (std::size_t i = 0; i < model.bushings.size(); ++i) {
    JointGroup& group = group_of(model.bushings[i].component);
    group.bushings.push_back(int(i));
    group.stiffness = std::max(group.stiffness, largest_translation(model.bushings[i]));
  }
  for (JointGroup& g : groups) {
    g.mount = std::any_of(s.data.mount.begin(), s.data.mount.end(),
                          [&](const Mount& m) { return g.place == "mount." + m.cap; });
    if (!g.mount) g.stiffness /= double(g.bushings.size()); // in series
    g.rigid = std::any_of(s.rigid_clamps.begin(), s.rigid_clamps.end(),
                          [&](const std::string& cap) { return g.place == "caps." + cap; });
  }
  for (const Part& part : s.data.parts) {
    const auto* liner = std::get_if<Interlock>(&part.body);
    if (!liner) continue;
    const auto own = std::find(model.components.begin(), model.components.end(), part.name);
    if (own == model.components.end()) continue;
    JointGroup group{.place = part.name, .bushings = {}, .beams = {}};
    for (std::size_t i = 0; i < model.beams.size(); ++i)
      if (model.beams[i].component == own - model.components.begin()) group.beams.push_back(int(i));
    group.present = liner->EA > 0;
    group.nodes = model.mesh.sets.at(part.name + ".all");
    group.radius = liner->radius;
    const double length =
        (model.mesh.nodes[group.nodes.back()] - model.mesh.nodes[group.nodes.front()]).norm();
    if (length > 0) group.stiffness = group.present ? liner->EA / length : s.stiffness;
    if (group.stiffness > 0) groups.push_back(group);
  }
  std::erase_if(groups, [](const JointGroup& g) { return !(g.stiffness > 0); });
  return groups;
}

BeamProperties tube_of(const Model& model, const JointGroup& group) {
  const auto& x = model.mesh.nodes;
  const double length = (x[group.nodes.back()] - x[group.nodes.front()]).norm();
  const double EA = group.stiffness * length, r2 = group.radius * group.radius;
  BeamProperties tube;
  tube.EA = EA;
  tube.EI_y = tube.EI_z = EA * r2 / 2;
  tube.GJ = EA * r2 / 2.6;
  return tube;
}

const char* way_of(JointDirection motion) {
  constexpr std::array names{"", "axial", "lateral", "bending", "torsion"};
  return names[static_cast<std::size_t>(motion)];
}

bool turns(JointDirection motion) {
  return motion == JointDirection::bending || motion == JointDirection::torsion;
}

double stiffness_in(const Model& model, const JointGroup& group, JointDirection motion) {
  double compliance = 0;
  for (int i : group.bushings) {
    const Matrix6& law = model.bushings[std::size_t(i)].bushing.law;
    double k = 0;
    for (int row : rows_of(motion)) k = std::max(k, law(row, row));
    if (!law.isDiagonal() || !(k > 0)) return 0;
    compliance += 1 / k;
  }
  for (std::size_t n = 1; n < group.nodes.size() && motion != JointDirection::lateral; ++n) {
    const BeamProperties section = group.present && n <= group.beams.size()
                                       ? model.beams[std::size_t(group.beams[n - 1])].section
                                       : tube_of(model, group);
    const double length =
        (model.mesh.nodes[group.nodes[n]] - model.mesh.nodes[group.nodes[n - 1]]).norm();
    const double k = motion == JointDirection::bending   ? section.EI_y
                     : motion == JointDirection::torsion ? section.GJ
                                                         : section.EA;
    if (!(k > 0)) return 0;
    compliance += length / k;
  }
  return compliance > 0 ? 1 / compliance : 0;
}

std::vector<std::pair<JointDirection, double>> motions_of(const Model& model,
                                                          const JointGroup& group) {
  std::vector<std::pair<JointDirection, double>> found;
  for (JointDirection motion : {JointDirection::axial, JointDirection::lateral,
                                JointDirection::bending, JointDirection::torsion})
    if (const double k = stiffness_in(model, group, motion); k > 0) found.emplace_back(motion, k);
  if (found.size() < 2) found.clear();
  return found;
}

double lever_of(const Structure& s) {
  return s.length / 4;
}

Prior ratio_prior(const Structure& s, double stiffness, JointDirection motion) {
  const double beside = s.stiffness * (turns(motion) ? lever_of(s) * lever_of(s) : 1);
  constexpr double share = 0.1; // of the structure's compliance
  const double centre = 1 / (1 + share * stiffness / beside);
  return {PriorKind::log_normal, centre, centre > 0.5 ? 1 : 1.5};
}

void scale_group(Model& model, const JointGroup& group, double factor, JointDirection motion) {
  for (int i : group.bushings) {
    Matrix6& law = model.bushings[std::size_t(i)].bushing.law;
    if (motion == JointDirection::all)
      law *= factor;
    else
      for (int row : rows_of(motion)) law(row, row) *= factor;
  }
  if (group.present) {
    for (int i : group.beams)
      for (double* number : numbers_of(model.beams[std::size_t(i)].section, motion))
        *number *= factor;
    return;
  }
  const BeamProperties tube = tube_of(model, group);
  BeamProperties own = tube;
  for (double* number : numbers_of(own, JointDirection::all)) *number = 0;
  BeamProperties given = tube;
  const std::vector<double*> from = numbers_of(given, motion), to = numbers_of(own, motion);
  for (std::size_t n = 0; n < to.size(); ++n) *to[n] = factor * *from[n];
  for (std::size_t i = 1; i < group.nodes.size(); ++i)
    model.beams.push_back({.node1 = group.nodes[i - 1], .node2 = group.nodes[i], .section = own});
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
                      .root_radius = bellows->root_radius,
                      .plies = bellows->wall.plies,
                      .bond = bellows->wall.bond};
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
    found.push_back(std::move(wall));
  }
  return found;
}

int cap_node(const Structure& s, const std::string& cap) {
  const auto found = s.built.cap_nodes.find(cap);
  return found == s.built.cap_nodes.end() ? -1 : found->second;
}

std::vector<HeldEnds> held_ends(const Structure& s, bool rigid) {
  std::vector<HeldEnds> found;
  HeldEnds all{.place = "mount", .nodes = {}};
  for (const Mount& m : s.data.mount) {
    if (m.kind == MountKind::free || (rigid && m.kind != MountKind::rigid)) continue;
    const int node = node_on_table(s.built, m);
    found.push_back({place_of(m), {node}});
    all.nodes.push_back(node);
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

ModelChange added_group(const JointGroup& group, JointDirection motion, double share) {
  if (!group.rigid)
    return {
        [group, motion](Model& model) { scale_group(model, group, group.present ? 2 : 1, motion); },
        Follow::series};
  return {[group, motion, share](Model& model) {
            for (int i : group.bushings) {
              BushingElement beside = model.bushings[std::size_t(i)];
              const Matrix6 whole = std::exchange(beside.bushing.law, Matrix6::Zero());
              for (int row : rows_of(motion))
                beside.bushing.law(row, row) = share * whole(row, row);
              model.bushings.push_back(beside);
            }
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
