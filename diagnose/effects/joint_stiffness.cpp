#include "diagnose/effects/joint_size.hpp"
#include "diagnose/effects/joints_together.hpp"
#include "model/description/place_keys.hpp"

namespace plica {
namespace {

// What stands for numbers that the case does not have.
struct StandIn {
  std::optional<BeamProperties> tube; // of an interlock without stiffness
  Sextuple springs{};                 // of a rigid clamp
};

// The liner that leans on the wall there, and its springs.
std::pair<std::string, const LinerContact*> contact_at(const Case& now, const std::string& place) {
  for (const Part& part : now.parts)
    if (const auto* liner = std::get_if<Interlock>(&part.body);
        liner && liner->contact && place == contact_place(part.name))
      return {part.name, &*liner->contact};
  return {};
}

// Numbers of a joint that bear a motion, times a factor; where it has none those of what stands in
// for it.
CaseEdits with_joint(const Case& now, const std::string& place, const StandIn& stand_in,
                     JointDirection motion, double factor) {
  CaseEdits edits;
  const auto bears = [&](JointDirection own) {
    return motion == JointDirection::all || motion == own;
  };
  if (is_at_cap(place)) {
    if (cap_named(now, cap_of(place))->friction)
      return {}; // stuck, its springs are more than these
    Sextuple k = cap_named(now, cap_of(place))->stiffness.value_or(stand_in.springs);
    constexpr std::array of_row{JointDirection::lateral, JointDirection::axial,
                                JointDirection::lateral, JointDirection::bending,
                                JointDirection::torsion, JointDirection::bending};
    for (std::size_t i = 0; i < k.size(); ++i)
      if (bears(of_row[i])) k[i] *= factor;
    return {{place + ".stiffness", yaml_of(k)}};
  }
  if (const auto [liner, contact] = contact_at(now, place); contact) {
    if (contact->friction) return {};
    const std::string path = part_key(liner) + ".contact.";
    if (bears(JointDirection::axial)) scale(edits, path + "axial", contact->axial, factor);
    if (bears(JointDirection::lateral)) scale(edits, path + "lateral", contact->lateral, factor);
    if (bears(JointDirection::bending)) scale(edits, path + "bending", contact->bending, factor);
    if (bears(JointDirection::torsion)) scale(edits, path + "torsion", contact->torsion, factor);
    return edits;
  }
  const Part* part = part_named(now, place);
  if (!part) return {};
  const std::string path = part_key(place) + ".";
  if (const auto* liner = std::get_if<Interlock>(&part->body)) {
    const auto own = [&](double drawn, double BeamProperties::*number) {
      return stand_in.tube ? (*stand_in.tube).*number : drawn;
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

StandIn stand_in_of(const Structure& s, const JointGroup& group,
                    const std::vector<std::string>& places) {
  StandIn found;
  if (!group.present) found.tube = tube_of(s.built.model, group);
  if (group.rigid) found.springs = cap_named(s.data, cap_of(places.front()))->stiffness.value();
  return found;
}

std::vector<Hypothesis> joint_stiffness_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const auto add_group = [&](const JointGroup& group, const std::vector<std::string>& places) {
    const StandIn stand_in = stand_in_of(s, group, places);
    const auto add = [&](JointDirection motion, const JointSize& size) {
      const double present = group.present ? 1 / size.share : 0;
      found.push_back(
          {.effect = "joint_stiffness",
           .place = group.place,
           .way = way_of(motion),
           .parameters = {size.parameter},
           .changes = {added_group(group, motion, size.share)},
           .coefficients =
               [size, present](const Eigen::VectorXd& v) {
                 return Eigen::VectorXd(Eigen::VectorXd::Constant(1, size.units(v[0]) - present));
               },
           .in_case =
               [places, stand_in, motion, size](const Case& now, const Eigen::VectorXd& v) {
                 CaseEdits edits;
                 for (const std::string& place : places)
                   for (auto& edit :
                        with_joint(now, place, stand_in, motion, size.share * size.units(v[0])))
                     edits.push_back(std::move(edit));
                 return edits;
               }});
    };
    // What a rigid clamp has in one motion in terms of another nobody knows: no factor of all.
    if (!group.rigid)
      add(JointDirection::all,
          {.parameter = {"ratio", "", {PriorKind::log_normal, group.present ? 1 : 0.3, 1}}});
    for (const auto& [motion, k] : motions_of(s.built.model, group))
      add(motion, joint_size(group, motion, k,
                             group.present ? ratio_prior(s, k, motion)
                                           : Prior{PriorKind::log_normal, 0.3, 1}));
  };
  const std::vector<JointGroup> groups = joint_groups(s);
  for (const JointGroup& group : groups)
    if (!group.mount) add_group(group, {group.place}); // of a mount: boundary_compliance
  for (const JointsTogether& all : joints_together(groups)) add_group(all.group, all.places);
  return found;
}

} // namespace

Effect joint_stiffness() {
  return {.name = "joint_stiffness",
          .plain = "a joint with {ratio} times the drawn stiffness",
          .plain_of_rigid = "a clamp that is drawn as rigid and gives way, {stiffness}",
          .physics = "a joint between two parts is softer or stiffer than the case says",
          .signature = "modes that strain the joint move, at every level alike",
          .look_alikes = {{"joint_friction", "further levels"},
                          {"ply_slip", "modes that do not strain the joint"},
                          {"boundary_compliance", "an accelerometer on the held end"}},
          .needs = "a joint or a clamp between parts, a connector or an interlock",
          .hypotheses = joint_stiffness_hypotheses};
}

} // namespace plica
