#include "diagnose/effects/joints_together.hpp"

namespace plica {
namespace {

// Numbers of a joint that bear a motion, times a factor; of an interlock that has none in terms of
// what stands in for it.
CaseEdits with_joint(const Case& now, const std::string& place,
                     const std::optional<BeamProperties>& absent, JointDirection motion,
                     double factor) {
  CaseEdits edits;
  const auto bears = [&](JointDirection own) {
    return motion == JointDirection::all || motion == own;
  };
  if (place.starts_with("caps.")) {
    Sextuple k = cap_named(now, place.substr(5))->stiffness.value_or(Sextuple{});
    constexpr std::array of_row{JointDirection::lateral, JointDirection::axial,
                                JointDirection::lateral, JointDirection::bending,
                                JointDirection::torsion, JointDirection::bending};
    for (std::size_t i = 0; i < k.size(); ++i)
      if (bears(of_row[i])) k[i] *= factor;
    return {{place + ".stiffness", yaml_of(k)}};
  }
  const Part* part = part_named(now, place);
  if (!part) return {};
  const std::string path = "parts." + place + ".";
  if (const auto* liner = std::get_if<Interlock>(&part->body)) {
    const auto own = [&](double drawn, double BeamProperties::*number) {
      return absent ? (*absent).*number : drawn;
    };
    using B = BeamProperties;
    if (bears(JointDirection::axial)) scale(edits, path + "EA", own(liner->EA, &B::EA), factor);
    if (bears(JointDirection::bending)) scale(edits, path + "EI", own(liner->EI, &B::EI_y), factor);
    if (bears(JointDirection::torsion)) scale(edits, path + "GJ", own(liner->GJ, &B::GJ), factor);
  }
  const auto* chain = std::get_if<ConnectorChain>(&part->body);
  const auto add = [&](const std::string& key, const ConnectorSpring& s) {
    if (bears(JointDirection::axial)) scale(edits, key + ".axial", s.axial, factor);
    if (bears(JointDirection::lateral)) scale(edits, key + ".transverse", s.transverse, factor);
    if (bears(JointDirection::bending)) scale(edits, key + ".bending", s.bending, factor);
    if (bears(JointDirection::torsion)) scale(edits, key + ".torsion", s.torsion, factor);
  };
  const auto is_plain = [](const ConnectorSpring& s) {
    return s.matrix.empty() && s.axial_curve.empty() && s.transverse_curve.empty();
  };
  if (!chain || !is_plain(chain->spring) || (chain->end_spring && !is_plain(*chain->end_spring)))
    return edits;
  add(path + "spring", chain->spring);
  if (chain->end_spring) add(path + "end_spring", *chain->end_spring);
  return edits;
}

std::vector<Hypothesis> joint_stiffness_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  std::vector<JointGroup> groups = joint_groups(s);
  const auto all = joints_together(groups);
  if (all) groups.push_back(all->group);
  for (const JointGroup& group : groups) {
    if (group.mount) continue; // boundary_compliance
    const std::vector<std::string> places =
        all && group.place == all->group.place ? all->places : std::vector{group.place};
    const double present = group.present ? 1 : 0;
    std::optional<BeamProperties> absent;
    if (!group.present) absent = tube_of(s.built.model, group);
    const auto add = [&](JointDirection motion, const Prior& prior) {
      found.push_back({.effect = "joint_stiffness",
                       .place = group.place,
                       .way = way_of(motion),
                       .parameters = {{"ratio", "", prior}},
                       .changes = {added_group(group, motion)},
                       .coefficients =
                           [present](const Eigen::VectorXd& v) {
                             return Eigen::VectorXd(Eigen::VectorXd::Constant(1, v[0] - present));
                           },
                       .in_case =
                           [places, absent, motion](const Case& now, const Eigen::VectorXd& v) {
                             CaseEdits edits;
                             for (const std::string& place : places)
                               for (auto& edit : with_joint(now, place, absent, motion, v[0]))
                                 edits.push_back(std::move(edit));
                             return edits;
                           }});
    };
    add(JointDirection::all, {PriorKind::log_normal, group.present ? 1 : 0.3, 1});
    for (const auto& [motion, k] : motions_of(s.built.model, group))
      add(motion, group.present ? ratio_prior(s, k, motion) : Prior{PriorKind::log_normal, 0.3, 1});
  }
  return found;
}

} // namespace

Effect joint_stiffness() {
  return {.name = "joint_stiffness",
          .plain = "a joint with {ratio} times the drawn stiffness",
          .physics = "a joint between two parts is softer or stiffer than the case says",
          .signature = "modes that strain the joint move, at every level alike",
          .look_alikes = {{"joint_friction", "further levels"},
                          {"ply_slip", "modes that do not strain the joint"},
                          {"boundary_compliance", "an accelerometer on the held end"}},
          .needs = "a joint, connector or interlock",
          .hypotheses = joint_stiffness_hypotheses};
}

} // namespace plica
