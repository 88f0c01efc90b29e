#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const JointGroup& group : joint_groups(s)) {
    if (group.mount) continue; // boundary_compliance
    const double present = group.present ? 1 : 0;
    found.push_back(
        {.effect = "joint_stiffness",
         .place = group.place,
         .way = "",
         .parameters = {{"ratio", "", {PriorKind::log_normal, group.present ? 1 : 0.3, 1}}},
         .changes = {added_group(group)},
         .coefficients = [present](const Eigen::VectorXd& v) {
           return Eigen::VectorXd(Eigen::VectorXd::Constant(1, v[0] - present));
         }});
  }
  return found;
}

} // namespace

Effect joint_stiffness() {
  return {.name = "joint_stiffness",
          .physics = "a joint between two parts is softer or stiffer than the case says",
          .signature = "modes that strain the joint move, at every level alike",
          .look_alikes = {"joint_friction: further levels",
                          "ply_slip: modes that do not strain the joint",
                          "boundary_compliance: an accelerometer on the held end"},
          .needs = "a joint, connector or interlock",
          .hypotheses = hypotheses};
}

} // namespace plica
