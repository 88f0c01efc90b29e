#include "model/description/friction_checks.hpp"

#include "model/description/place_keys.hpp"
#include "model/description/response_checks.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

template <bool angular>
void check_law(const std::string& key, const FrictionLaw<angular>& law, CheckLog& log) {
  if (!log.fine(key)) return;
  const bool empty = law.sliders.empty() && !law.iwan && !law.dry && !law.smoothed &&
                     !law.clearance && law.cubic == 0 && law.curve.empty();
  if (empty)
    log.add(key, "holds no law", "give sliders, iwan, dry, smoothed, clearance, cubic or curve");
  if (law.iwan && law.iwan->chi <= -1 && law.iwan->smallest <= 0)
    log.add(key + ".iwan.chi", "has no finite stiffness at rest", "above -1, or give smallest");
  for (std::size_t i = 1; i < law.curve.size(); ++i)
    if (law.curve[i][0] <= law.curve[i - 1][0] || law.curve[i][1] < law.curve[i - 1][1])
      log.add(item(key + ".curve", i), "does not lie beyond the point before it",
              "motions that increase, and forces that do not fall");
  if (!law.curve.empty() && std::none_of(law.curve.begin(), law.curve.end(),
                                         [](const auto& p) { return p[0] == 0 && p[1] == 0; }))
    log.add(key + ".curve", "does not pass through [0, 0]", "a point at rest");
}

template <class Law>
bool check_one(const std::string& key, const std::optional<Law>& law, CheckLog& log) {
  if (!law) return false;
  check_law(key, *law, log);
  return true;
}

void check_directions(const std::string& key, const SlenderFriction& f, CheckLog& log) {
  bool any = check_one(key + ".axial", f.axial, log);
  any = check_one(key + ".lateral", f.lateral, log) || any;
  any = check_one(key + ".bending", f.bending, log) || any;
  any = check_one(key + ".torsion", f.torsion, log) || any;
  if (!any && log.fine(key))
    log.add(key, "acts in no direction", "give axial, lateral, bending or torsion");
}

void check_directions(const std::string& key, const JointFriction& f, CheckLog& log) {
  bool any = check_one(key + ".x", f.x, log);
  any = check_one(key + ".y", f.y, log) || any;
  any = check_one(key + ".z", f.z, log) || any;
  any = check_one(key + ".rx", f.rx, log) || any;
  any = check_one(key + ".ry", f.ry, log) || any;
  any = check_one(key + ".rz", f.rz, log) || any;
  if (!any && log.fine(key)) log.add(key, "acts in no direction", "give x, y, z, rx, ry or rz");
}

void check_part(const Part& part, CheckLog& log) {
  const std::string key = part_key(part.name);
  const auto* liner = std::get_if<Interlock>(&part.body);
  if (liner && liner->contact && liner->contact->friction)
    check_directions(key + ".contact.friction", *liner->contact->friction, log);
  if (liner && liner->friction) {
    check_directions(key + ".friction", *liner->friction, log);
    if (liner->attachment != Attachment::caps && liner->friction->segments > 1)
      log.add(key + ".friction.segments", "are given by the places where the interlock is tied",
              "leave them out, or attachment: caps");
  }
  if (const auto* chain = std::get_if<ConnectorChain>(&part.body); chain && chain->friction)
    check_directions(key + ".friction", *chain->friction, log);
  const auto* bellows = std::get_if<Bellows>(&part.body);
  if (!bellows || !bellows->wall.slip || !log.fine(key + ".wall")) return;
  const Wall& wall = bellows->wall;
  if (wall.plies.size() < 2)
    log.add(key + ".wall.slip", "is friction between plies, and the wall has but one",
            "at least two plies");
  else if (wall.slip->bond <= wall.bond)
    log.add(key + ".wall.slip.bond", "is not above the bond of the slipping wall",
            "wall.bond below it, 0 for plies that slip freely");
}

void check_increasing(const std::string& key, const std::vector<double>& levels, CheckLog& log) {
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (levels[i] <= levels[i - 1] && log.fine(item(key, i)))
      log.add(item(key, i), "is not above the level before it", "levels must increase");
}

void check_levels(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  const std::string key = "analyses.levels";
  if (!a.levels || !log.fine(key)) return;
  const Levels& l = *a.levels;
  if (l.band[0] <= 0 || l.band[1] <= l.band[0])
    log.add(key + ".band", "is not a band", "give [from, to] with 0 < from < to");
  check_increasing(key + ".levels", l.levels, log);
  for (std::size_t i = 0; i < l.forces.size(); ++i) {
    const std::string place = item(key + ".forces", i);
    log.set_reference(place + ".at", l.forces[i].at);
    check_increasing(place + ".levels", l.forces[i].levels, log);
  }
  if (l.bases.empty() && l.forces.empty())
    log.add(key, "has nothing that excites", "give base (directions) with levels, or forces");
  if (l.bases.empty() != l.levels.empty())
    log.add(key, l.bases.empty() ? "has levels and no base that moves" : "has a base and no levels",
            "give base and levels together");
  if (l.samples < 8 * (l.harmonics + 1))
    log.add(key + ".samples", "are too few for " + std::to_string(l.harmonics) + " harmonics",
            "at least " + std::to_string(8 * (l.harmonics + 1)) + ", better 256");
  check_held(key, data, log);
  const Damping& d = a.damping;
  if (d.modal <= 0 && d.ranges.empty() && d.loss_factors.empty() && !has_damped_springs(data) &&
      log.fine("analyses.damping"))
    log.add(key, "without damping has no finite peak where joints stick",
            "give analyses.damping.modal, ranges or loss_factors");
  if (data.sensors.empty() && log.fine("sensors"))
    log.add(key, "is the response of the sensors, and the case has none",
            "give at least one sensor");
  if (!has_friction(data) && log.fine("parts") && log.fine("caps") && log.fine("mount"))
    log.add(key, "at several levels needs friction or a nonlinear spring, and the case has none",
            "give friction to an interlock, a connector, a joint or a mount, slip to a wall, or "
            "analyses.response");
}

} // namespace

void check_friction(const Case& data, CheckLog& log) {
  for (const Part& part : data.parts) check_part(part, log);
  for (const Cap& cap : data.caps) {
    for (std::size_t i = 0; i < cap.ends.size(); ++i)
      if (cap.ends[i].friction)
        check_directions(item(cap_key(cap.name) + ".ends", i) + ".friction", *cap.ends[i].friction,
                         log);
    const std::string key = cap_key(cap.name) + ".friction";
    if (!cap.friction) continue;
    check_directions(key, *cap.friction, log);
    if (!cap.ends.empty())
      log.add(key, "is that of a cap whose ends hang on springs of their own",
              "give friction to one of its `ends`");
    else if (!cap.stiffness && log.fine(cap_key(cap.name)))
      log.add(key, "is that of a rigid connection, which cannot slip",
              "give the cap of: [first end, second end] and stiffness");
  }
  for (const Mount& mount : data.mount)
    if (mount.friction) check_directions(mount_key(mount.cap) + ".friction", *mount.friction, log);
  check_levels(data, log);
}

} // namespace plica
