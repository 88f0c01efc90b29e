#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

// In one motion: in terms of what the case says, but a joint that is far stiffer than the structure
// beside it may give way by as much as that does, whatever large number stands for rigid.
Prior prior_in(const Structure& s, double stiffness, JointDirection motion) {
  const double arm = s.length / 4;
  const double beside = s.stiffness * (turns(motion) ? arm * arm : 1);
  constexpr double share = 0.1; // of the structure's compliance
  const double centre = 1 / (1 + share * stiffness / beside);
  return {PriorKind::log_normal, centre, centre > 0.5 ? 1 : 1.5};
}

std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const JointGroup& group : joint_groups(s)) {
    if (group.mount) continue; // boundary_compliance
    const double present = group.present ? 1 : 0;
    const auto add = [&](JointDirection motion, const Prior& prior) {
      found.push_back({.effect = "joint_stiffness",
                       .place = group.place,
                       .way = way_of(motion),
                       .parameters = {{"ratio", "", prior}},
                       .changes = {added_group(group, motion)},
                       .coefficients = [present](const Eigen::VectorXd& v) {
                         return Eigen::VectorXd(Eigen::VectorXd::Constant(1, v[0] - present));
                       }});
    };
    add(JointDirection::all, {PriorKind::log_normal, group.present ? 1 : 0.3, 1});
    std::vector<std::pair<JointDirection, double>> single;
    for (JointDirection motion : {JointDirection::axial, JointDirection::lateral,
                                  JointDirection::bending, JointDirection::torsion})
      if (const double k = stiffness_in(s.built.model, group, motion); k > 0)
        single.emplace_back(motion, k);
    if (single.size() > 1)
      for (const auto& [motion, k] : single)
        add(motion, group.present ? prior_in(s, k, motion) : Prior{PriorKind::log_normal, 0.3, 1});
  }
  return found;
}

} // namespace

Effect joint_stiffness() {
  return {.name = "joint_stiffness",
          .plain = "a joint with {ratio} times the drawn stiffness",
          .physics = "a joint between two parts is softer or stiffer than the case says",
          .signature = "modes that strain the joint move, at every level alike",
          .look_alikes = {"joint_friction: further levels",
                          "ply_slip: modes that do not strain the joint",
                          "boundary_compliance: an accelerometer on the held end"},
          .needs = "a joint, connector or interlock",
          .hypotheses = hypotheses};
}

} // namespace plica
