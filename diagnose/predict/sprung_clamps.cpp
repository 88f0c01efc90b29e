#include "diagnose/predict/sprung_clamps.hpp"

#include "model/description/place_keys.hpp"
#include "model/shape/build.hpp"
#include "solve/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

std::set<std::string> parts_of(const Cap& cap) {
  std::set<std::string> parts;
  for (const std::string& end : cap.of) parts.insert(part_of_set(end));
  return parts;
}

bool side_by_side(const std::set<std::string>& parts, const Cap& other) {
  const std::set<std::string> there = parts_of(other);
  return std::count_if(parts.begin(), parts.end(),
                       [&](const std::string& part) { return there.contains(part); }) > 1;
}

bool joins_in_a_row(const Case& data, const Cap& cap) {
  const std::set<std::string> parts = parts_of(cap);
  return cap.of.size() > 1 && parts.size() == cap.of.size() &&
         std::none_of(data.caps.begin(), data.caps.end(), [&](const Cap& other) {
           return other.name != cap.name && side_by_side(parts, other);
         });
}

bool is_mounted(const Case& data, const std::string& cap) {
  return std::any_of(data.mount.begin(), data.mount.end(),
                     [&](const Mount& m) { return m.cap == cap && m.kind != MountKind::free; });
}

// What the elements at a node resist to one of its motions, all other nodes held. A node that
// follows others, as the arm of a chain does, moves by what each of these gives way. 0: it is held.
double resistance(const System& system, int node, int direction) {
  const auto dof = std::size_t(6 * node + direction);
  const auto own = [&](int i) { return system.K.coeff(i, i); };
  if (const int i = system.map.independent[dof]; i >= 0) return own(i);
  double compliance = 0;
  for (const WeightedDof& w : system.map.dependent[dof])
    compliance += w.factor * w.factor / own(w.dof);
  return compliance > 0 ? 1 / compliance : 0;
}

// In all three translations, or from 3 on in all three rotations; 0: one of them is held.
double largest_resistance(const System& system, int node, int first) {
  double largest = 0;
  for (int d = first; d < first + 3; ++d) {
    const double own = resistance(system, node, d);
    if (!(own > 0)) return 0;
    largest = std::max(largest, own);
  }
  return largest;
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
    if (!cap.stiffness && !is_mounted(data, cap.name) && joins_in_a_row(data, cap))
      clamps.push_back(&cap);
  if (clamps.empty()) return {};
  const BuiltCase built = build(data);
  const System system = assemble(built.model);
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
  std::vector<std::string> names;
  for (Cap* clamp : clamps) {
    const double k = rigid_beside(moving), k_turning = rigid_beside(turning);
    clamp->stiffness = Sextuple{k, k, k, k_turning, k_turning, k_turning};
    names.push_back(clamp->name);
  }
  return names;
}

std::vector<std::string> clamps_left_rigid(const Case& data) {
  std::vector<std::string> found;
  for (const Cap& cap : data.caps)
    if (!cap.stiffness && cap.of.size() > 1 && !is_mounted(data, cap.name))
      found.push_back(cap_key(cap.name));
  return found;
}

} // namespace plica
