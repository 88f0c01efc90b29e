#include "diagnose/effects/places.hpp"
#include "lab/measured/states.hpp"
#include "model/description/place_keys.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

// Of a fixture that rocks: its mass, and how far it spreads, as its radius of gyration over that of
// a cube of steel of its mass. No body of steel spreads less than a ball.
constexpr double ball_over_cube = 0.96;

double inertia_of(double mass, double spread) {
  constexpr double steel = 7850, gyration_of_cube = 0.408; // kg/m3, radius over edge
  const double gyration = spread * gyration_of_cube * std::cbrt(mass / steel);
  return mass * gyration * gyration;
}

// Caps that were held rigidly, with the mass of the fixture, on its springs.
CaseEdits on_fixtures(const Case& now, const std::string& place, const Eigen::VectorXd& v) {
  const double mass = v[0], inertia = inertia_of(v[0], v[3]), omega = 2 * std::numbers::pi * v[1];
  const double k = mass * omega * omega, turning = inertia * std::pow(omega * v[2], 2);
  CaseEdits edits;
  for (const Mount& m : mounts_at(now, place)) {
    const Cap& cap = *cap_named(now, m.cap);
    if (m.kind != MountKind::rigid || cap.offset != Triple{}) return {};
    Sextuple own = cap.inertia;
    for (std::size_t i = 0; i < 3; ++i) own[i] += inertia;
    edits.push_back(
        {mount_key(m.cap), "{stiffness: " + yaml_of({k, k, k, turning, turning, turning}) + "}"});
    edits.push_back({cap_key(m.cap) + ".mass", yaml_of(cap.mass + mass)});
    edits.push_back({cap_key(m.cap) + ".inertia", yaml_of(own)});
  }
  return edits;
}

// Mass and springs to the table. It rocks at `rocking` times the frequency at which it moves
// straight. A fixture was there before: what comes loose under it is a compliance of the boundary,
// and beside a baseline a further mass on springs would be an absorber for whatever has changed.
std::vector<Hypothesis> fixture_flexibility_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  if (has_baseline(s.measured) && !asked_for(s, "fixture_flexibility")) return found;
  const double mass = 2 * s.mass;
  for (const HeldEnds& ends : held_ends(s)) {
    const auto bodies = [nodes = ends.nodes](double kg, double inertia) {
      return ModelChange{[nodes, kg, inertia](Model& model) {
                           for (int node : nodes) {
                             add_point_mass(model, node, kg);
                             model.masses.back().body.inertia.diagonal().setConstant(inertia);
                           }
                         },
                         Follow::series};
    };
    std::vector<int> released = ends.nodes;
    released.insert(released.end(), ends.fixtures.begin(), ends.fixtures.end());
    found.push_back(
        {.effect = "fixture_flexibility",
         .place = ends.place,
         .way = "",
         .parameters = {{"mass", "kg", {PriorKind::log_normal, mass, 1}},
                        {"frequency", "Hz", {PriorKind::log_normal, 1.5 * s.frequency, 0.8}},
                        {"rocking", "", {PriorKind::log_normal, 1.5, 0.4}},
                        {"spread", "", {PriorKind::log_normal, 1.3, 0.35, ball_over_cube}}},
         .size = 1,
         .changes = {ground_springs(ends.nodes, 1, 0), bodies(1, 0),
                     ground_springs(ends.nodes, 0, 1), bodies(0, 1)},
         .coefficients =
             [](const Eigen::VectorXd& v) {
               const double omega = 2 * std::numbers::pi * v[1], inertia = inertia_of(v[0], v[3]);
               return Eigen::VectorXd(Eigen::Vector4d(
                   v[0] * omega * omega, v[0], inertia * std::pow(omega * v[2], 2), inertia));
             },
         .at_rig = false,
         .released = std::move(released),
         .resonates = true,
         .in_case =
             [place = ends.place](const Case& now, const Eigen::VectorXd& v) {
               return on_fixtures(now, place, v);
             }});
  }
  return found;
}

} // namespace

Effect fixture_flexibility() {
  return {.name = "fixture_flexibility",
          .plain = "a fixture that moves under the held end, with a resonance at {frequency}",
          .physics = "a held end stands on a fixture with mass and a resonance of its own",
          .signature = "the lowest modes fall, a further resonance appears, the held end moves",
          .look_alikes = {{"boundary_compliance", "an accelerometer on the fixture"},
                          {"added_mass", "a response of the fixture alone"}},
          .needs =
              "a mount, rigid or with springs; beside a baseline, diagnose: effects or priors of "
              "the case that name it",
          .hypotheses = fixture_flexibility_hypotheses};
}

} // namespace plica
