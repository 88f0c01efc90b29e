#include "model/shape/building.hpp"
#include "model/shape/constraint_clash.hpp"
#include "model/shape/renewed_ends.hpp"
#include "model/shape/wall_places.hpp"

#include "model/description/place_keys.hpp"
#include "solve/couplings.hpp"
#include "words/input_error.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <fmt/core.h>
#include <limits>

namespace plica {
namespace {

using Eigen::Vector3d;

std::string in_millimetres(double length) {
  return fmt::format("{:.2f} mm", 1e3 * length);
}

bool has_mass(double mass, const Sextuple& J) {
  return mass > 0 || std::any_of(J.begin(), J.end(), [](double v) { return v != 0; });
}

void tie_spider(Building& b, const std::string& cap, int leader, const std::vector<int>& nodes) {
  const std::size_t first = b.built.model.constraints.size();
  add_kinematic_coupling(b.built.model, leader, nodes, all_dofs, "spider of cap " + cap);
  asked_at(b.built.model, first, cap_key(cap) + ".of");
}

// The one node of the circles that follows others, or may have to as places on shells do: it cannot
// follow a cap too.
std::optional<int> leader_among(const Building& b, const std::vector<int>& circles) {
  const std::set<int> followers = b.followers_among(circles);
  const auto leads = [&](int node) { return followers.contains(node) || b.is_on_wall(node); };
  const auto leader = std::find_if(circles.begin(), circles.end(), leads);
  if (leader == circles.end() || std::any_of(leader + 1, circles.end(), leads)) return std::nullopt;
  return *leader;
}

// Reference node in the middle of the circles, tied rigidly to them, or the node that leads them.
int add_spider(Building& b, const std::string& cap, const std::vector<int>& circles) {
  if (const auto leader = leader_among(b, circles)) {
    std::vector<int> others = circles;
    std::erase(others, *leader);
    if (!others.empty()) tie_spider(b, cap, *leader, others);
    return *leader;
  }
  const int node = add_node(b.built.model, centroid(b.built.model.mesh, circles));
  tie_spider(b, cap, node, circles);
  return node;
}

// As stated at the springs, with the loss factor that the damping of the case couples.
void add_dampers(Building& b, const std::string& place, int node1, int node2,
                 const Sextuple& stiffness, const std::optional<SpringDamping>& own) {
  SpringDamping law = own.value_or(SpringDamping{});
  if (b.data.analyses.damping.coupled)
    for (const LossFactor& loss : b.data.analyses.damping.loss_factors)
      if (loss.of == place) law.loss_factor += loss.value;
  for (int dof = 0; dof < 6; ++dof)
    if (added_stiffness(law, dof, stiffness[dof], {0, 1}) != 0. ||
        added_stiffness(law, dof, stiffness[dof], {0, 1e3}) != 0.)
      b.built.dampers.push_back({place, node1, node2, dof, stiffness[dof], law});
}

// `springs`: of a cap or of an end of it, with what slips and damps beside them.
template <class Springs>
void add_joint(Building& b, const std::string& place, int node1, int node2,
               const Sextuple& stiffness, const Springs& springs) {
  BushingElement joint{.node1 = node1, .node2 = node2, .bushing = {}};
  joint.component = b.component(place);
  for (int i = 0; i < 6; ++i) joint.bushing.law(i, i) = stiffness[i];
  b.built.model.bushings.push_back(joint);
  add_dampers(b, place, node1, node2, stiffness, springs.damping);
  if (springs.friction)
    add_joints(b.built.joints, {place, 0, node1, node2, joint.component},
               directional_laws(*springs.friction));
}

// The cap as a rigid body, where the end hangs on it: its node, or one that follows it there.
int arm_to(Building& b, const std::string& cap, int node, int end) {
  const Vector3d from = b.built.model.mesh.nodes[std::size_t(node)],
                 to = b.built.model.mesh.nodes[std::size_t(end)];
  constexpr double same_place = 1e-9; // m
  if ((to - from).norm() < same_place) return node;
  const int arm = add_node(b.built.model, to);
  tie_spider(b, cap, node, {arm});
  return arm;
}

// The node of a cap that the rigid ones of its ends follow: where it would lie if all did, unless
// one of these follows others and has to lead.
int add_body(Building& b, const std::string& cap, const std::vector<int>& all,
             const std::vector<int>& rigid) {
  const auto leader = leader_among(b, all);
  if ((leader && std::find(rigid.begin(), rigid.end(), *leader) != rigid.end()) ||
      !b.followers_among(rigid).empty())
    return add_spider(b, cap, rigid);
  const auto& mesh = b.built.model.mesh;
  const int node =
      add_node(b.built.model, leader ? mesh.nodes[std::size_t(*leader)] : centroid(mesh, all));
  if (!rigid.empty()) tie_spider(b, cap, node, rigid);
  return node;
}

// Sections of pipes and connectors are rigid: the node in the middle of the nearest one, and its
// distance along the pipe.
std::pair<int, double> nearest_section(const Building& b, const Vector3d& x) {
  std::pair<int, double> nearest{-1, std::numeric_limits<double>::infinity()};
  for (const std::string& name : b.rigid_sections)
    for (int node : b.built.model.mesh.sets.at(name + ".all"))
      if (const double along = std::abs(b.built.model.mesh.nodes[node].y() - x.y());
          along < nearest.second)
        nearest = {node, along};
  return nearest;
}

// A node of a beam whose section reaches to the sensor, and what is missing along the axis and
// beyond the section.
std::pair<int, double> nearest_beam(const Building& b, const Sensor& sensor) {
  std::pair<int, double> nearest{-1, std::numeric_limits<double>::infinity()};
  const auto& mesh = b.built.model.mesh;
  for (const Part& part : b.data.parts) {
    const auto* beam = std::get_if<BeamPart>(&part.body);
    if (!beam || is_on_axis(*beam)) continue;
    const PlaceOnAxis at = nearest_on_axis(*beam, sensor.at);
    const Vector3d from = vector(beam->points[at.stretch]);
    const Vector3d on_axis = from + at.share * (vector(beam->points[at.stretch + 1]) - from);
    const int node = nearest_of(mesh, mesh.sets.at(part.name + ".all"), on_axis);
    const double off = std::max(0., at.distance - outer_radius(beam->section));
    if (const double missing = std::hypot(off, (mesh.nodes[node] - on_axis).norm());
        missing < nearest.second)
      nearest = {node, missing};
  }
  return nearest;
}

} // namespace

void add_caps(Building& b) {
  for (const Cap& cap : b.data.caps) {
    const std::string key = cap_key(cap.name);
    const auto circle_of = [&](const std::string& end) -> const std::vector<int>& {
      return b.set(end, key + ".of");
    };
    std::vector<int> all, rigid, others; // others: across the springs of the cap
    const auto add = [&](std::vector<int>& to, const std::string& end) {
      const std::vector<int>& circle = circle_of(end);
      to.insert(to.end(), circle.begin(), circle.end());
    };
    for (const std::string& end : cap.of) {
      if (cap.stiffness && !all.empty()) {
        add(others, end);
        continue;
      }
      add(all, end);
      if (!hangs_on_springs(cap, end)) add(rigid, end);
    }
    const int node = add_body(b, cap.name, all, rigid);
    b.built.cap_nodes[cap.name] = node;
    for (const std::string& end : cap.of) b.built.end_nodes[end] = node;
    if (has_mass(cap.mass, cap.inertia))
      b.built.model.masses.push_back({node, rigid_mass(cap.mass, cap.inertia, cap.offset)});
    if (!others.empty()) {
      const int across = add_spider(b, cap.name, others);
      add_joint(b, key, node, across, *cap.stiffness, cap);
      for (std::size_t i = 1; i < cap.of.size(); ++i) b.built.end_nodes[cap.of[i]] = across;
    }
    for (const SprungEnd& e : cap.ends) {
      const int own = add_spider(b, cap.name, circle_of(e.end));
      add_joint(b, sprung_end_key(cap.name, e.end), arm_to(b, cap.name, node, own), own,
                e.stiffness, e);
      b.built.end_nodes[e.end] = own;
    }
  }
}

bool is_of_ends(const std::string& path) {
  const auto place = path_in_place(path);
  if (!place || place->kind == PlaceKind::part) return false;
  const std::string key = place->key.substr(0, place->key.find_first_of(".["));
  return place->kind == PlaceKind::cap ? key == "mass" || key == "inertia" || key == "offset"
                                       : key == "stiffness";
}

namespace {

bool same_springs(const std::vector<SprungEnd>& a, const std::vector<SprungEnd>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const SprungEnd& one, const SprungEnd& other) {
                      return one.end == other.end && one.stiffness == other.stiffness;
                    });
}

} // namespace

bool renew_ends(BuiltCase& built, const Case& before, const Case& after) {
  Model& model = built.model;
  if (before.caps.size() != after.caps.size() || before.mount.size() != after.mount.size())
    return false;
  for (std::size_t i = 0; i < after.caps.size(); ++i) {
    const Cap &old = before.caps[i], &cap = after.caps[i];
    if (old.name != cap.name || old.of != cap.of || old.stiffness != cap.stiffness ||
        !same_springs(old.ends, cap.ends))
      return false;
    const int node = built.cap_nodes.at(cap.name);
    if (has_mass(old.mass, old.inertia)) {
      const RigidMass body = rigid_mass(old.mass, old.inertia, old.offset);
      const auto own = std::find_if(model.masses.begin(), model.masses.end(), [&](const auto& m) {
        return m.node == node && m.body.mass == body.mass && m.body.offset == body.offset &&
               m.body.inertia == body.inertia;
      });
      if (own == model.masses.end()) return false;
      model.masses.erase(own);
    }
    if (has_mass(cap.mass, cap.inertia))
      model.masses.push_back({node, rigid_mass(cap.mass, cap.inertia, cap.offset)});
  }
  for (std::size_t i = 0; i < after.mount.size(); ++i) {
    const Mount &old = before.mount[i], &mount = after.mount[i];
    if (old.cap != mount.cap || old.kind != mount.kind) return false;
    if (mount.kind != MountKind::springs) continue;
    const auto spring =
        std::find_if(model.bushings.begin(), model.bushings.end(), [&](const BushingElement& b) {
          return b.node2 < 0 && model.components[std::size_t(b.component)] == mount_key(mount.cap);
        });
    if (spring == model.bushings.end()) return false;
    for (int k = 0; k < 6; ++k) spring->bushing.law(k, k) = mount.stiffness[std::size_t(k)];
  }
  return true;
}

namespace {

[[noreturn]] void no_mean_motion(const std::string& name) {
  input_error(part_key(name) + ".soft", "the set has no mean motion: its nodes lie on one line",
              "a circle, or no `soft`");
}

void tie_softly(Building& b, const std::string& name, int node, const std::vector<int>& nodes) {
  try {
    add_distributing_coupling(b.built.model, node, nodes, "mass " + name);
  } catch (const std::invalid_argument&) {
    no_mean_motion(name);
  }
}

} // namespace

void add_mass(Building& b, const std::string& name, const PointMass& mass) {
  const std::vector<int> nodes = b.set(mass.at, part_key(name) + ".at");
  int node = nodes.front();
  if (nodes.size() > 1) {
    node = add_node(b.built.model, centroid(b.built.model.mesh, nodes));
    if (!mass.soft) {
      const std::size_t first = b.built.model.constraints.size();
      add_kinematic_coupling(b.built.model, node, nodes, all_dofs, "rigid body of mass " + name);
      asked_at(b.built.model, first, part_key(name) + ".at");
    } else if (has_mass(mass.mass, mass.inertia))
      tie_softly(b, name, node, nodes);
    else // nothing is there but its node, which all states of a test have
      add_kinematic_coupling(b.built.model, nodes.front(), {node}, all_dofs, "mass " + name);
  } else if (mass.soft && has_mass(mass.mass, mass.inertia)) {
    no_mean_motion(name);
  }
  b.built.mass_nodes[name] = node;
  b.built.model.masses.push_back({node, rigid_mass(mass.mass, mass.inertia, mass.offset)});
}

void add_mount(Building& b) {
  for (const Mount& mount : b.data.mount) {
    const int node = b.built.cap_nodes.at(mount.cap);
    if (mount.kind == MountKind::rigid && b.follows_others(node))
      input_error(mount_key(mount.cap), "cannot be rigid: the node of that cap follows others",
                  "springs, or supports that hold those");
    if (mount.kind == MountKind::rigid) b.built.held_nodes.push_back(node);
    if (mount.kind != MountKind::springs) continue;
    BushingElement spring;
    spring.node1 = node;
    spring.component = b.component(mount_key(mount.cap));
    for (int i = 0; i < 6; ++i) spring.bushing.law(i, i) = mount.stiffness[i];
    b.built.model.bushings.push_back(spring);
    add_dampers(b, mount_key(mount.cap), -1, node, mount.stiffness, mount.damping);
    if (mount.friction)
      add_joints(b.built.joints, {mount_key(mount.cap), 0, -1, node, spring.component},
                 directional_laws(*mount.friction));
  }
}

void place_sensors(Building& b) {
  for (std::size_t i = 0; i < b.data.sensors.size(); ++i) {
    const Sensor& sensor = b.data.sensors[i];
    if (!sensor.on.empty()) continue; // it is not on the part
    auto [node, distance] = nearest_node(b.built.model.mesh, vector(sensor.at));
    auto [axis_node, along] = nearest_section(b, vector(sensor.at));
    if (const auto [beam_node, off] = nearest_beam(b, sensor); off < along) {
      axis_node = beam_node;
      along = off;
    }
    const bool has_place = along <= sensor.reach || !sensor.if_there;
    if (distance > sensor.reach && along < distance && has_place) {
      node = add_node(b.built.model, vector(sensor.at));
      add_kinematic_coupling(b.built.model, axis_node, {node}, all_dofs,
                             "arm of sensor " + sensor.name);
      distance = along;
    }
    if (distance > sensor.reach) {
      const WallPoint wall = nearest_on_wall(b.built.model, vector(sensor.at));
      if (const double off = off_wall(wall); off <= sensor.reach) {
        node = add_node(b.built.model, vector(sensor.at));
        tie_to_wall(b.built.model, node, wall, "sensor " + sensor.name);
        distance = off;
      }
    }
    constexpr double rounding = 5e-6; // of what the message shows
    if (distance > sensor.reach + rounding) {
      if (sensor.if_there) continue;
      const Vector3d& x = b.built.model.mesh.nodes[node];
      input_error("sensors[" + std::to_string(i) + "].at",
                  "sensor \"" + sensor.name + "\" is " + in_millimetres(distance) +
                      " away from the nearest node",
                  "at most " + short_number(1e3 * sensor.reach) + " mm; that node is at [" +
                      in_millimetres(x.x()) + ", " + in_millimetres(x.y()) + ", " +
                      in_millimetres(x.z()) + "]");
    }
    b.built.sensors.push_back(
        {sensor.name, node, distance, {sensor.axes[0], sensor.axes[1], sensor.axes[2]}});
    if (sensor.mass > 0) b.built.model.masses.push_back({node, rigid_mass(sensor.mass, {}, {})});
  }
}

} // namespace plica
