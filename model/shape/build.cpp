#include "model/shape/build.hpp"

#include "mesh/dent.hpp"
#include "mesh/plate.hpp"
#include "model/shape/build_bellows.hpp"
#include "model/shape/build_deck.hpp"
#include "model/shape/build_pipes.hpp"
#include "model/shape/build_surface.hpp"
#include "model/description/connector_curve.hpp"
#include "words/input_error.hpp"
#include "solve/couplings.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace plica {
namespace {

using Eigen::Vector3d;

constexpr std::initializer_list<int> all_dofs{0, 1, 2, 3, 4, 5};

std::string millimetres(double length) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f mm", 1e3 * length);
  return text.data();
}

Vector3d vector(const Triple& t) {
  return {t[0], t[1], t[2]};
}

RigidMass rigid_mass(double mass, const Sextuple& J, const Triple& offset) {
  RigidMass body{.mass = mass, .offset = vector(offset), .inertia = {}};
  body.inertia << J[0], J[3], J[5], J[3], J[1], J[4], J[5], J[4], J[2];
  return body;
}

bool has_mass(double mass, const Sextuple& J) {
  return mass > 0 || std::any_of(J.begin(), J.end(), [](double v) { return v != 0; });
}

// The sets of the same part, the first of them.
std::string sets_beside(const Model& model, const std::string& name) {
  constexpr int most = 12;
  const std::string part = name.substr(0, name.find('.') + 1);
  std::string text;
  int count = 0;
  for (const auto& [set, nodes] : model.mesh.sets)
    if (set.starts_with(part) && ++count <= most) text += (text.empty() ? "" : ", ") + set;
  return text + (count > most ? ", ..." : "");
}

const std::vector<int>& set_of(const Model& model, const std::string& name,
                               const std::string& key) {
  const auto found = model.mesh.sets.find(name);
  if (found == model.mesh.sets.end())
    input_error(key, "there is no set \"" + name + "\" on the mesh", sets_beside(model, name));
  return found->second;
}

void require_unfolded(const Mesh& mesh, const std::string& key, const std::string& allowed) {
  const double ratio = mesh_quality(mesh).min_jacobian;
  if (ratio > folded_ratio) return;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", ratio);
  input_error(key,
              std::string("folds the mesh: a quad is turned over (Jacobian ratio ") + text.data() +
                  ")",
              allowed);
}

Vector3d centroid(const Mesh& mesh, const std::vector<int>& nodes) {
  Vector3d sum = Vector3d::Zero();
  for (int node : nodes) sum += mesh.nodes[node];
  return sum / double(nodes.size());
}

class Builder {
public:
  Builder(const Case& data, JointState state, const PlyLaws& plies)
      : case_(data), state_(state), plies_(plies) {}

  BuiltCase build() {
    for (const Part& part : case_.parts) // shells and beams first: caps and liners refer to them
      std::visit([&](const auto& body) { add(part.name, body); }, part.body);
    add_caps();
    for (const Part& part : case_.parts) {
      if (const auto* liner = std::get_if<Interlock>(&part.body)) add_liner(part.name, *liner);
      if (const auto* mass = std::get_if<PointMass>(&part.body)) add_mass(part.name, *mass);
      if (const auto* bellows = std::get_if<Bellows>(&part.body)) add_ply_slip(part.name, *bellows);
    }
    add_mount();
    for (std::size_t i = 0; i < case_.supports.size(); ++i) {
      const Support& support = case_.supports[i];
      const std::string key = "supports[" + std::to_string(i) + "]";
      add_support(built_.model, set_of(built_.model, support.set, key + ".set"), support.dofs,
                  "support of " + support.set);
    }
    add_springs(built_.model, built_.joints, state_);
    place_sensors();
    return std::move(built_);
  }

private:
  // New name under which elements store their strain energy.
  int component(const std::string& name) {
    built_.model.components.push_back(name);
    return static_cast<int>(built_.model.components.size()) - 1;
  }

  void add(const std::string& name, const Bellows& bellows) {
    const Meridian meridian = bellows_meridian(bellows);
    const int section = static_cast<int>(built_.model.shells.size());
    Mesh mesh = bellows_mesh(bellows, meridian);
    for (std::size_t i = 0; i < bellows.dents.size(); ++i) {
      const DentSpot& dent = bellows.dents[i];
      if (press(mesh, {vector(dent.at), dent.depth, dent.radius}) < 3)
        input_error("parts." + name + ".dents[" + std::to_string(i) + "]",
                    "has fewer than three nodes of the wall within its radius",
                    "a place on the wall, and a radius of a few elements");
      require_unfolded(mesh, "parts." + name + ".dents[" + std::to_string(i) + "]",
                       "a shallower or a wider dent: its flank turns the wall over");
    }
    append(built_.model.mesh, mesh, name, section);
    const Material& m = case_.materials.at(bellows.material);
    built_.model.shells.push_back(
        {{.E = m.E,
          .nu = m.nu,
          .rho = m.rho,
          .bending_factor = ply_bending_factor(bellows.wall.plies, bond(bellows.wall))},
         bellows.membrane,
         component(name)});
    if (!built_.meridian.empty() && bellows.start < built_.meridian.back()[0] - 1e-9) return;
    for (const auto& curve : mesh_meridian(meridian))
      for (const MeridianPoint& p : curve)
        built_.meridian.push_back({p.position.x(), p.position.y()});
  }

  double bond(const Wall& wall) const {
    return wall.slip && state_ == JointState::stuck ? wall.slip->bond : wall.bond;
  }

  void add(const std::string& name, const Plate& plate) {
    const std::array corners{vector(plate.corners[0]), vector(plate.corners[1]),
                             vector(plate.corners[2]), vector(plate.corners[3])};
    const int section = static_cast<int>(built_.model.shells.size());
    const Mesh mesh = mesh_plate(corners, plate.elements[0], plate.elements[1], plate.thickness);
    require_unfolded(mesh, "parts." + name + ".corners",
                     "four corners in order round the plate, each with an inner angle below 180 "
                     "deg; two plates where one is concave");
    append(built_.model.mesh, mesh, name, section);
    const Material& m = case_.materials.at(plate.material);
    built_.model.shells.push_back(
        {{.E = m.E, .nu = m.nu, .rho = m.rho}, plate.membrane, component(name)});
  }

  void add(const std::string& name, const SurfacePart& surface) {
    const int section = static_cast<int>(built_.model.shells.size());
    Mesh mesh;
    try {
      mesh = surface_mesh(surface);
    } catch (const std::runtime_error& error) {
      input_error("parts." + name, error.what(),
                  "a surface that can be meshed, and places near it");
    }
    append(built_.model.mesh, mesh, name, section);
    const Material& m = case_.materials.at(surface.material);
    built_.model.shells.push_back(
        {{.E = m.E, .nu = m.nu, .rho = m.rho}, surface.membrane, component(name)});
  }

  void add(const std::string& name, const DeckPart& deck) {
    const int own = component(name);
    try {
      append(built_.model, deck_model(deck), name, own);
    } catch (const InputError&) {
      throw;
    } catch (const std::exception& error) {
      input_error("parts." + name + ".file", error.what(), "a deck as docs/decks.md has it");
    }
  }

  void add(const std::string& name, const BeamPart& beam) {
    const BeamProperties section = beam_properties(beam.section);
    const int own = component(name);
    const int first = add_node(built_.model, vector(beam.points.front()));
    built_.model.mesh.sets[name + ".point[1]"] = {first};
    int previous = first;
    for (std::size_t p = 1; p < beam.points.size(); ++p) {
      const Vector3d a = vector(beam.points[p - 1]), b = vector(beam.points[p]);
      for (int e = 1; e <= beam.elements; ++e) {
        const int next = add_node(built_.model, a + (b - a) * e / beam.elements);
        built_.model.beams.push_back({.node1 = previous,
                                      .node2 = next,
                                      .section = section,
                                      .up = vector(beam.up),
                                      .component = own});
        previous = next;
      }
      built_.model.mesh.sets[name + ".point[" + std::to_string(p + 1) + "]"] = {previous};
    }
    name_line(name, first, previous);
    if (is_on_axis(beam)) rigid_sections_.push_back(name);
  }

  void add(const std::string& name, const EquivalentPipe& pipe) {
    const int own = component(name);
    name_ends(name, add_pipe(built_.model, pipe, case_.materials.at(pipe.material), own));
  }

  void add(const std::string& name, const ConnectorChain& chain) {
    const int own = component(name);
    const auto first = built_.model.bushings.size();
    name_ends(name, add_chain(built_.model, chain, own, name));
    for (std::size_t k = first; k < built_.model.bushings.size(); ++k) {
      const BushingElement& link = built_.model.bushings[k];
      const bool at_end = k == first || k + 1 == built_.model.bushings.size();
      const Connection between{name, int(k - first) + 1, link.node1, link.node2, own};
      add_curves(built_.joints, between,
                 at_end && chain.end_spring ? *chain.end_spring : chain.spring);
      if (chain.friction) add_joints(built_.joints, between, directional_laws(*chain.friction));
    }
  }

  void name_ends(const std::string& name, const AxisNodes& nodes) {
    rigid_sections_.push_back(name);
    auto& sets = built_.model.mesh.sets;
    sets[name + ".left"] = {nodes.left};
    sets[name + ".right"] = {nodes.right};
    for (int node = nodes.left; node <= nodes.right; ++node) sets[name + ".all"].push_back(node);
  }

  void add(const std::string&, const Interlock&) {}
  void add(const std::string&, const PointMass&) {}

  void name_line(const std::string& name, int first, int last) {
    auto& sets = built_.model.mesh.sets;
    sets[name + ".start"] = {first};
    sets[name + ".end"] = {last};
    for (int node = first; node <= last; ++node) sets[name + ".all"].push_back(node);
  }

  BeamProperties beam_properties(const BeamSection& s) const {
    if (s.shape == BeamShape::general) {
      constexpr double rigid = std::numeric_limits<double>::infinity();
      return {.EA = s.EA.value_or(0),
              .EI_y = s.EI.value_or(0),
              .EI_z = s.EI.value_or(0),
              .GJ = s.GJ.value_or(0),
              .GA_y = s.GA.value_or(rigid),
              .GA_z = s.GA.value_or(rigid),
              .mass = s.mass_per_length,
              .inertia_x = s.polar_inertia_per_length,
              .inertia_y = s.rotary_inertia_per_length,
              .inertia_z = s.rotary_inertia_per_length};
    }
    const Material& m = case_.materials.at(s.material);
    const BeamMaterial material{m.E, m.nu, m.rho};
    if (s.shape == BeamShape::rectangle) return rectangle_section(material, s.width, s.depth);
    if (s.shape == BeamShape::solid) return round_section(material, s.radius);
    return pipe_section(material, s.radius, s.thickness);
  }

  // A node that follows others in all directions, such as the reference of an RBE3.
  bool follows_others(int node) const {
    const auto& rows = built_.model.constraints;
    return std::count_if(rows.begin(), rows.end(), [&](const Constraint& row) {
             return row.node == node && !row.terms.empty();
           }) == 6;
  }

  // Reference node in the middle of the circles, tied rigidly to them. One that follows others
  // cannot follow it too: it leads them.
  int add_spider(const std::string& cap, const std::vector<int>& circles) {
    const auto leads = [&](int node) { return follows_others(node); };
    if (const auto leader = std::find_if(circles.begin(), circles.end(), leads);
        leader != circles.end() && std::none_of(leader + 1, circles.end(), leads)) {
      std::vector<int> others = circles;
      std::erase(others, *leader);
      if (!others.empty())
        add_kinematic_coupling(built_.model, *leader, others, all_dofs, "spider of cap " + cap);
      return *leader;
    }
    const int node = add_node(built_.model, centroid(built_.model.mesh, circles));
    add_kinematic_coupling(built_.model, node, circles, all_dofs, "spider of cap " + cap);
    return node;
  }

  void add_caps() {
    for (const Cap& cap : case_.caps) {
      std::vector<int> first, others;
      for (const std::string& end : cap.of) {
        const std::vector<int>& circle = set_of(built_.model, end, "caps." + cap.name + ".of");
        std::vector<int>& side = first.empty() || !cap.stiffness ? first : others;
        side.insert(side.end(), circle.begin(), circle.end());
      }
      const int node = add_spider(cap.name, first);
      built_.cap_nodes[cap.name] = node;
      for (const std::string& end : cap.of) cap_of_end_[end] = node;
      if (has_mass(cap.mass, cap.inertia))
        built_.model.masses.push_back({node, rigid_mass(cap.mass, cap.inertia, cap.offset)});
      if (!others.empty()) add_joint(cap, node, others);
    }
  }

  void add_joint(const Cap& cap, int node, const std::vector<int>& others) {
    BushingElement joint{.node1 = node, .node2 = add_spider(cap.name, others), .bushing = {}};
    joint.component = component("caps." + cap.name);
    for (int i = 0; i < 6; ++i) joint.bushing.law(i, i) = (*cap.stiffness)[i];
    built_.model.bushings.push_back(joint);
    if (cap.friction)
      add_joints(built_.joints, {"caps." + cap.name, 0, joint.node1, joint.node2, joint.component},
                 directional_laws(*cap.friction));
    for (std::size_t i = 1; i < cap.of.size(); ++i) cap_of_end_[cap.of[i]] = joint.node2;
  }

  // Reference node of the cap on a set, -1 = none.
  int cap_on(const std::string& set) const {
    const auto found = cap_of_end_.find(set);
    return found == cap_of_end_.end() ? -1 : found->second;
  }

  void add_mass(const std::string& name, const PointMass& mass) {
    const std::vector<int> nodes = set_of(built_.model, mass.at, "parts." + name + ".at");
    int node = nodes.front();
    if (nodes.size() > 1) {
      node = add_node(built_.model, centroid(built_.model.mesh, nodes));
      add_kinematic_coupling(built_.model, node, nodes, all_dofs, "rigid body of mass " + name);
    }
    built_.model.masses.push_back({node, rigid_mass(mass.mass, mass.inertia, mass.offset)});
  }

  // Circles of the bellows at which the liner is tied, from left to right.
  std::vector<std::vector<int>> liner_circles(const std::string& name,
                                              const Interlock& liner) const {
    const auto& sets = built_.model.mesh.sets;
    std::vector<std::vector<int>> roots;
    for (int k = 1; sets.contains(liner.along + ".root[" + std::to_string(k) + "]"); ++k)
      roots.push_back(sets.at(liner.along + ".root[" + std::to_string(k) + "]"));
    if (liner.attachment == Attachment::synchronous) return roots;
    if (liner.stations > static_cast<int>(roots.size()))
      input_error("parts." + name + ".stations",
                  std::to_string(liner.stations) + " stations on a bellows with " +
                      std::to_string(roots.size()) + " roots",
                  "at most one station per root");
    std::vector<std::vector<int>> chosen;
    for (int i = 1; i <= liner.stations; ++i)
      chosen.push_back(roots[(roots.size() - 1) * i / (liner.stations + 1)]);
    return chosen;
  }

  void add_liner(const std::string& name, const Interlock& liner) {
    const auto& sets = built_.model.mesh.sets;
    const Vector3d left = centroid(built_.model.mesh, sets.at(liner.along + ".left"));
    const Vector3d right = centroid(built_.model.mesh, sets.at(liner.along + ".right"));
    const double length = (right - left).norm();
    std::vector<int> nodes{liner_end(name, liner.along + ".left", left)};
    if (liner.attachment == Attachment::caps) {
      constexpr int elements = 16;
      for (int e = 1; e < elements; ++e)
        nodes.push_back(add_node(built_.model, left + (right - left) * e / elements));
    } else {
      for (const std::vector<int>& circle : liner_circles(name, liner)) {
        const Vector3d centre = centroid(built_.model.mesh, circle);
        if ((centre - left).norm() < 1e-9 || (centre - right).norm() < 1e-9) continue;
        nodes.push_back(add_node(built_.model, centre));
        add_distributing_coupling(built_.model, nodes.back(), circle, "tie of interlock " + name);
      }
    }
    nodes.push_back(liner_end(name, liner.along + ".right", right));
    const int own = component(name);
    add_liner_elements(liner, nodes, length, own);
    if (liner.friction)
      add_segments(name, nodes,
                   liner.attachment == Attachment::caps ? liner.friction->segments
                                                        : static_cast<int>(nodes.size()) - 1,
                   directional_laws(*liner.friction), own);
    built_.model.mesh.sets[name + ".start"] = {nodes.front()};
    built_.model.mesh.sets[name + ".end"] = {nodes.back()};
    built_.model.mesh.sets[name + ".all"] = nodes;
  }

  // Laws of the whole, shared by segments in series between some of the nodes.
  void add_segments(const std::string& name, const std::vector<int>& nodes, int segments,
                    std::vector<DirectionalLaw> laws, int own) {
    const int stretches = static_cast<int>(nodes.size()) - 1;
    for (DirectionalLaw& d : laws) d.law = in_series(d.law, segments);
    for (int s = 0; s < segments; ++s)
      add_joints(built_.joints,
                 {name, s + 1, nodes[std::size_t(s * stretches / segments)],
                  nodes[std::size_t((s + 1) * stretches / segments)], own},
                 laws);
  }

  // The plies stick to each other in pieces between nodes on the axis that follow root circles.
  void add_ply_slip(const std::string& name, const Bellows& bellows) {
    if (!bellows.wall.slip || state_ == JointState::stuck) return;
    const auto& sets = built_.model.mesh.sets;
    const int segments = bellows.wall.slip->segments;
    std::vector<std::vector<int>> roots;
    for (int k = 1; sets.contains(name + ".root[" + std::to_string(k) + "]"); ++k)
      roots.push_back(sets.at(name + ".root[" + std::to_string(k) + "]"));
    const int stretches = static_cast<int>(roots.size()) - 1;
    if (segments > stretches)
      input_error("parts." + name + ".wall.slip.segments",
                  std::to_string(segments) + " segments on a bellows with " +
                      std::to_string(stretches) + " convolutions between roots",
                  "at most one per convolution");
    const Vector3d left = centroid(built_.model.mesh, sets.at(name + ".left"));
    const Vector3d right = centroid(built_.model.mesh, sets.at(name + ".right"));
    std::vector<int> nodes{liner_end(name, name + ".left", left)};
    for (int s = 1; s < segments; ++s) {
      const std::vector<int>& circle = roots[std::size_t(s * stretches / segments)];
      nodes.push_back(add_node(built_.model, centroid(built_.model.mesh, circle)));
      add_distributing_coupling(built_.model, nodes.back(), circle, "plies of " + name);
    }
    nodes.push_back(liner_end(name, name + ".right", right));
    const auto& all = built_.model.components;
    add_segments(name, nodes, segments, plies_.at(name),
                 int(std::find(all.begin(), all.end(), name) - all.begin()));
  }

  // Between the caps the liner is a beam with mass. Tied to the bellows its coils move with the
  // circles, so each tied node carries the coils half way to its neighbours as a rigid ring.
  void add_liner_elements(const Interlock& liner, const std::vector<int>& nodes, double length,
                          int own) {
    const double m = liner.mass / length, r2 = liner.radius * liner.radius;
    BeamProperties section{.EA = liner.EA, .EI_y = liner.EI, .EI_z = liner.EI, .GJ = liner.GJ};
    const bool rings = liner.attachment != Attachment::caps;
    if (!rings) {
      section.mass = m;
      section.inertia_x = m * r2;
      section.inertia_y = section.inertia_z = m * r2 / 2;
    }
    const bool stiff = liner.EA > 0 || liner.EI > 0 || liner.GJ > 0;
    const auto& x = built_.model.mesh.nodes;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      BeamElement beam;
      beam.node1 = nodes[i - 1];
      beam.node2 = nodes[i];
      beam.section = section;
      beam.component = own;
      if (stiff || !rings) built_.model.beams.push_back(beam);
      if (!rings) continue;
      const double half = m * (x[nodes[i]] - x[nodes[i - 1]]).norm() / 2;
      for (int node : {nodes[i - 1], nodes[i]})
        built_.model.masses.push_back(
            {node, rigid_mass(half, {half * r2 / 2, half * r2, half * r2 / 2, 0, 0, 0}, {})});
    }
  }

  // The liner ends in the cap of that end; without a cap it follows the end circle.
  int liner_end(const std::string& name, const std::string& end, const Vector3d& centre) {
    const int cap = cap_on(end);
    if (cap >= 0) return cap;
    const std::vector<int> circle = built_.model.mesh.sets.at(end);
    const int node = add_node(built_.model, centre);
    add_distributing_coupling(built_.model, node, circle, "end of interlock " + name);
    return node;
  }

  void add_mount() {
    for (const Mount& mount : case_.mount) {
      const int node = built_.cap_nodes.at(mount.cap);
      if (mount.kind == MountKind::rigid && follows_others(node))
        input_error("mount." + mount.cap, "cannot be rigid: the node of that cap follows others",
                    "springs, or supports that hold those");
      if (mount.kind == MountKind::rigid) built_.held_nodes.push_back(node);
      if (mount.kind != MountKind::springs) continue;
      BushingElement spring;
      spring.node1 = node;
      spring.component = component("mount." + mount.cap);
      for (int i = 0; i < 6; ++i) spring.bushing.law(i, i) = mount.stiffness[i];
      built_.model.bushings.push_back(spring);
      if (mount.friction)
        add_joints(built_.joints, {"mount." + mount.cap, 0, -1, node, spring.component},
                   directional_laws(*mount.friction));
    }
  }

  // Sections of pipes and connectors are rigid: the node in the middle of the nearest one, and its
  // distance along the pipe.
  std::pair<int, double> nearest_section(const Vector3d& x) const {
    std::pair<int, double> nearest{-1, std::numeric_limits<double>::infinity()};
    for (const std::string& name : rigid_sections_)
      for (int node : built_.model.mesh.sets.at(name + ".all"))
        if (const double along = std::abs(built_.model.mesh.nodes[node].y() - x.y());
            along < nearest.second)
          nearest = {node, along};
    return nearest;
  }

  void place_sensors() {
    for (std::size_t i = 0; i < case_.sensors.size(); ++i) {
      const Sensor& sensor = case_.sensors[i];
      auto [node, distance] = nearest_node(built_.model.mesh, vector(sensor.at));
      const auto [axis_node, along] = nearest_section(vector(sensor.at));
      if (distance > sensor.reach && along < distance) {
        node = add_node(built_.model, vector(sensor.at));
        add_kinematic_coupling(built_.model, axis_node, {node}, all_dofs,
                               "arm of sensor " + sensor.name);
        distance = along;
      }
      if (distance > sensor.reach) {
        const Vector3d& x = built_.model.mesh.nodes[node];
        input_error("sensors[" + std::to_string(i) + "].at",
                    "sensor \"" + sensor.name + "\" is " + millimetres(distance) +
                        " away from the nearest node",
                    "at most 5 mm; that node is at [" + millimetres(x.x()) + ", " +
                        millimetres(x.y()) + ", " + millimetres(x.z()) + "]");
      }
      built_.sensors.push_back(
          {sensor.name, node, distance, {sensor.axes[0], sensor.axes[1], sensor.axes[2]}});
      if (sensor.mass > 0) built_.model.masses.push_back({node, rigid_mass(sensor.mass, {}, {})});
    }
  }

  const Case& case_;
  JointState state_;
  const PlyLaws& plies_;
  BuiltCase built_;
  std::map<std::string, int> cap_of_end_;
  std::vector<std::string> rigid_sections_; // parts whose sections are
};

} // namespace

BuiltCase build(const Case& data) {
  return Builder(data, JointState::stuck, {}).build();
}

BuiltCase build_slipping(const Case& data, const PlyLaws& plies) {
  return Builder(data, JointState::slipping, plies).build();
}

} // namespace plica
