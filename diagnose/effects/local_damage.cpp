#include "diagnose/effects/beam_path.hpp"
#include "diagnose/effects/places.hpp"
#include "diagnose/effects/wall_damage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace plica {
namespace {

constexpr double sector = std::numbers::pi / 4; // half of what is damaged

// Quads of a convolution within the sector round an angle from x towards z, on one side.
std::vector<int> damaged(const Model& model, const WallElements& wall, int convolution,
                         double angle) {
  std::vector<int> quads;
  for (std::size_t i = 0; i < wall.quads.size(); ++i) {
    if (wall.convolution[i] != convolution) continue;
    const Eigen::Vector3d centre = quad_centre(model, wall.quads[i]);
    const double away =
        std::remainder(std::atan2(centre.z(), centre.x()) - angle, 2 * std::numbers::pi);
    if (std::abs(away) < sector) quads.push_back(wall.quads[i]);
  }
  return quads;
}

Hypothesis damage(const std::string& place, const std::string& way, ModelChange halved) {
  return {.effect = "local_damage",
          .place = place,
          .way = way,
          .parameters = {{"loss", "", {PriorKind::uniform, 0, 0.97}}},
          .changes = {std::move(halved)},
          .coefficients = [](const Eigen::VectorXd& v) { return Eigen::VectorXd(2 * v); }};
}

// What a beam loses: a crack takes from bending, a bracing that is gone or a core that comes off
// from shear.
enum class Lost { bending, shear };

const char* way_of(Lost what) {
  return what == Lost::shear ? "shear" : "";
}

// Elements of beams with half of their stiffness.
ModelChange halved(const std::vector<int>& elements, Lost what) {
  return {[elements, what](Model& changed) {
            for (int i : elements) {
              BeamProperties& b = changed.beams[std::size_t(i)].section;
              if (what == Lost::shear)
                for (double* n : {&b.GA_y, &b.GA_z}) *n /= 2;
              else
                for (double* n : {&b.EA, &b.EI_y, &b.EI_z, &b.GJ}) *n /= 2;
            }
          },
          Follow::series};
}

std::vector<int> elements_of(const Model& model, const std::string& part) {
  std::vector<int> own;
  for (std::size_t i = 0; i < model.beams.size(); ++i)
    if (model.components[std::size_t(model.beams[i].component)] == part) own.push_back(int(i));
  return own;
}

double length_of(const Model& model, const BeamElement& b) {
  const auto& x = model.mesh.nodes;
  return (x[std::size_t(b.node2)] - x[std::size_t(b.node1)]).norm();
}

// Bending, and shear where it gives way beside bending over the length of the part, as it does in a
// lattice or a sandwich: else no frequency shows it.
std::vector<Lost> losses(const Model& model, const std::vector<int>& own) {
  double length = 0, shear = 0; // of a beam held at both ends: 12 EI / (GA L^2)
  for (int i : own) length += length_of(model, model.beams[std::size_t(i)]);
  for (int i : own) {
    const BeamProperties& b = model.beams[std::size_t(i)].section;
    const double worst = std::max(b.EI_y / b.GA_z, b.EI_z / b.GA_y);
    shear = std::max(shear, 12 * worst / (length * length));
  }
  constexpr double felt = 0.05;
  if (shear < felt) return {Lost::bending};
  return {Lost::bending, Lost::shear};
}

// A part of one stretch that gives way in bending is softer as a whole; in shear that is no spot.
void add_stretches(std::vector<Hypothesis>& found, const Structure& s, const Part& part,
                   Lost what) {
  const auto& beam = std::get<BeamPart>(part.body);
  if (what == Lost::shear && beam.points.size() == 2) return;
  const Model& model = s.built.model;
  const std::vector<int> own = elements_of(model, part.name);
  auto first = own.begin();
  for (std::size_t k = 1; k < beam.points.size(); ++k) {
    const int end = model.mesh.sets.at(part.name + ".point[" + std::to_string(k + 1) + "]").front();
    auto last = std::find_if(first, own.end(),
                             [&](int i) { return model.beams[std::size_t(i)].node2 == end; });
    if (last != own.end()) ++last;
    found.push_back(damage(part.name + ".stretch[" + std::to_string(k) + "]", way_of(what),
                           halved({first, last}, what)));
    first = last;
  }
}

// What each interval of a path has lost where `loss` is lost from `from` to `to`. Compliances of
// what is whole and what is not add up within an interval.
Eigen::VectorXd lost(const BeamPath& path, double loss, double from, double to) {
  Eigen::VectorXd each(Eigen::Index(path.at.size()) - 1);
  for (std::size_t i = 0; i + 1 < path.at.size(); ++i) {
    const double within = std::min(to, path.at[i + 1]) - std::max(from, path.at[i]);
    const double share = std::max(0., within) / (path.at[i + 1] - path.at[i]);
    each[Eigen::Index(i)] = 1 - 1 / (1 + share * loss / (1 - loss));
  }
  return each;
}

// Anywhere along a beam, over a length that is not known either: its points say nothing of where it
// was damaged. What is local is short.
void add_anywhere(std::vector<Hypothesis>& found, const Structure& s, const BeamPath& path,
                  Lost what) {
  std::vector<std::vector<int>> elements(path.at.size() - 1);
  double at = 0;
  for (int i : elements_of(s.built.model, path.part)) {
    const double length = length_of(s.built.model, s.built.model.beams[std::size_t(i)]);
    const auto next = std::upper_bound(path.at.begin() + 1, path.at.end() - 1, at + length / 2);
    elements[std::size_t(next - path.at.begin() - 1)].push_back(i);
    at += length;
  }
  std::vector<ModelChange> changes;
  for (const std::vector<int>& own : elements) changes.push_back(halved(own, what));
  constexpr double usual = 0.1, longest = 0.5; // of the beam
  found.push_back({.effect = "local_damage",
                   .place = path.part,
                   .way = way_of(what),
                   .parameters = {{"loss", "", {PriorKind::uniform, 0, 0.97}},
                                  {"at", "m", {PriorKind::uniform, 0, path.length()}},
                                  {"length",
                                   "m",
                                   {PriorKind::log_normal, usual * path.length(), 1, 0,
                                    longest * path.length()}}},
                   .changes = std::move(changes),
                   .coefficients =
                       [path](const Eigen::VectorXd& v) {
                         return Eigen::VectorXd(2 *
                                                lost(path, v[0], v[1] - v[2] / 2, v[1] + v[2] / 2));
                       },
                   .along = {1}});
}

// Young's modulus lost over a quarter of the circumference of a convolution, in eight directions
// from x towards z; of a plate, a surface or a deck about a spot; in a beam over a stretch between
// two of its points, or anywhere along, in bending or in shear.
std::vector<Hypothesis> local_damage_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  constexpr int directions = 8; // of half a turn: the other half answers alike
  for (const WallElements& wall : walls(s))
    for (const ConvolutionPlace& c : convolution_places(wall.part, wall.convolutions))
      for (int i = 0; i < directions; ++i) {
        const double angle = std::numbers::pi * i / directions;
        const std::string way = fmt::format("{:g} degrees", 180. * i / directions);
        found.push_back(damage(c.place, way,
                               {[quads = damaged(s.built.model, wall, c.number, angle)](Model& m) {
                                  halve_modulus(m, {.quads = quads});
                                },
                                Follow::series}));
        found.back().between = c.between;
      }
  for (const Part& part : s.data.parts)
    for (DamagedSpot& at : damaged_spots(s, part)) {
      found.push_back(damage(at.spot.place, at.way, std::move(at.halved)));
      found.back().between = at.spot.between;
      found.back().free_numbers = at.spot.free_numbers;
      found.back().weight = at.spot.weight;
    }
  for (const Part& part : s.data.parts)
    if (std::holds_alternative<BeamPart>(part.body))
      for (Lost what : losses(s.built.model, elements_of(s.built.model, part.name)))
        add_stretches(found, s, part, what);
  for (const BeamPath& path : beam_paths(s))
    for (Lost what : losses(s.built.model, elements_of(s.built.model, path.part)))
      add_anywhere(found, s, path, what);
  return found;
}

} // namespace

Effect local_damage() {
  return {.name = "local_damage",
          .plain = "a spot that has lost {loss%} of its stiffness: a dent, a crack, a loose lap",
          .physics = "a dent or crack takes stiffness from one side of one place",
          .signature = "x and z differ, a motion along one shows along the other",
          .look_alikes = {{"added_mass", "weigh the part", true},
                          {"rotated_sensor", "turn the sensor"},
                          {"cross_axis_base_motion", "an accelerometer on the table"},
                          {"joint_stiffness", "turn the specimen by 90 degrees"}},
          .needs = "a bellows, plate, surface, deck or beam",
          .hypotheses = local_damage_hypotheses};
}

} // namespace plica
