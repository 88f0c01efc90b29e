#include "model/description/response_checks.hpp"

#include <algorithm>
#include <set>

namespace plica {
namespace {

void check_band(const std::array<double, 2>& band, const std::string& key, CheckLog& log) {
  if (log.fine(key) && (band[0] <= 0 || band[1] <= band[0]))
    log.add(key, "is not a band", "give [from, to] with 0 < from < to");
}

// `band`: of the response, which must hold the whole table.
void check_noise(const Noise* noise, const std::array<double, 2>& band, const std::string& key,
                 CheckLog& log) {
  if (!noise) return;
  if (log.fine(key) && (noise->level > 0) == !noise->table.empty()) {
    log.add(key, noise->table.empty() ? "has neither level nor table" : "has a level and a table",
            "give level (constant over the band) or table ([frequency, density])");
    return;
  }
  const bool band_known = log.fine("analyses.response.band");
  for (std::size_t i = 0; i < noise->table.size(); ++i) {
    const std::string row = item(key + ".table", i);
    const auto& [hertz, density] = noise->table[i];
    if (!log.fine(row)) continue;
    if (band_known && (hertz < band[0] || hertz > band[1]))
      log.add(row, "lies outside of the band of the response", "widen analyses.response.band");
    if (i > 0 && log.fine(item(key + ".table", i - 1)) && hertz <= noise->table[i - 1][0])
      log.add(row, "is not above the frequency before it", "frequencies must increase");
    if (density <= 0)
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
  for (const Cap& cap : data.caps)
    if (cap.stiffness) components.push_back("caps." + cap.name);
  std::set<std::string> damped;
  for (std::size_t i = 0; i < d.loss_factors.size(); ++i) {
    const std::string place = item(key + ".loss_factors", i) + ".of";
    log.reference(place, "component", d.loss_factors[i].of, components);
    log.once(damped, d.loss_factors[i].of, place, "loss factor");
  }
}

void check_response(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  const std::string key = "analyses.response";
  if (!a.response) return;
  const Response& r = *a.response;
  check_band(r.band, key + ".band", log);
  for (std::size_t i = 0; i < r.rms_bands.size(); ++i) {
    const std::string place = item(key + ".rms_bands", i);
    check_band(r.rms_bands[i], place, log);
    if (log.fine(place) && log.fine(key + ".band") &&
        (r.rms_bands[i][0] < r.band[0] || r.rms_bands[i][1] > r.band[1]))
      log.add(place, "reaches out of the band of the response", "widen analyses.response.band");
  }
  check_noise(r.random ? &*r.random : nullptr, r.band, key + ".random", log);
  std::set<std::string> names;
  for (std::size_t i = 0; i < r.forces.size(); ++i) {
    const Force& force = r.forces[i];
    const std::string place = item(key + ".forces", i);
    log.once(names, force.name, place + ".name", "force");
    log.set_reference(place + ".at", force.at);
    check_noise(force.random ? &*force.random : nullptr, r.band, place + ".random", log);
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
  check_held(key, data, log);
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
  for (std::size_t i = 0; a.response && i < a.stress->frequencies.size(); ++i)
    if (const double f = a.stress->frequencies[i];
        log.fine("analyses.response.band") && (f < a.response->band[0] || f > a.response->band[1]))
      log.add(item("analyses.stress.frequencies", i), "lies outside of the band of the response",
              "widen analyses.response.band");
  if (!a.stress->frequencies.empty() && !a.response)
    log.add("analyses.stress.frequencies", "is a harmonic response, and the case asks for none",
            "give analyses.response");
}

} // namespace

void check_held(const std::string& key, const Case& data, CheckLog& log) {
  const bool held = held_by_deck(data) || !data.supports.empty() ||
                    std::any_of(data.mount.begin(), data.mount.end(),
                                [](const Mount& m) { return m.kind != MountKind::free; });
  if (!held && log.fine("mount") && log.fine("supports"))
    log.add(key, "has nothing that holds the part, so it has no steady response",
            "give a mount or supports that leave no rigid motion free");
}

void check_responses(const Case& data, CheckLog& log) {
  check_damping(data, log);
  check_response(data, log);
  check_stress(data, log);
}

} // namespace plica
