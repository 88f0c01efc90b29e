#include "diagnose/effects/joint_size.hpp"
#include "diagnose/effects/joints_together.hpp"
#include "lab/measured/measured_words.hpp"
#include "lab/measured/states.hpp"

#include <algorithm>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace plica {
namespace {

// Real joints follow no law exactly: one law for a whole group leaves about a tenth of what slip
// does to frequency, damping and height.
constexpr double law_error = 0.1;

constexpr double other_level = 1.1; // nearer ones are one, held as well as a controller does

// Whether anything was looked at in two motions of unlike size: an excitation at two levels, a rig
// at two amplitudes (0 is a small one). In one motion a softer joint says the same as one that
// slips; and in a baseline nothing slips that is looked for.
bool has_levels(const Measured& m) {
  std::map<std::string, std::set<double>> of; // by excitation
  const auto add = [&](const std::string& state, const std::string& excitation, double level) {
    if (!is_baseline(m, state)) of[excitation].insert(level);
  };
  const auto on_table = [](Axis axis) { return std::string("base ") + word_of(axis); };
  const auto by_force = [](const std::string& channel) { return "force at " + channel; };
  for (const MeasuredFrf& f : m.frf)
    if (f.level) add(f.state, f.base ? on_table(*f.base) : by_force(f.force), *f.level);
  for (const MeasuredMode& mode : m.modes) {
    if (mode.base && mode.level) add(mode.state, on_table(*mode.base), *mode.level);
    if (mode.acceleration) add(mode.state, "held at " + mode.drive, *mode.acceleration);
    if (mode.force) add(mode.state, by_force(mode.drive), *mode.force);
  }
  for (const MeasuredPeaks& p : m.peaks)
    for (double level : p.level) add(p.state, on_table(p.base), level);
  for (const MeasuredStiffnessTable& table : m.stiffness)
    for (const MeasuredStiffness& n : table.numbers)
      add(table.state, fmt::format("rig {} {}", fmt::join(table.ends, " "), n.direction),
          n.amplitude);
  return std::any_of(of.begin(), of.end(), [](const auto& one) {
    return *one.second.rbegin() > other_level * *one.second.begin();
  });
}

// What a joint loses for the stiffness it gives up depends on how it unloads: Masing's rule is in
// the middle, half and twice as much occur (docs/friction.md, hose B).
//
// Stuck, the group has `ratio` times its stiffness; `share` of that slips. A joint that is drawn by
// a static test is drawn as it slips: stuck it may be ten times as stiff. In all motions by one
// law, or in one of them; turning is a path at a lever (joint_groups.hpp). A clamp that is drawn as
// rigid is stuck as stiff as its `stiffness` says, by the prior ten times what stands beside it,
// and slips in one motion: what it has in terms of another nobody knows.
std::vector<Hypothesis> joint_friction_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  if (!has_levels(s.measured)) return found; // a softer joint says the same
  constexpr Prior drawn{PriorKind::log_normal, 1, 1.2}, absent{PriorKind::log_normal, 0.3, 0.7};
  std::vector<JointGroup> groups = joint_groups(s);
  for (JointsTogether& all : joints_together(groups)) groups.push_back(std::move(all.group));
  for (const JointGroup& group : groups) {
    // `stiffness`: of the group, in this motion as a path.
    const auto add = [&](JointDirection motion, const JointSize& size, double stiffness) {
      const double present = group.present ? 1 / size.share : 0;
      found.push_back({.effect = "joint_friction",
                       .place = group.place,
                       .way = way_of(motion),
                       .parameters = {size.parameter,
                                      {"share", "", {PriorKind::uniform, 0, 1}},
                                      {"slip", "m", {PriorKind::log_normal, 1e-5, 2}},
                                      {"exponent", "", {PriorKind::log_normal, 1, 0.7}},
                                      {"across", "", {PriorKind::log_normal, 1, 0.8}},
                                      {"loss", "", {PriorKind::log_normal, 1, 0.5}}},
                       .size = 1,
                       .changes = {added_group(group, motion, size.share)},
                       .coefficients =
                           [size, present](const Eigen::VectorXd& v) {
                             return Eigen::VectorXd(
                                 Eigen::VectorXd::Constant(1, size.units(v[0]) - present));
                           },
                       .softening =
                           [](const Eigen::VectorXd& v) {
                             return Softening{.share = v[1],
                                              .distance = v[2],
                                              .exponent = v[3],
                                              .across = v[4],
                                              .loss = v[5]};
                           },
                       .group_stiffness = size.share * stiffness,
                       .group_present = present,
                       .law_error = law_error});
    };
    if (!group.rigid)
      add(JointDirection::all, {.parameter = {"ratio", "", group.present ? drawn : absent}},
          group.stiffness);
    for (const auto& [motion, k] : motions_of(s.built.model, group)) {
      const double lever = turns(motion) ? lever_of(s) : 1;
      Prior ratio = group.present ? ratio_prior(s, k, motion) : absent;
      if (group.present) ratio.width = std::max(ratio.width, drawn.width);
      add(motion, joint_size(group, motion, k, ratio), k / (lever * lever));
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
          .needs = "a joint or a clamp between parts, a connector, an interlock or springs of a "
                   "mount, and two levels of an excitation",
          .hypotheses = joint_friction_hypotheses};
}

} // namespace plica
