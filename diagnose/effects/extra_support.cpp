#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

// Something that touches at one node, along one axis or all three.
std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const Spot& spot : spots(s)) {
    if (spot.place.starts_with("sensor.")) continue;
    for (const auto& [way, x, y, z] :
         {std::tuple{"x", 1., 0., 0.}, {"y", 0., 1., 0.}, {"z", 0., 0., 1.}, {"", 1., 1., 1.}})
      found.push_back(
          {.effect = "extra_support",
           .place = spot.place,
           .way = way,
           .parameters = {{"k", "N/m", {PriorKind::log_normal, 0.3 * s.stiffness, 1.2}}},
           .changes = {{[node = spot.touched, x, y, z](Model& model) {
                          add_ground_spring(model, node, {x, y, z, 0, 0, 0});
                        },
                        Follow::series}},
           .coefficients = [](const Eigen::VectorXd& v) { return v; },
           .at_rig = false});
  }
  return found;
}

} // namespace

Effect extra_support() {
  return {.name = "extra_support",
          .physics = "something touches the structure between its held ends",
          .signature = "modes that move the spot rise, the others and the static stiffness stay",
          .look_alikes = {"joint_stiffness: other modes", "component_mass: weigh the part"},
          .hypotheses = hypotheses};
}

} // namespace plica
