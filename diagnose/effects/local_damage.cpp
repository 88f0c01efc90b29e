#include "diagnose/effects/places.hpp"

#include <array>
#include <cmath>
#include <fmt/printf.h>
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

void halve_modulus(Model& model, const std::vector<int>& quads) {
  if (quads.empty()) return;
  ShellProperties soft = model.shells[model.mesh.quads[std::size_t(quads.front())].section];
  soft.section.E /= 2;
  const int number = int(model.shells.size());
  model.shells.push_back(soft);
  for (int q : quads) model.mesh.quads[std::size_t(q)].section = number;
}

Hypothesis damage(const std::string& place, const std::string& way, ModelChange halved) {
  return {.effect = "local_damage",
          .place = place,
          .way = way,
          .parameters = {{"loss", "", {PriorKind::uniform, 0, 0.97}}},
          .changes = {std::move(halved)},
          .coefficients = [](const Eigen::VectorXd& v) { return Eigen::VectorXd(2 * v); }};
}

void add_stretches(std::vector<Hypothesis>& found, const Structure& s, const Part& part) {
  const Model& model = s.built.model;
  const auto& beam = std::get<BeamPart>(part.body);
  std::vector<int> own;
  for (std::size_t i = 0; i < model.beams.size(); ++i)
    if (model.components[std::size_t(model.beams[i].component)] == part.name) own.push_back(int(i));
  for (std::size_t k = 0; k + 1 < beam.points.size(); ++k) {
    std::vector<int> stretch;
    for (int e = 0; e < beam.elements; ++e)
      stretch.push_back(own[k * std::size_t(beam.elements) + std::size_t(e)]);
    found.push_back(damage(part.name + ".stretch[" + std::to_string(k + 1) + "]", "",
                           {[stretch](Model& changed) {
                              for (int i : stretch) {
                                BeamProperties& b = changed.beams[std::size_t(i)].section;
                                for (double* n : {&b.EA, &b.EI_y, &b.EI_z, &b.GJ}) *n /= 2;
                              }
                            },
                            Follow::series}));
  }
}

// Young's modulus lost over a quarter of the circumference of a convolution, in eight directions
// from x towards z; in a beam over a stretch between two of its points.
std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  constexpr int directions = 8; // of half a turn: the other half answers alike
  for (const WallElements& wall : walls(s))
    for (int k : stations_of(wall.convolutions))
      for (int i = 0; i < directions; ++i) {
        const double angle = std::numbers::pi * i / directions;
        const std::string way = fmt::sprintf("%g degrees", 180. * i / directions);
        found.push_back(damage(wall.part + ".convolution[" + std::to_string(k) + "]", way,
                               {[quads = damaged(s.built.model, wall, k, angle)](Model& model) {
                                  halve_modulus(model, quads);
                                },
                                Follow::series}));
      }
  for (const Part& part : s.data.parts)
    if (std::holds_alternative<BeamPart>(part.body)) add_stretches(found, s, part);
  return found;
}

} // namespace

Effect local_damage() {
  return {.name = "local_damage",
          .plain = "a spot that has lost {loss%} of its stiffness: a dent, a crack, a loose lap",
          .physics = "a dent or crack takes stiffness from one side of one place",
          .signature = "x and z differ, a motion along one shows along the other",
          .look_alikes = {"rotated_sensor: turn the sensor",
                          "cross_axis_base_motion: an accelerometer on the table",
                          "joint_stiffness: turn the specimen by 90 degrees"},
          .needs = "a bellows or a beam",
          .hypotheses = hypotheses};
}

} // namespace plica
