#include "diagnose/effects/places.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

// Mass and springs to the table, in rotation as stiff as springs at a quarter of the length.
std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const double arm = s.length / 4;
  for (const HeldEnds& ends : held_ends(s)) {
    const ModelChange masses{[nodes = ends.nodes, arm](Model& model) {
                               for (int node : nodes) {
                                 add_point_mass(model, node, 1);
                                 model.masses.back().body.inertia.diagonal().setConstant(arm * arm);
                               }
                             },
                             Follow::series};
    found.push_back(
        {.effect = "fixture_flexibility",
         .place = ends.place,
         .way = "",
         .parameters = {{"mass", "kg", {PriorKind::log_normal, 2 * s.mass, 1}},
                        {"frequency", "Hz", {PriorKind::log_normal, 1.5 * s.frequency, 0.5}}},
         .changes = {ground_springs(ends.nodes, 1, arm * arm), masses},
         .coefficients =
             [](const Eigen::VectorXd& v) {
               const double omega = 2 * std::numbers::pi * v[1];
               return Eigen::VectorXd(Eigen::Vector2d(v[0] * omega * omega, v[0]));
             },
         .at_rig = false,
         .released = ends.caps});
  }
  return found;
}

} // namespace

Effect fixture_flexibility() {
  return {.name = "fixture_flexibility",
          .physics = "a held end stands on a fixture with mass and a resonance of its own",
          .signature = "the lowest modes fall, a further resonance appears, the held end moves",
          .look_alikes = {"boundary_compliance: an accelerometer on the fixture",
                          "added_mass: a response of the fixture alone"},
          .hypotheses = hypotheses};
}

} // namespace plica
