#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const auto add = [&](const Spot& spot, const std::vector<int>& nodes, const char* way) {
    found.push_back({.effect = "added_mass",
                     .place = spot.place,
                     .way = way,
                     .parameters = {{"mass", "kg", {PriorKind::log_normal, 0.03 * s.mass, 1}}},
                     .changes = {{[nodes](Model& model) {
                                    for (int node : nodes)
                                      add_point_mass(model, node, 1 / double(nodes.size()));
                                  },
                                  Follow::series}},
                     .coefficients = [](const Eigen::VectorXd& v) { return v; },
                     .at_rig = false});
  };
  for (const Spot& spot : spots(s)) {
    add(spot, {spot.touched}, "");
    if (spot.nodes.size() > 1) add(spot, spot.nodes, "all round");
  }
  return found;
}

} // namespace

Effect added_mass() {
  return {.name = "added_mass",
          .physics = "a mass at a spot that the scale did not see: a sensor, a clamp, a deposit",
          .signature = "modes that move the spot fall, mass and static stiffness stay",
          .look_alikes = {"component_mass: weigh the part",
                          "unweighed_mass: a second sensor of the same mass",
                          "boundary_compliance: the antinodes of further modes"},
          .hypotheses = hypotheses};
}

} // namespace plica
