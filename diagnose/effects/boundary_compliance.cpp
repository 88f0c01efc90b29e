#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const double arm = s.length / 4, k = 10 * s.stiffness;
  for (const HeldEnds& ends : held_ends(s))
    found.push_back(
        {.effect = "boundary_compliance",
         .place = ends.place,
         .way = "",
         .parameters = {{"k_translation", "N/m", {PriorKind::log_normal, k, 1.5}},
                        {"k_rotation", "Nm/rad", {PriorKind::log_normal, k * arm * arm, 1.5}}},
         .changes = {ground_springs(ends.nodes, 1, 0), ground_springs(ends.nodes, 0, 1)},
         .coefficients = [](const Eigen::VectorXd& v) { return v; },
         .at_rig = false,
         .released = ends.caps});
  return found;
}

} // namespace

Effect boundary_compliance() {
  return {.name = "boundary_compliance",
          .physics = "a held end gives way elastically",
          .signature = "the lowest modes fall most, the static stiffness of the rig stays",
          .look_alikes = {"fixture_flexibility: an accelerometer on the fixture",
                          "joint_stiffness: the static stiffness of the rig",
                          "unweighed_mass: an accelerometer on the held end"},
          .hypotheses = hypotheses};
}

} // namespace plica
