#include "model/shape/build.hpp"

#include "model/shape/building.hpp"
#include "model/shape/constraint_clash.hpp"
#include "model/shape/wall_places.hpp"
#include "solve/couplings.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <unordered_map>

namespace plica {
namespace {

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

BuiltCase built_case(const Case& data, JointState state, const PlyLaws& plies) {
  Building b{.data = data, .state = state, .plies = plies};
  add_parts(b); // first: caps and liners refer to them
  add_caps(b);
  for (const Part& part : data.parts) {
    if (const auto* liner = std::get_if<Interlock>(&part.body)) add_liner(b, part.name, *liner);
    if (const auto* mass = std::get_if<PointMass>(&part.body)) add_mass(b, part.name, *mass);
    if (const auto* bellows = std::get_if<Bellows>(&part.body))
      add_ply_slip(b, part.name, *bellows);
  }
  add_mount(b);
  for (std::size_t i = 0; i < data.supports.size(); ++i) {
    const Support& support = data.supports[i];
    const std::string key = "supports[" + std::to_string(i) + "]";
    const std::size_t first = b.built.model.constraints.size();
    add_support(b.built.model, b.set(support.set, key + ".set"), support.dofs,
                "support of " + support.set);
    asked_at(b.built.model, first, key + ".set");
  }
  add_springs(b.built.model, b.built.joints, state);
  tie_wall_places(b);
  place_sensors(b);
  return std::move(b.built);
}

} // namespace

int Building::component(const std::string& name) {
  built.model.components.push_back(name);
  return static_cast<int>(built.model.components.size()) - 1;
}

const std::vector<int>& Building::set(const std::string& name, const std::string& key) const {
  const auto found = built.model.mesh.sets.find(name);
  if (found == built.model.mesh.sets.end())
    input_error(key, "there is no set \"" + name + "\" on the mesh",
                sets_beside(built.model, name));
  return found->second;
}

bool Building::follows_others(int node) const {
  return !followers_among({node}).empty();
}

std::set<int> Building::followers_among(const std::vector<int>& nodes) const {
  std::unordered_map<int, int> rows;
  for (const int node : nodes) rows[node] = 0;
  for (const Constraint& row : built.model.constraints)
    if (const auto own = rows.find(row.node); own != rows.end() && !row.terms.empty())
      ++own->second;
  std::set<int> followers;
  for (const auto& [node, count] : rows)
    if (count == 6) followers.insert(node);
  return followers;
}

bool Building::is_on_wall(int node) const {
  return std::any_of(wall_places.begin(), wall_places.end(),
                     [&](const PlacedOnWall& place) { return place.node == node; });
}

Eigen::Vector3d vector(const Triple& t) {
  return {t[0], t[1], t[2]};
}

RigidMass rigid_mass(double mass, const Sextuple& J, const Triple& offset) {
  RigidMass body{.mass = mass, .offset = vector(offset), .inertia = {}};
  body.inertia << J[0], J[3], J[5], J[3], J[1], J[4], J[5], J[4], J[2];
  return body;
}

Eigen::Vector3d centroid(const Mesh& mesh, const std::vector<int>& nodes) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int node : nodes) sum += mesh.nodes[node];
  return sum / double(nodes.size());
}

BuiltCase build(const Case& data) {
  return built_case(data, JointState::stuck, {});
}

BuiltCase build_slipping(const Case& data, const PlyLaws& plies) {
  return built_case(data, JointState::slipping, plies);
}

} // namespace plica
