#include "diagnose/effects/places.hpp"

namespace plica {
namespace {

// Adds the group once more; one that is absent, at its reference stiffness.
ModelChange added_group(const JointGroup& group) {
  return {[group](Model& model) { scale_group(model, group, group.present ? 2 : 1); },
          Follow::series};
}

} // namespace

std::vector<Hypothesis> joint_stiffness(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const JointGroup& group : joint_groups(s)) {
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

// Stuck, the group has `ratio` times its stiffness; `share` of that slips.
std::vector<Hypothesis> joint_friction(const Structure& s) {
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
                       {"spread", "", {PriorKind::log_normal, 6, 0.7}}},
        .changes = {added_group(group)},
        .coefficients =
            [present](const Eigen::VectorXd& v) {
              return Eigen::VectorXd(Eigen::VectorXd::Constant(1, v[0] - present));
            },
        .softening =
            [](const Eigen::VectorXd& v) {
              return Softening{.share = v[1], .distance = v[2], .spread = v[3]};
            },
        .group_stiffness = group.stiffness,
        .group_present = present};
    found.push_back(std::move(h));
  }
  return found;
}

} // namespace plica
