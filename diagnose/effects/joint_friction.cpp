#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

// Stuck, the group has `ratio` times its stiffness; `share` of that slips.
std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const JointGroup& group : joint_groups(s)) {
    const double present = group.present ? 1 : 0;
    Hypothesis h{
        .effect = "joint_friction",
        .place = group.place,
        .way = "",
        .parameters = {{"ratio", "", {PriorKind::log_normal, group.present ? 1 : 0.3, 0.7}},
                       {"share", "", {PriorKind::uniform, 0, 1}},
                       {"slip", "m", {PriorKind::log_normal, 1e-5, 2}},
                       {"spread", "", {PriorKind::log_normal, 5, 0.8}},
                       {"across", "", {PriorKind::log_normal, 1, 0.8}}},
        .changes = {added_group(group)},
        .coefficients =
            [present](const Eigen::VectorXd& v) {
              return Eigen::VectorXd(Eigen::VectorXd::Constant(1, v[0] - present));
            },
        .softening =
            [](const Eigen::VectorXd& v) {
              return Softening{.share = v[1], .distance = v[2], .spread = v[3], .across = v[4]};
            },
        .group_stiffness = group.stiffness,
        .group_present = present};
    found.push_back(std::move(h));
  }
  return found;
}

} // namespace

Effect joint_friction() {
  return {.name = "joint_friction",
          .physics = "a joint slips: its stiffness falls and its damping changes with amplitude",
          .signature = "frequencies fall with the level, damping rises and falls again",
          .look_alikes = {"ply_slip: the static stiffness at a small and a large stroke",
                          "joint_stiffness: further levels",
                          "damping: a free decay at a low level"},
          .hypotheses = hypotheses};
}

} // namespace plica
