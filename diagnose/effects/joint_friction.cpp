#include "diagnose/effects/joints_together.hpp"

#include <algorithm>

namespace plica {
namespace {

// Real joints follow no law exactly: one law for a whole group leaves about a tenth of what slip
// does to frequency, damping and height.
constexpr double law_error = 0.1;

bool has_levels(const Measured& m) {
  return std::any_of(m.frf.begin(), m.frf.end(),
                     [](const auto& f) { return f.level.has_value(); }) ||
         std::any_of(
             m.modes.begin(), m.modes.end(),
             [](const auto& mode) { return !mode.drive.empty() || (mode.base && mode.level); }) ||
         std::any_of(m.stiffness.begin(), m.stiffness.end(),
                     [](const auto& table) {
                       return std::any_of(table.numbers.begin(), table.numbers.end(),
                                          [](const auto& n) { return n.amplitude > 0; });
                     }) ||
         !m.peaks.empty();
}

// What a joint loses for the stiffness it gives up depends on how it unloads: Masing's rule is in
// the middle, half and twice as much occur (docs/friction.md, hose B).
//
// Stuck, the group has `ratio` times its stiffness; `share` of that slips. A joint that is drawn by
// a static test is drawn as it slips: stuck it may be ten times as stiff. In all motions by one
// law, or in one of them; turning is a path at a lever (places.hpp).
std::vector<Hypothesis> joint_friction_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  if (!has_levels(s.measured)) return found; // one motion: a softer joint says the same
  constexpr Prior drawn{PriorKind::log_normal, 1, 1.2}, absent{PriorKind::log_normal, 0.3, 0.7};
  std::vector<JointGroup> groups = joint_groups(s);
  if (const auto all = joints_together(groups)) groups.push_back(all->group);
  for (const JointGroup& group : groups) {
    const double present = group.present ? 1 : 0;
    const auto add = [&](JointDirection motion, const Prior& ratio, double stiffness) {
      found.push_back({.effect = "joint_friction",
                       .place = group.place,
                       .way = way_of(motion),
                       .parameters = {{"ratio", "", ratio},
                                      {"share", "", {PriorKind::uniform, 0, 1}},
                                      {"slip", "m", {PriorKind::log_normal, 1e-5, 2}},
                                      {"exponent", "", {PriorKind::log_normal, 1, 0.7}},
                                      {"across", "", {PriorKind::log_normal, 1, 0.8}},
                                      {"loss", "", {PriorKind::log_normal, 1, 0.5}}},
                       .size = 1,
                       .changes = {added_group(group, motion)},
                       .coefficients =
                           [present](const Eigen::VectorXd& v) {
                             return Eigen::VectorXd(Eigen::VectorXd::Constant(1, v[0] - present));
                           },
                       .softening =
                           [](const Eigen::VectorXd& v) {
                             return Softening{.share = v[1],
                                              .distance = v[2],
                                              .exponent = v[3],
                                              .across = v[4],
                                              .loss = v[5]};
                           },
                       .group_stiffness = stiffness,
                       .group_present = present,
                       .law_error = law_error});
    };
    add(JointDirection::all, group.present ? drawn : absent, group.stiffness);
    for (const auto& [motion, k] : motions_of(s.built.model, group)) {
      const double lever = turns(motion) ? lever_of(s) : 1;
      Prior ratio = group.present ? ratio_prior(s, k, motion) : absent;
      if (group.present) ratio.width = std::max(ratio.width, drawn.width);
      add(motion, ratio, k / (lever * lever));
    }
  }
  return found;
}

} // namespace

Effect joint_friction() {
  return {.name = "joint_friction",
          .plain = "a joint that slips",
          .physics = "a joint slips: its stiffness falls and its damping changes with amplitude",
          .signature = "frequencies fall with the level, damping rises and falls again",
          .look_alikes = {{"ply_slip", "the static stiffness at a small and a large stroke"},
                          {"joint_stiffness", "further levels"},
                          {"damping", "a free decay at a low level"}},
          .needs = "a joint, connector, interlock or springs of a mount, and levels of excitation",
          .hypotheses = joint_friction_hypotheses};
}

} // namespace plica
