#include "model/description/operating_state_checks.hpp"

#include "model/description/steels.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

std::vector<std::string> cap_names(const Case& data) {
  std::vector<std::string> names;
  for (const Cap& cap : data.caps) names.push_back(cap.name);
  return names;
}

MountKind mount_of(const Case& data, const std::string& cap) {
  const auto found = std::find_if(data.mount.begin(), data.mount.end(),
                                  [&](const Mount& m) { return m.cap == cap; });
  return found == data.mount.end() ? MountKind::free : found->kind;
}

bool increasing(const std::vector<std::array<double, 2>>& table) {
  return std::adjacent_find(table.begin(), table.end(), [](const auto& a, const auto& b) {
           return !(a[0] < b[0]);
         }) == table.end();
}

bool is_cap(const Case& data, const std::string& name) {
  return std::any_of(data.caps.begin(), data.caps.end(),
                     [&](const Cap& cap) { return cap.name == name; });
}

// `at`: path of the state, "state" or "states.hot".
void check_offsets(const Case& data, const OperatingState& state, const std::string& at,
                   CheckLog& log) {
  for (const EndOffset& offset : state.offset) {
    const std::string key = at + ".offset." + offset.cap;
    log.reference(key, "cap", offset.cap, cap_names(data));
    if (is_cap(data, offset.cap) && log.fine("mount") &&
        mount_of(data, offset.cap) == MountKind::free)
      log.add(key, "cap '" + offset.cap + "' is free: nothing moves it",
              "a mount that holds it, or " + at + ".force." + offset.cap);
  }
  for (const EndLoad& load : state.force) {
    const std::string key = at + ".force." + load.cap;
    log.reference(key, "cap", load.cap, cap_names(data));
    if (log.fine(key) && log.fine("mount") && mount_of(data, load.cap) == MountKind::rigid)
      log.add(key, "cap '" + load.cap + "' is held rigidly: a force there moves nothing",
              "a cap that is free or sprung, or " + at + ".offset." + load.cap);
  }
}

std::string known_steels() {
  std::string text;
  for (const Steel& steel : steels()) text += (text.empty() ? "" : ", ") + std::string(steel.name);
  return text;
}

// True when something was wrong.
bool check_within(const std::string& key, double temperature, const std::string& material,
                  const char* what, const std::vector<std::array<double, 2>>& table,
                  CheckLog& log) {
  if (table.empty())
    log.add(key, std::string("needs ") + what + " of material '" + material + "' over temperature",
            "materials." + material + "." + what + ", or a steel by its number: " + known_steels());
  else if (temperature < table.front()[0] || temperature > table.back()[0])
    log.add(key,
            short_number(temperature) + " degC lies beyond the table of " + what +
                " of material '" + material + "'",
            short_number(table.front()[0]) + " to " + short_number(table.back()[0]) +
                " degC; nothing is extrapolated");
  else
    return false;
  return true;
}

// How the temperature is given, and whether heat can be conducted there. True when that is fine.
bool check_kind(const PartTemperature& t, const Part* part, const std::string& key, CheckLog& log) {
  if (int(t.at.has_value()) + int(!t.along.empty()) + int(t.conducted()) != 1)
    log.add(key,
            t.at || !t.along.empty() || t.conducted() ? "is given in more than one way"
                                                      : "has no temperature",
            "at, or along, or held, inside and outside, between which heat is conducted");
  else if (!increasing(t.along))
    log.add(key + ".along", "has places that do not increase", "[y, temperature], y increasing");
  for (std::size_t i = 0; i < t.held.size(); ++i) {
    const std::string set = item(key + ".held", i) + ".set";
    log.set_reference(set, t.held[i].set);
    if (log.fine(set) && !is_below(t.held[i].set, t.part))
      log.add(set, "is not a set of part '" + t.part + "'", "sets that begin with " + t.part + ".");
  }
  const bool shells = part && (std::holds_alternative<Bellows>(part->body) ||
                               std::holds_alternative<Plate>(part->body) ||
                               std::holds_alternative<SurfacePart>(part->body));
  if (t.conducted() && part && !shells)
    log.add(key, "cannot conduct heat: part '" + t.part + "' has no wall",
            "at or along; bellows, plates and surfaces conduct");
  return log.fine(key);
}

void check_tables(const Case& data, const OperatingState& state, const PartTemperature& t,
                  const Part& part, const std::string& key, CheckLog& log) {
  const std::string name = material_of(part);
  const auto material = data.materials.find(name);
  if (material == data.materials.end()) {
    log.add(key, "part '" + t.part + "' is not made of a material of the case",
            "parts with a material: bellows, plates, surfaces, beams with a section");
    return;
  }
  const auto [low, high] = range_of(t);
  const Material& m = material->second;
  const auto check = [&](const char* what, const std::vector<std::array<double, 2>>& table,
                         double from, double to) {
    if (!check_within(key, to, name, what, table, log))
      check_within(key, from, name, what, table, log);
  };
  const double rest = state.free_of_stress_at;
  check("E_over_temperature", m.E_over_temperature, std::min(low, rest), std::max(high, rest));
  check("expansion", m.expansion, std::min(low, rest), std::max(high, rest));
  if (!m.nu_over_temperature.empty())
    check("nu_over_temperature", m.nu_over_temperature, std::min(low, rest), std::max(high, rest));
  if (t.conducted()) check("conductivity", m.conductivity, low, high);
}

void check_temperatures(const Case& data, const OperatingState& state, const std::string& at,
                        CheckLog& log) {
  std::vector<std::string> names;
  for (const Part& part : data.parts) names.push_back(part.name);
  for (const PartTemperature& t : state.temperature) {
    const std::string key = at + ".temperature." + t.part;
    log.reference(key, "part", t.part, names);
    const auto part = std::find_if(data.parts.begin(), data.parts.end(),
                                   [&](const Part& p) { return p.name == t.part; });
    const bool known = part != data.parts.end();
    if (check_kind(t, known ? &*part : nullptr, key, log) && known && log.fine("parts") &&
        log.fine("materials"))
      check_tables(data, state, t, *part, key, log);
  }
}

void check_bolts(const Case& data, const OperatingState& state, const std::string& at,
                 CheckLog& log) {
  std::vector<std::string> beams;
  for (const Part& part : data.parts)
    if (std::holds_alternative<BeamPart>(part.body)) beams.push_back(part.name);
  for (const BoltForce& bolt : state.bolt) {
    const std::string key = at + ".bolt." + bolt.part;
    log.reference(key, "beam", bolt.part, beams);
    for (const Part& part : data.parts)
      if (const auto* beam = std::get_if<BeamPart>(&part.body);
          beam && part.name == bolt.part && beam->section.shape == BeamShape::general &&
          !(beam->section.EA.value_or(0) > 0))
        log.add(key, "is a beam without stiffness along its axis", "a section with EA above 0");
  }
}

void check_pressure(const Case& data, const std::string& key, CheckLog& log) {
  for (const std::string& end : open_ends(data))
    log.add(key,
            "acts in bellows '" + end.substr(0, end.rfind('.')) + "', whose end " + end +
                " is open",
            "a cap on it, which bears the thrust");
  if (std::none_of(data.parts.begin(), data.parts.end(),
                   [](const Part& part) { return std::holds_alternative<Bellows>(part.body); }))
    log.add(key, "acts inside bellows, and the case has none", "a bellows");
}

void check_state(const Case& data, const OperatingState& state, const std::string& at,
                 CheckLog& log) {
  check_offsets(data, state, at, log);
  check_temperatures(data, state, at, log);
  check_bolts(data, state, at, log);
  if (state.pressure != 0 && log.fine("parts") && log.fine("caps"))
    check_pressure(data, at + ".pressure", log);
  if (data.analyses.reduction)
    log.add(at,
            "and analyses.reduction are not possible together: superelements in a run are of "
            "parts at rest",
            "one of them; plica reduce takes the whole part in its state");
  for (const Part& part : data.parts)
    if (const auto* bellows = std::get_if<Bellows>(&part.body); bellows && bellows->wall.slip)
      log.add(at,
              "and parts." + part.name +
                  ".wall.slip are not possible together: plies slip around the part at rest alone",
              "friction of joints, or a wall without slip");
}

} // namespace

std::vector<std::string> open_ends(const Case& data) {
  std::set<std::string> closed;
  for (const Cap& cap : data.caps) closed.insert(cap.of.begin(), cap.of.end());
  std::vector<std::string> open;
  for (const Part& part : data.parts)
    for (const char* side : {".left", ".right"})
      if (std::holds_alternative<Bellows>(part.body) && !closed.contains(part.name + side))
        open.push_back(part.name + side);
  return open;
}

void check_operating_state(const Case& data, CheckLog& log) {
  for (const auto& [name, material] : data.materials)
    for (const auto& [key, table] :
         {std::pair{"E_over_temperature", &material.E_over_temperature},
          std::pair{"expansion", &material.expansion},
          std::pair{"nu_over_temperature", &material.nu_over_temperature},
          std::pair{"conductivity", &material.conductivity}}) {
      const std::string path = "materials." + name + "." + key;
      if (!increasing(*table))
        log.add(path, "has temperatures that do not increase",
                "[temperature, value], temperature increasing");
      const bool is_nu = table == &material.nu_over_temperature;
      for (const auto& [temperature, value] : *table)
        if (is_nu ? !(value > -1 && value < 0.5)
                  : table == &material.conductivity && !(value > 0)) {
          log.add(path, "has the value " + short_number(value),
                  is_nu ? "above -1 and below 0.5" : "above 0");
          break;
        }
    }
  if (data.state) check_state(data, *data.state, "state", log);
  for (const OperatingState& state : data.states)
    check_state(data, state, "states." + state.name, log);
}

} // namespace plica
