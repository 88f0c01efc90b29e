#include "diagnose/effects/beam_path.hpp"
#include "diagnose/effects/places.hpp"
#include "diagnose/effects/plate_places.hpp"
#include "diagnose/effects/spots.hpp"
#include "model/description/place_keys.hpp"
#include "words/directions.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace plica {
namespace {

// Something that touches at one node along one axis, or holds a circle all round.
ModelChange on_each(const std::vector<int>& nodes, const Eigen::Vector3d& along) {
  return {.apply = [nodes, k = Eigen::Vector3d(along / double(nodes.size()))](Model& model) {
    for (int node : nodes) add_ground_spring(model, node, {k[0], k[1], k[2], 0, 0, 0});
  }};
}

// In its own plane a plate is far too stiff for a spring to be felt.
ModelChange along_normal(const Spot& spot) {
  Eigen::MatrixXd row = Eigen::MatrixXd::Zero(1, 6);
  row.leftCols<3>() = spot.normal->transpose();
  return {.apply = {}, .on_motion = {{.nodes = {spot.touched}, .rows = row, .stiffness = 1}}};
}

// Whether what holds along all axes shows otherwise than what holds along one.
bool sees_two_directions(const Measured& m) {
  std::set<Axis> seen;
  for (const MeasuredMode& mode : m.modes)
    if (mode.base || mode.direction) seen.insert(mode.base ? *mode.base : *mode.direction);
  for (const MeasuredPeaks& p : m.peaks) seen.insert(p.base);
  for (const MeasuredFrf& f : m.frf) {
    if (f.base) seen.insert(*f.base);
    if (!f.force.empty() && is_translation(f.force))
      seen.insert(static_cast<Axis>(axis_of_channel(f.force)));
  }
  return seen.size() > 1;
}

// Across a path that is straight enough: the two axes along which it reaches least.
std::array<int, 2> across(const Structure& s, const BeamPath& path) {
  const Mesh& mesh = s.built.model.mesh;
  const Eigen::Vector3d chord =
      mesh.nodes[std::size_t(path.nodes.back())] - mesh.nodes[std::size_t(path.nodes.front())];
  int along = 0;
  chord.cwiseAbs().maxCoeff(&along);
  return {along == 0 ? 1 : 0, along == 2 ? 1 : 2};
}

// Springs of two stiffnesses at one place, the second so many times the first.
Hypothesis of_two_stiffnesses(const std::string& part, const EffectParameter& k,
                              const std::vector<EffectParameter>& place, MovingMotion first,
                              MovingMotion second) {
  const auto own = Eigen::Index(first.terms.size());
  Hypothesis h = anywhere(part, k, place, {std::move(first), std::move(second)});
  h.parameters.push_back({"ratio", "", {PriorKind::log_normal, 1, 1.2}});
  h.coefficients = [alike = h.coefficients, own](const Eigen::VectorXd& v) {
    Eigen::VectorXd all = alike(v.head(v.size() - 1));
    all.tail(all.size() - own) *= std::sqrt(v[v.size() - 1]);
    return all;
  };
  return h;
}

// A support all round a crown holds its turning too; one that touches softly does not. From a touch
// to a pin: at three deviations it is some thousand times as stiff as the part.
std::vector<Hypothesis> at_spots(const Structure& s) {
  std::vector<Hypothesis> found;
  const auto add = [&](const Spot& spot, const char* way, ModelChange unit) {
    found.push_back({.effect = {},
                     .place = spot.place,
                     .way = way,
                     .parameters = {{"k", "N/m", {PriorKind::log_normal, s.stiffness, 2.5}}},
                     .changes = {std::move(unit)},
                     .coefficients = [](const Eigen::VectorXd& v) { return v; },
                     .at_rig = false,
                     .between = spot.between,
                     .free_numbers = spot.free_numbers,
                     .weight = spot.weight});
  };
  for (const Spot& spot : contact_spots(s)) {
    if (is_at_sensor(spot.place) || is_anywhere(s, spot)) continue;
    if (spot.normal) {
      add(spot, "along the normal", along_normal(spot));
      continue;
    }
    add(spot, "x", on_each({spot.touched}, Eigen::Vector3d::UnitX()));
    add(spot, "y", on_each({spot.touched}, Eigen::Vector3d::UnitY()));
    add(spot, "z", on_each({spot.touched}, Eigen::Vector3d::UnitZ()));
    add(spot, "all round", on_each(spot.nodes, Eigen::Vector3d::Ones()));
    if (spot.nodes.size() > 1)
      add(spot, "on the mean motion",
          {.apply = {}, .on_motion = {on_mean_motion(spot.nodes, 0, 1)}});
  }
  return found;
}

// Anywhere on a plate along its normal, anywhere on a line along each axis and along several.
std::vector<Hypothesis> on_plates_and_lines(const Structure& s) {
  // From a touch, thousandths of the part's own stiffness, to a pin: beyond a hundred times that
  // the readings do not feel how stiff. Every power of ten alike, half of them pins.
  const double own = s.stiffness;
  const EffectParameter k{
      "k", "N/m", {PriorKind::log_normal, 100 * own, 20, 0.003 * own, 3e6 * own}};
  std::vector<Hypothesis> found;
  const auto add = [&](std::string way, Hypothesis h) {
    h.way = std::move(way);
    found.push_back(std::move(h));
  };
  for (const PlateGrid& grid : plate_grids(s))
    add("along the normal", anywhere(grid.part, k, grid.place(),
                                     {motion_on(s, grid, std::nullopt, MotionTerm::Of::spring)}));
  for (const BeamPath& path : line_paths(s)) {
    const auto motion = [&](int axis) {
      return motion_along(s, path, Eigen::Vector3d::Unit(axis), MotionTerm::Of::spring);
    };
    const auto along = [&](std::vector<MovingMotion> motions) {
      return anywhere(path.part, k, path.place(), std::move(motions));
    };
    add("x", along({motion(0)}));
    add("y", along({motion(1)}));
    add("z", along({motion(2)}));
    if (!sees_two_directions(s.measured)) continue;
    add("all round", along({motion(0), motion(1), motion(2)}));
    const auto [first, second] = across(s, path);
    add(fmt::format("{} and {}", axis_word(first), axis_word(second)),
        of_two_stiffnesses(path.part, k, path.place(), motion(first), motion(second)));
  }
  return found;
}

std::vector<Hypothesis> extra_support_hypotheses(const Structure& s) {
  std::vector<Hypothesis> all = at_spots(s);
  for (Hypothesis& h : on_plates_and_lines(s)) all.push_back(std::move(h));
  for (Hypothesis& h : all) h.effect = "extra_support";
  return all;
}

} // namespace

Effect extra_support() {
  return {.name = "extra_support",
          .plain = "something that touches the structure and is not drawn, as a spring of {k}",
          .physics = "something touches the structure between its held ends",
          .signature = "modes that move the spot rise, the others and the static stiffness stay",
          .look_alikes = {{"joint_stiffness", "other modes"},
                          {"component_mass", "weigh the part", true}},
          .needs = "a bellows, pipe, chain, plate, surface, deck or beam",
          .hypotheses = extra_support_hypotheses};
}

} // namespace plica
