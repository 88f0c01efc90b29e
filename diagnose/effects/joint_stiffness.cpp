#include "diagnose/effects/joint_size.hpp"
#include "diagnose/effects/joints_together.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>
#include <fmt/ranges.h>

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

bool bears(JointDirection own, JointDirection motion) {
  return motion == JointDirection::all || motion == own;
}

// Of the six springs of a cap.
Sextuple factors_of(JointDirection motion, double factor) {
  constexpr std::array of_row{JointDirection::lateral, JointDirection::axial,
                              JointDirection::lateral, JointDirection::bending,
                              JointDirection::torsion, JointDirection::bending};
  Sextuple factors{};
  for (std::size_t i = 0; i < factors.size(); ++i)
    factors[i] = bears(of_row[i], motion) ? factor : 1;
  return factors;
}

Sextuple times(Sextuple k, const Sextuple& factors) {
  for (std::size_t i = 0; i < k.size(); ++i) k[i] *= factors[i];
  return k;
}

std::string entry_of(const SprungEnd& e) {
  return fmt::format("{{end: '{}', stiffness: {}}}", e.end, yaml_of(e.stiffness));
}

// The springs of a cap at some of its places. None where they slip: stuck, they are more than
// these.
CaseEdits with_cap(const Cap& now, const std::vector<std::string>& places, const Sextuple& rigid,
                   const Sextuple& factors) {
  const auto is_meant = [&](const std::string& place) {
    return std::find(places.begin(), places.end(), place) != places.end();
  };
  const std::string key = cap_key(now.name);
  CaseEdits edits;
  if (is_meant(key) && !now.friction)
    edits.push_back({key + ".stiffness", yaml_of(times(now.stiffness.value_or(rigid), factors))});
  std::vector<std::string> all; // the ends on springs that they have now, and on new ones
  for (std::size_t i = 0; i < now.ends.size(); ++i) {
    const SprungEnd& e = now.ends[i];
    all.push_back(entry_of(e));
    if (is_meant(sprung_end_key(now.name, e.end)) && !e.friction)
      edits.push_back(
          {fmt::format("{}.ends[{}].stiffness", key, i), yaml_of(times(e.stiffness, factors))});
  }
  const std::size_t before = all.size();
  for (const std::string& end : now.of)
    if (is_meant(sprung_end_key(now.name, end)) && !hangs_on_springs(now, end))
      all.push_back(entry_of({.end = end, .stiffness = times(rigid, factors)}));
  if (all.size() > before && std::any_of(now.ends.begin(), now.ends.end(), [](const SprungEnd& e) {
        return e.friction || e.damping; // a list is written whole, and these have many keys
      }))
    return {};
  if (all.size() > before)
    edits.push_back({key + ".ends", fmt::format("[{}]", fmt::join(all, ", "))});
  return edits;
}

// Numbers of a joint that bear a motion, times a factor; where it has none those of what stands in
// for it.
CaseEdits with_joint(const Case& now, const std::string& place, const StandIn& stand_in,
                     JointDirection motion, double factor) {
  CaseEdits edits;
  const auto bears = [&](JointDirection own) { return plica::bears(own, motion); };
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

CaseEdits with_caps(const Case& now, const std::vector<std::string>& places, const Sextuple& rigid,
                    const Sextuple& factors) {
  CaseEdits edits;
  for (const Cap& cap : now.caps) {
    CaseEdits own = with_cap(cap, places, rigid, factors);
    const bool is_meant = std::any_of(places.begin(), places.end(), [&](const std::string& place) {
      return place == cap_key(cap.name) || place.starts_with(cap_key(cap.name) + ".");
    });
    if (is_meant && own.empty()) return {}; // all that is meant or nothing
    for (CaseEdit& edit : own) edits.push_back(std::move(edit));
  }
  return edits;
}

CaseEdits with_joints(const Case& now, const std::vector<std::string>& places,
                      const StandIn& stand_in, JointDirection motion, double factor) {
  CaseEdits edits = with_caps(now, places, stand_in.springs, factors_of(motion, factor));
  for (const std::string& place : places)
    if (!is_at_cap(place))
      for (CaseEdit& edit : with_joint(now, place, stand_in, motion, factor))
        edits.push_back(std::move(edit));
  return edits;
}

StandIn stand_in_of(const Structure& s, const JointGroup& group,
                    const std::vector<std::string>& places) {
  StandIn found;
  if (!group.present) found.tube = tube_of(s.built.model, group);
  if (group.rigid)
    for (const Cap& cap : s.data.caps) {
      if (cap_key(cap.name) == places.front()) found.springs = cap.stiffness.value();
      for (const SprungEnd& e : cap.ends)
        if (sprung_end_key(cap.name, e.end) == places.front()) found.springs = e.stiffness;
    }
  return found;
}

// A clamp that lets go in all directions, as by a bolt that is lost: what it has in turning is what
// it has in a translation at a lever of a quarter of the structure, as their priors stand.
Hypothesis let_go(const JointGroup& group, const std::vector<std::string>& places,
                  const Sextuple& rigid,
                  const std::vector<std::pair<JointDirection, JointSize>>& sizes) {
  const JointSize& translation = sizes.front().second;
  // Down to nothing that the readings would feel, every power of ten alike.
  EffectParameter stiffness = translation.parameter;
  const double centre = stiffness.prior.centre;
  stiffness.prior = {PriorKind::log_normal, centre, 20, 1e-6 * centre, 10 * centre};
  std::vector<ModelChange> changes;
  Eigen::VectorXd present(Eigen::Index(sizes.size()));
  for (const auto& [motion, size] : sizes) {
    present[Eigen::Index(changes.size())] = 1 / size.share;
    changes.push_back(added_group(group, motion, size.share));
  }
  return {.effect = "joint_stiffness",
          .place = group.place,
          .way = "all directions",
          .parameters = {stiffness},
          .changes = std::move(changes),
          .coefficients =
              [translation, present](const Eigen::VectorXd& v) {
                return Eigen::VectorXd(translation.units(v[0]) - present.array());
              },
          .in_case =
              [places, rigid, sizes](const Case& now, const Eigen::VectorXd& v) {
                Sextuple factors{1, 1, 1, 1, 1, 1};
                for (const auto& [motion, size] : sizes)
                  factors = times(
                      factors, factors_of(motion, size.share * sizes.front().second.units(v[0])));
                return with_caps(now, places, rigid, factors);
              }};
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
                 return with_joints(now, places, stand_in, motion, size.share * size.units(v[0]));
               }});
    };
    // What a rigid clamp has in one motion in terms of another nobody knows: no factor of all, but
    // it may let go (let_go).
    if (!group.rigid)
      add(JointDirection::all,
          {.parameter = {"ratio", "", {PriorKind::log_normal, group.present ? 1 : 0.3, 1}}});
    std::vector<std::pair<JointDirection, JointSize>> sizes;
    for (const auto& [motion, k] : motions_of(s.built.model, group)) {
      sizes.emplace_back(motion, joint_size(group, motion, k,
                                            group.present ? ratio_prior(s, k, motion)
                                                          : Prior{PriorKind::log_normal, 0.3, 1}));
      add(motion, sizes.back().second);
    }
    if (group.rigid && !sizes.empty())
      found.push_back(let_go(group, places, stand_in.springs, sizes));
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
