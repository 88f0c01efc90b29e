#include "model/shape/symbols.hpp"

#include "model/description/deck_model.hpp"
#include "model/description/place_keys.hpp"
#include "model/shape/built_case.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

class Symbols {
public:
  Symbols(const Case& data, const BuiltCase& built) : data_(data), built_(built) {}

  std::vector<Symbol> all() {
    for (const Part& part : data_.parts) {
      if (const auto* mass = std::get_if<PointMass>(&part.body))
        add_mass(part.name, built_.mass_nodes.at(part.name), mass->mass);
      if (std::holds_alternative<ConnectorChain>(part.body))
        list_.push_back({SymbolKind::spring, part.name, end(part, ".left"), end(part, ".right")});
      if (const auto* deck = std::get_if<DeckPart>(&part.body))
        add_deck(part, deck->content->masses.size());
    }
    for (const Cap& cap : data_.caps) {
      add_mass(cap.name, built_.cap_nodes.at(cap.name), cap.mass);
      if (cap.stiffness) add_springs(cap_key(cap.name), cap.name);
      for (const SprungEnd& e : cap.ends) add_springs(sprung_end_key(cap.name, e.end), cap.name);
    }
    for (const Mount& mount : data_.mount) {
      const int node = built_.cap_nodes.at(mount.cap);
      if (mount.kind == MountKind::rigid)
        list_.push_back({SymbolKind::held, mount.cap, node});
      else if (mount.kind == MountKind::springs)
        list_.push_back({SymbolKind::ground_spring, mount.cap, node});
    }
    return std::move(list_);
  }

private:
  int end(const Part& part, const char* side) const {
    return built_.model.mesh.sets.at(part.name + side).front();
  }

  void add_mass(const std::string& name, int node, double mass) {
    if (mass > 0) list_.push_back({SymbolKind::mass, name, node, -1, mass});
  }

  void add_springs(const std::string& component, const std::string& name) {
    for (const BushingElement& b : built_.model.bushings)
      if (built_.model.components[std::size_t(b.component)] == component)
        list_.push_back(
            {b.node2 < 0 ? SymbolKind::ground_spring : SymbolKind::spring, name, b.node1, b.node2});
  }

  // Unless they are so many that they would hide the part.
  void add_deck(const Part& part, std::size_t masses) {
    constexpr std::size_t most = 40;
    const std::size_t before = list_.size();
    const std::vector<int>& own = built_.model.mesh.sets.at(part.name + ".all");
    const std::set<int> nodes(own.begin(), own.end());
    std::size_t drawn = 0; // the masses of the deck come before those of its elements
    for (const MassElement& m : built_.model.masses)
      if (nodes.contains(m.node) && drawn++ < masses) add_mass("", m.node, m.body.mass);
    add_springs(part.name, "");
    if (list_.size() > before + most) list_.resize(before);
  }

  const Case& data_;
  const BuiltCase& built_;
  std::vector<Symbol> list_;
};

} // namespace

std::vector<Symbol> symbols_of(const Case& data, const BuiltCase& built) {
  return Symbols(data, built).all();
}

std::vector<double> drawn_radii(const BuiltCase& built) {
  std::vector<double> radii;
  for (const BeamElement& b : built.model.beams) {
    double radius = 0;
    for (const auto& [y, z] : b.section.fibres) radius = std::max(radius, std::hypot(y, z));
    if (radius == 0 && b.section.EA > 0)
      radius = std::sqrt((b.section.EI_y + b.section.EI_z) / b.section.EA);
    radii.push_back(std::isfinite(radius) ? radius : 0);
  }
  return radii;
}

} // namespace plica
