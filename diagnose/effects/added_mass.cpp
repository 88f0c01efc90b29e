#include "diagnose/effects/added_mass.hpp"

#include "diagnose/effects/beam_path.hpp"
#include "diagnose/effects/places.hpp"
#include "diagnose/effects/plate_places.hpp"
#include "diagnose/effects/spots.hpp"
#include "lab/measured/states.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>

namespace plica {
namespace {

ModelChange on_each(const std::vector<int>& nodes) {
  return {.apply = [nodes](Model& model) {
    for (int node : nodes) add_point_mass(model, node, 1 / double(nodes.size()));
  }};
}

Triple place_of(const Structure& s, int node) {
  const Eigen::Vector3d& x = s.built.model.mesh.nodes[std::size_t(node)];
  return {x[0], x[1], x[2]};
}

std::vector<Triple> places_of(const Structure& s, const std::vector<int>& nodes) {
  std::vector<Triple> all;
  for (int node : nodes) all.push_back(place_of(s, node));
  return all;
}

// A mass all round a crown turns with it; one that is clamped softly does not. Beside a baseline it
// is what came since, and what was weighed afterwards was weighed with it.
std::vector<Hypothesis> added_mass_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const bool on_scale = has_baseline(s.measured);
  const EffectParameter mass = added_kilograms(s);
  const auto add = [&](const Spot& spot, const char* way, ModelChange one_kilogram) {
    found.push_back({.effect = "added_mass",
                     .place = spot.place,
                     .way = way,
                     .parameters = {mass},
                     .changes = {std::move(one_kilogram)},
                     .coefficients = [](const Eigen::VectorXd& v) { return v; },
                     .at_rig = on_scale,
                     .between = spot.between,
                     .free_numbers = spot.free_numbers,
                     .weight = spot.weight});
  };
  const auto add_at_point = [&](const Spot& spot) {
    add(spot, "", on_each({spot.touched}));
    found.back().in_case = [at = place_of(s, spot.touched),
                            name = spot.place](const Case& now, const Eigen::VectorXd& v) {
      for (std::size_t i = 0; i < now.sensors.size(); ++i)
        if (name == sensor_place(now.sensors[i].name))
          return CaseEdits{
              {"sensors[" + std::to_string(i) + "].mass", yaml_of(now.sensors[i].mass + v[0])}};
      return with_mass_at(now, at, v[0]);
    };
  };
  for (const Spot& spot : contact_spots(s)) {
    if (is_anywhere(s, spot)) continue;
    if (!is_told_of_sensor(s, spot)) add_at_point(spot);
    if (spot.nodes.size() < 2) continue;
    add(spot, "all round", on_each(spot.nodes));
    add(spot, "on the mean motion", {.apply = {}, .on_motion = {on_mean_motion(spot.nodes, 1, 0)}});
  }
  const auto add_anywhere = [&](const std::string& part, const std::vector<EffectParameter>& place,
                                const auto& motion,
                                std::function<Triple(const Eigen::VectorXd&)> at) {
    std::vector<MovingMotion> motions;
    for (int axis = 0; axis < 3; ++axis) motions.push_back(motion(Eigen::Vector3d::Unit(axis)));
    found.push_back(anywhere(part, mass, place, std::move(motions)));
    found.back().effect = "added_mass";
    found.back().at_rig = on_scale;
    found.back().in_case = [at = std::move(at)](const Case& now, const Eigen::VectorXd& v) {
      return with_mass_at(now, at(v), v[0]);
    };
  };
  for (const BeamPath& path : line_paths(s))
    add_anywhere(
        path.part, path.place(),
        [&](const Eigen::Vector3d& d) { return motion_along(s, path, d, MotionTerm::Of::mass); },
        [path, all = places_of(s, path.nodes)](const Eigen::VectorXd& v) {
          return all[nearest_of(path.at, v[1])];
        });
  for (const PlateGrid& grid : plate_grids(s))
    add_anywhere(
        grid.part, grid.place(),
        [&](const Eigen::Vector3d& d) { return motion_on(s, grid, d, MotionTerm::Of::mass); },
        [grid](const Eigen::VectorXd& v) { return grid.point(v[1], v[2]); });
  return found;
}

} // namespace

EffectParameter added_kilograms(const Structure& s) {
  constexpr double largest_share = 0.2; // of the part: what nobody would miss on seeing it is less
  return {"mass", "kg", {PriorKind::log_normal, 0.03 * s.mass, 1, 0, largest_share * s.mass}};
}

Effect added_mass() {
  return {
      .name = "added_mass",
      .plain = "{mass} that nobody weighed",
      .physics = "a mass at a spot that the scale did not see, or that came after the baseline: a "
                 "sensor, a clamp, a deposit",
      .signature = "modes that move the spot fall, static stiffness stays; the mass grows where "
                   "a baseline was weighed",
      .look_alikes = {{"local_damage", "weigh the part", true},
                      {"component_mass", "weigh the part", true},
                      {"unweighed_mass", "a second sensor of the same mass"},
                      {"boundary_compliance", "the antinodes of further modes"}},
      .needs = "a sensor, bellows, pipe, chain, plate, surface, deck or beam",
      .hypotheses = added_mass_hypotheses};
}

} // namespace plica
