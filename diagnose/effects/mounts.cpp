#include "diagnose/effects/places.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

// Each held end, and all of them alike.
struct HeldEnds {
  std::string place;
  std::vector<std::string> caps;
  std::vector<int> nodes;
};

std::vector<HeldEnds> held_ends(const Structure& s) {
  std::vector<HeldEnds> found;
  HeldEnds all{.place = "mount", .caps = {}, .nodes = {}};
  for (const std::string& cap : held_caps(s)) {
    found.push_back({"mount." + cap, {cap}, {cap_node(s, cap)}});
    all.caps.push_back(cap);
    all.nodes.push_back(cap_node(s, cap));
  }
  if (all.caps.size() > 1) found.push_back(std::move(all));
  return found;
}

ModelChange springs(const std::vector<int>& nodes, double translation, double rotation) {
  return {[nodes, translation, rotation](Model& model) {
            for (int node : nodes)
              add_ground_spring(
                  model, node,
                  {translation, translation, translation, rotation, rotation, rotation});
          },
          Follow::series};
}

} // namespace

std::vector<Hypothesis> boundary_compliance(const Structure& s) {
  std::vector<Hypothesis> found;
  const double arm = s.length / 4, k = 10 * s.stiffness;
  for (const HeldEnds& ends : held_ends(s))
    found.push_back(
        {.effect = "boundary_compliance",
         .place = ends.place,
         .way = "",
         .parameters = {{"k_translation", "N/m", {PriorKind::log_normal, k, 1.5}},
                        {"k_rotation", "Nm/rad", {PriorKind::log_normal, k * arm * arm, 1.5}}},
         .changes = {springs(ends.nodes, 1, 0), springs(ends.nodes, 0, 1)},
         .coefficients = [](const Eigen::VectorXd& v) { return v; },
         .at_rig = false,
         .released = ends.caps});
  return found;
}

// Mass and springs to the table, in rotation as stiff as springs at a quarter of the length.
std::vector<Hypothesis> fixture_flexibility(const Structure& s) {
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
         .changes = {springs(ends.nodes, 1, arm * arm), masses},
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

} // namespace plica
