#include "model/shape/building.hpp"
#include "model/shape/constraint_clash.hpp"

#include "model/description/place_keys.hpp"
#include "solve/couplings.hpp"
#include "words/input_error.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::Vector3d;

// Reference node of the cap on a set, -1 = none.
int cap_on(const Building& b, const std::string& set) {
  const auto found = b.built.end_nodes.find(set);
  return found == b.built.end_nodes.end() ? -1 : found->second;
}

// The liner ends in the cap of that end; without a cap it follows the end circle.
int liner_end(Building& b, const std::string& name, const std::string& end,
              const Vector3d& centre) {
  const int cap = cap_on(b, end);
  if (cap >= 0) return cap;
  const std::vector<int> circle = b.built.model.mesh.sets.at(end);
  const int node = add_node(b.built.model, centre);
  const std::size_t first = b.built.model.constraints.size();
  add_distributing_coupling(b.built.model, node, circle, "end of interlock " + name);
  asked_at(b.built.model, first, part_key(name) + ".along");
  return node;
}

// Circles of the bellows at which the liner is tied, from left to right.
std::vector<std::vector<int>> liner_circles(const Building& b, const std::string& name,
                                            const Interlock& liner) {
  const auto& sets = b.built.model.mesh.sets;
  std::vector<std::vector<int>> roots;
  for (int k = 1; sets.contains(liner.along + ".root[" + std::to_string(k) + "]"); ++k)
    roots.push_back(sets.at(liner.along + ".root[" + std::to_string(k) + "]"));
  if (liner.attachment == Attachment::synchronous) return roots;
  if (liner.stations > static_cast<int>(roots.size()))
    input_error(part_key(name) + ".stations",
                std::to_string(liner.stations) + " stations on a bellows with " +
                    std::to_string(roots.size()) + " roots",
                "at most one station per root");
  std::vector<std::vector<int>> chosen;
  for (int i = 1; i <= liner.stations; ++i)
    chosen.push_back(roots[(roots.size() - 1) * i / (liner.stations + 1)]);
  return chosen;
}

// The liner leans on what a circle of the wall does on the mean.
void add_contact(Building& b, const LinerContact& contact, const Connection& between) {
  BushingElement springs{.node1 = between.node1, .node2 = between.node2, .bushing = {}};
  springs.component = between.component;
  const double across = contact.lateral, turning = contact.bending;
  springs.bushing.law.diagonal() << across, contact.axial, across, turning, contact.torsion,
      turning;
  if (!springs.bushing.law.isZero(0)) b.built.model.bushings.push_back(springs);
  if (contact.friction) add_joints(b.built.joints, between, directional_laws(*contact.friction));
}

// Nodes of the liner at the circles, which follow them, or lean on nodes that do.
std::vector<int> tied_nodes(Building& b, const std::string& name, const Interlock& liner,
                            const std::vector<std::vector<int>>& circles) {
  std::vector<int> nodes;
  const int springs = liner.contact ? b.component(contact_place(name)) : -1;
  for (const std::vector<int>& circle : circles) {
    const Vector3d centre = centroid(b.built.model.mesh, circle);
    const int on_wall = add_node(b.built.model, centre);
    nodes.push_back(on_wall);
    const std::size_t first = b.built.model.constraints.size();
    add_distributing_coupling(b.built.model, on_wall, circle, "tie of interlock " + name);
    asked_at(b.built.model, first, part_key(name) + ".attachment");
    if (!liner.contact) continue;
    nodes.back() = add_node(b.built.model, centre);
    add_contact(
        b, *liner.contact,
        {contact_place(name), static_cast<int>(nodes.size()), on_wall, nodes.back(), springs});
  }
  return nodes;
}

// Between the caps the liner is a beam with mass. Tied to the bellows its coils move with the
// circles, so each tied node carries the coils half way to its neighbours as a rigid ring.
void add_liner_elements(Building& b, const Interlock& liner, const std::vector<int>& nodes,
                        double length, int own) {
  const double m = liner.mass / length, r2 = liner.radius * liner.radius;
  BeamProperties section{.EA = liner.EA, .EI_y = liner.EI, .EI_z = liner.EI, .GJ = liner.GJ};
  const bool rings = liner.attachment != Attachment::caps;
  if (!rings) {
    section.mass = m;
    section.inertia_x = m * r2;
    section.inertia_y = section.inertia_z = m * r2 / 2;
  }
  const bool stiff = liner.EA > 0 || liner.EI > 0 || liner.GJ > 0;
  const auto& x = b.built.model.mesh.nodes;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    BeamElement beam;
    beam.node1 = nodes[i - 1];
    beam.node2 = nodes[i];
    beam.section = section;
    beam.component = own;
    if (stiff || !rings) b.built.model.beams.push_back(beam);
    if (!rings) continue;
    const double half = m * (x[nodes[i]] - x[nodes[i - 1]]).norm() / 2;
    for (int node : {nodes[i - 1], nodes[i]})
      b.built.model.masses.push_back(
          {node, rigid_mass(half, {half * r2 / 2, half * r2, half * r2 / 2, 0, 0, 0}, {})});
  }
}

// Laws of the whole, shared by segments in series between some of the nodes.
void add_segments(Building& b, const std::string& name, const std::vector<int>& nodes, int segments,
                  std::vector<DirectionalLaw> laws, int own) {
  const int stretches = static_cast<int>(nodes.size()) - 1;
  for (DirectionalLaw& d : laws) d.law = in_series(d.law, segments);
  for (int s = 0; s < segments; ++s)
    add_joints(b.built.joints,
               {name, s + 1, nodes[std::size_t(s * stretches / segments)],
                nodes[std::size_t((s + 1) * stretches / segments)], own},
               laws);
}

} // namespace

void add_liner(Building& b, const std::string& name, const Interlock& liner) {
  const auto& sets = b.built.model.mesh.sets;
  const Vector3d left = centroid(b.built.model.mesh, sets.at(liner.along + ".left"));
  const Vector3d right = centroid(b.built.model.mesh, sets.at(liner.along + ".right"));
  const double length = (right - left).norm();
  std::vector<int> nodes{liner_end(b, name, liner.along + ".left", left)};
  if (liner.attachment == Attachment::caps) {
    constexpr int elements = 16;
    for (int e = 1; e < elements; ++e)
      nodes.push_back(add_node(b.built.model, left + (right - left) * e / elements));
  } else {
    std::vector<std::vector<int>> circles = liner_circles(b, name, liner);
    std::erase_if(circles, [&](const std::vector<int>& circle) { // its ends are tied there
      const Vector3d centre = centroid(b.built.model.mesh, circle);
      return (centre - left).norm() < 1e-9 || (centre - right).norm() < 1e-9;
    });
    if (liner.contact && (circles.empty() || std::ssize(circles) < liner.stations))
      input_error(part_key(name) + ".contact",
                  "leans on the wall at " + std::to_string(circles.size()) +
                      " places only: at the ends of the bellows its own ends are tied",
                  "fewer stations, or cuffs between the ends and the convolutions");
    const std::vector<int> tied = tied_nodes(b, name, liner, circles);
    nodes.insert(nodes.end(), tied.begin(), tied.end());
  }
  nodes.push_back(liner_end(b, name, liner.along + ".right", right));
  const int own = b.component(name);
  add_liner_elements(b, liner, nodes, length, own);
  if (liner.friction)
    add_segments(b, name, nodes,
                 liner.attachment == Attachment::caps ? liner.friction->segments
                                                      : static_cast<int>(nodes.size()) - 1,
                 directional_laws(*liner.friction), own);
  b.built.model.mesh.sets[name + ".start"] = {nodes.front()};
  b.built.model.mesh.sets[name + ".end"] = {nodes.back()};
  b.built.model.mesh.sets[name + ".all"] = nodes;
}

// The plies stick to each other in pieces between nodes on the axis that follow root circles.
void add_ply_slip(Building& b, const std::string& name, const Bellows& bellows) {
  if (!bellows.wall.slip || b.state == JointState::stuck) return;
  const auto& sets = b.built.model.mesh.sets;
  const int segments = bellows.wall.slip->segments;
  std::vector<std::vector<int>> roots;
  for (int k = 1; sets.contains(name + ".root[" + std::to_string(k) + "]"); ++k)
    roots.push_back(sets.at(name + ".root[" + std::to_string(k) + "]"));
  const int stretches = static_cast<int>(roots.size()) - 1;
  if (segments > stretches)
    input_error(part_key(name) + ".wall.slip.segments",
                std::to_string(segments) + " segments on a bellows with " +
                    std::to_string(stretches) + " convolutions between roots",
                "at most one per convolution");
  const Vector3d left = centroid(b.built.model.mesh, sets.at(name + ".left"));
  const Vector3d right = centroid(b.built.model.mesh, sets.at(name + ".right"));
  std::vector<int> nodes{liner_end(b, name, name + ".left", left)};
  for (int s = 1; s < segments; ++s) {
    const std::vector<int>& circle = roots[std::size_t(s * stretches / segments)];
    nodes.push_back(add_node(b.built.model, centroid(b.built.model.mesh, circle)));
    add_distributing_coupling(b.built.model, nodes.back(), circle, "plies of " + name);
  }
  nodes.push_back(liner_end(b, name, name + ".right", right));
  const auto& all = b.built.model.components;
  add_segments(b, name, nodes, segments, b.plies.at(name),
               int(std::find(all.begin(), all.end(), name) - all.begin()));
}

} // namespace plica
