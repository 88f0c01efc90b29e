#include "run/routes/state_bolts.hpp"

#include "solve/state_elements.hpp"

#include <algorithm>

namespace plica {
namespace {

BeamElement& middle_of(const std::string& part, Model& model) {
  const auto& names = model.components;
  const int component = int(std::find(names.begin(), names.end(), part) - names.begin());
  std::vector<BeamElement*> elements;
  for (BeamElement& b : model.beams)
    if (b.component == component) elements.push_back(&b);
  return *elements.at(elements.size() / 2);
}

} // namespace

void tighten_bolts(const std::vector<BoltForce>& bolts, BuiltCase& built) {
  for (const BoltForce& bolt : bolts)
    middle_of(bolt.part, built.model).section.tightened = bolt.force;
}

void settle_bolts(const std::vector<BoltForce>& bolts, BuiltCase& built, StateResult& result) {
  for (const BoltForce& bolt : bolts) {
    BeamElement& b = middle_of(bolt.part, built.model);
    BeamProperties& section = b.section;
    const double free = axial_strain(built.model, b) - bolt.force / section.EA;
    const BeamGeometry rest = beam_at_rest(built.model, b);
    const double length = (rest.node2 + rest.offset2 - rest.node1 - rest.offset1).norm();
    result.bolts.push_back({.part = bolt.part,
                            .force = bolt.force,
                            .shortened = (section.thermal_strain - free) * length});
    section.thermal_strain = free;
    section.tightened.reset();
  }
}

} // namespace plica
