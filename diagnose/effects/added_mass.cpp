#include "diagnose/effects/beam_path.hpp"
#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

ModelChange on_each(const std::vector<int>& nodes) {
  return {.apply = [nodes](Model& model) {
    for (int node : nodes) add_point_mass(model, node, 1 / double(nodes.size()));
  }};
}

constexpr double most = 0.2; // of the part: what nobody would miss on seeing it is less

// A mass all round a crown turns with it; one that is clamped softly does not.
std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const EffectParameter mass{
      "mass", "kg", {PriorKind::log_normal, 0.03 * s.mass, 1, 0, most * s.mass}};
  const auto add = [&](const Spot& spot, const char* way, ModelChange one_kilogram) {
    found.push_back({.effect = "added_mass",
                     .place = spot.place,
                     .way = way,
                     .parameters = {mass},
                     .changes = {std::move(one_kilogram)},
                     .coefficients = [](const Eigen::VectorXd& v) { return v; },
                     .at_rig = false});
  };
  for (const Spot& spot : spots(s)) {
    if (is_along(s, spot)) continue;
    add(spot, "", on_each({spot.touched}));
    if (spot.nodes.size() < 2) continue;
    add(spot, "all round", on_each(spot.nodes));
    add(spot, "on the mean motion", {.apply = {}, .on_motion = {on_mean_motion(spot.nodes, 1, 0)}});
  }
  for (const BeamPath& path : beam_paths(s)) {
    found.push_back(anywhere_along(path, mass, mass_along(s, path)));
    found.back().effect = "added_mass";
  }
  return found;
}

} // namespace

Effect added_mass() {
  return {.name = "added_mass",
          .plain = "{mass} that nobody weighed",
          .physics = "a mass at a spot that the scale did not see: a sensor, a clamp, a deposit",
          .signature = "modes that move the spot fall, mass and static stiffness stay",
          .look_alikes = {"component_mass: weigh the part",
                          "unweighed_mass: a second sensor of the same mass",
                          "boundary_compliance: the antinodes of further modes"},
          .needs = "a sensor, bellows, pipe, chain or beam",
          .hypotheses = hypotheses};
}

} // namespace plica
