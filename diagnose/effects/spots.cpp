#include "diagnose/effects/places.hpp"

namespace plica {

// Something that touches at one node, along one axis or all three.
std::vector<Hypothesis> extra_support(const Structure& s) {
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

std::vector<Hypothesis> added_mass(const Structure& s) {
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

} // namespace plica
