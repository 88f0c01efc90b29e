#include "diagnose/predict/sprung_clamps.hpp"

#include "model/description/place_keys.hpp"
#include "model/shape/build.hpp"
#include "solve/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

bool is_mounted(const Case& data, const std::string& cap) {
  return std::any_of(data.mount.begin(), data.mount.end(),
                     [&](const Mount& m) { return m.cap == cap && m.kind != MountKind::free; });
}

// Of a cap, those that it holds rigidly and that may give way: against each other, against its
// mount or against what already hangs on springs.
std::vector<std::string> rigid_ends(const Case& data, const Cap& cap) {
  if (cap.of.size() < 2 || cap.stiffness) return {};
  std::vector<std::string> ends = cap.of;
  std::erase_if(ends, [&](const std::string& end) { return hangs_on_springs(cap, end); });
  if (ends.size() == 1 && !is_mounted(data, cap.name)) ends.clear(); // it is the cap
  return ends;
}

// What the elements at a node resist to one of its motions, all other nodes held. A node that
// follows others, as the arm of a chain does, moves by what each of these gives way. 0: nothing.
double resistance(const System& system, int node, int direction) {
  const auto dof = std::size_t(6 * node + direction);
  const auto own = [&](int i) { return system.K.coeff(i, i); };
  if (const int i = system.map.independent[dof]; i >= 0) return own(i);
  double compliance = 0;
  for (const WeightedDof& w : system.map.dependent[dof])
    compliance += w.factor * w.factor / own(w.dof);
  return compliance > 0 ? 1 / compliance : 0;
}

// In all three translations, or from 3 on in all three rotations; 0: in one of them nothing does.
double largest_resistance(const System& system, int node, int first) {
  double largest = 0;
  for (int d = first; d < first + 3; ++d) {
    const double own = resistance(system, node, d);
    if (!(own > 0)) return 0;
    largest = std::max(largest, own);
  }
  return largest;
}

// As it is without mounts and supports, so that nodes that these hold have what the parts resist.
System unheld(const Case& data, Model& model) {
  std::set<std::string> mounts;
  for (const Mount& m : data.mount) mounts.insert(mount_key(m.cap));
  std::erase_if(model.bushings, [&](const BushingElement& b) {
    return b.node2 < 0 && mounts.contains(model.components[std::size_t(b.component)]);
  });
  std::erase_if(model.constraints, [](const Constraint& c) { return c.terms.empty(); });
  return assemble(model);
}

// Whether the springs of the cap stand where its node is, so that they move nothing else.
bool meet_in_one_place(const BuiltCase& built, const Cap& cap) {
  const Mesh& mesh = built.model.mesh;
  constexpr double same_place = 1e-6; // m
  const Eigen::Vector3d& own = mesh.nodes[std::size_t(built.cap_nodes.at(cap.name))];
  return std::all_of(cap.of.begin(), cap.of.end(), [&](const std::string& end) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const std::vector<int>& nodes = mesh.sets.at(end);
    for (int node : nodes) middle += mesh.nodes[std::size_t(node)] / double(nodes.size());
    return (middle - own).norm() < same_place;
  });
}

// The next power of ten, which an explained case then shows.
double rigid_beside(double resistance) {
  constexpr double times = 1e3;
  return std::pow(10, std::ceil(std::log10(times * resistance)));
}

} // namespace

std::vector<std::string> put_springs_in_clamps(Case& data) {
  std::vector<Cap*> clamps;
  for (Cap& cap : data.caps)
    if (!rigid_ends(data, cap).empty()) clamps.push_back(&cap);
  if (clamps.empty()) return {};
  BuiltCase built = build(data);
  const System system = unheld(data, built.model);
  double moving = 0, turning = 0;
  std::erase_if(clamps, [&](const Cap* clamp) {
    const int node = built.cap_nodes.at(clamp->name);
    const double translation = largest_resistance(system, node, 0),
                 rotation = largest_resistance(system, node, 3);
    if (!(translation > 0 && rotation > 0)) return true;
    moving = std::max(moving, translation);
    turning = std::max(turning, rotation);
    return false;
  });
  std::vector<std::string> places;
  for (Cap* clamp : clamps) {
    const double k = rigid_beside(moving), k_turning = rigid_beside(turning);
    const Sextuple springs{k, k, k, k_turning, k_turning, k_turning};
    const std::vector<std::string> ends = rigid_ends(data, *clamp);
    if (clamp->of.size() == 2 && ends.size() == 2 && !is_mounted(data, clamp->name) &&
        meet_in_one_place(built, *clamp)) {
      clamp->stiffness = springs;
      places.push_back(cap_key(clamp->name));
      continue;
    }
    for (const std::string& end : ends) {
      clamp->ends.push_back({.end = end, .stiffness = springs});
      places.push_back(sprung_end_key(clamp->name, end));
    }
  }
  return places;
}

std::vector<std::string> clamps_left_rigid(const Case& data) {
  std::vector<std::string> found;
  for (const Cap& cap : data.caps)
    if (!rigid_ends(data, cap).empty()) found.push_back(cap_key(cap.name));
  return found;
}

} // namespace plica
