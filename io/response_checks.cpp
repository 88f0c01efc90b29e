#include "io/response_checks.hpp"

#include <set>

namespace plica {
namespace {

void check_band(const std::array<double, 2>& band, const std::string& key, CheckLog& log) {
  if (log.fine(key) && (band[0] <= 0 || band[1] <= band[0]))
    log.add(key, "is not a band", "give [from, to] with 0 < from < to");
}

void check_noise(const Noise* noise, const std::string& key, CheckLog& log) {
  if (!noise || !log.fine(key)) return;
  if ((noise->level > 0) == !noise->table.empty()) {
    log.add(key, noise->table.empty() ? "has neither level nor table" : "has a level and a table",
            "give level (constant over the band) or table ([frequency, density])");
    return;
  }
  for (std::size_t i = 0; i < noise->table.size(); ++i) {
    const std::string row = item(key + ".table", i);
    if (i > 0 && noise->table[i][0] <= noise->table[i - 1][0])
      log.add(row, "is not above the frequency before it", "frequencies must increase");
    if (noise->table[i][1] <= 0)
      log.add(row, "has a density that is not above zero", "straight in a log-log plot needs that");
  }
}

std::vector<std::string> channel_names(const Case& data) {
  std::vector<std::string> names;
  for (const Sensor& s : data.sensors)
    for (const char* axis : {"x", "y", "z"}) names.push_back(s.name + "." + axis);
  return names;
}

void check_damping(const Case& data, CheckLog& log) {
  const Damping& d = data.analyses.damping;
  const std::string key = "analyses.damping";
  if (!log.fine(key)) return;
  for (std::size_t i = 0; i < d.ranges.size(); ++i)
    check_band(d.ranges[i].band, item(key + ".ranges", i) + ".band", log);
  for (std::size_t i = 0; i < d.modes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (d.modes[i].mode == d.modes[j].mode && d.modes[i].mode > 0)
        log.add(item(key + ".modes", i) + ".mode", "is given twice", "one value for a mode");
  std::vector<std::string> components;
  for (const Part& part : data.parts)
    if (!std::holds_alternative<PointMass>(part.body)) components.push_back(part.name);
  for (const Mount& m : data.mount)
    if (m.kind == MountKind::springs) components.push_back("mount." + m.cap);
  for (std::size_t i = 0; i < d.loss_factors.size(); ++i)
    log.reference(item(key + ".loss_factors", i) + ".of", "component", d.loss_factors[i].of,
                  components);
}

void check_response(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  const std::string key = "analyses.response";
  if (!a.response || !log.fine(key)) return;
  const Response& r = *a.response;
  check_band(r.band, key + ".band", log);
  for (std::size_t i = 0; i < r.rms_bands.size(); ++i)
    check_band(r.rms_bands[i], item(key + ".rms_bands", i), log);
  check_noise(r.random ? &*r.random : nullptr, key + ".random", log);
  std::set<std::string> names;
  for (std::size_t i = 0; i < r.forces.size(); ++i) {
    const Force& force = r.forces[i];
    const std::string place = item(key + ".forces", i);
    log.once(names, force.name, place + ".name", "force");
    log.set_reference(place + ".at", force.at);
    check_noise(force.random ? &*force.random : nullptr, place + ".random", log);
  }
  for (std::size_t i = 0; i < r.cross.size(); ++i) {
    const std::string place = item(key + ".cross", i);
    log.reference(place + ".a", "channel", r.cross[i].a, channel_names(data));
    log.reference(place + ".b", "channel", r.cross[i].b, channel_names(data));
  }
  if (r.bases.empty() && r.forces.empty() && log.fine(key + ".base"))
    log.add(key, "has nothing that excites", "give base (directions), forces, or both");
  if (r.random && r.bases.empty())
    log.add(key + ".random", "is that of the base, which does not move", "give base (directions)");
  if (!a.modes)
    log.add(key, "is a sum of modes, and the case asks for none", "give analyses.modes");
  const Damping& d = a.damping;
  if (d.modal <= 0 && d.ranges.empty() && d.modes.empty() && d.loss_factors.empty() &&
      log.fine("analyses.damping"))
    log.add(key, "without damping has no finite peak", "give analyses.damping");
  if (data.sensors.empty() && log.fine("sensors"))
    log.add(key, "is that of the sensors, and the case has none", "give at least one sensor");
}

void check_stress(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  if (!a.stress || !log.fine("analyses.stress")) return;
  if (!a.modes && !a.statics)
    log.add("analyses.stress", "has neither modes nor a static analysis to recover stress from",
            "give analyses.modes or static: true");
  if (!a.stress->frequencies.empty() && !a.response)
    log.add("analyses.stress.frequencies", "is a harmonic response, and the case asks for none",
            "give analyses.response");
}

} // namespace

void check_responses(const Case& data, CheckLog& log) {
  check_damping(data, log);
  check_response(data, log);
  check_stress(data, log);
}

} // namespace plica
