#include "model/description/operating_state_checks.hpp"

#include "words/units.hpp"

#include <algorithm>
#include <cmath>

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

void check_offsets(const Case& data, const OperatingState& state, CheckLog& log) {
  for (const EndOffset& offset : state.offset) {
    const std::string key = "state.offset." + offset.cap;
    log.reference(key, "cap", offset.cap, cap_names(data));
    if (is_cap(data, offset.cap) && log.fine("mount") &&
        mount_of(data, offset.cap) == MountKind::free)
      log.add(key, "cap '" + offset.cap + "' is free: nothing moves it",
              "a mount that holds it, or state.force." + offset.cap);
  }
  for (const EndLoad& load : state.force) {
    const std::string key = "state.force." + load.cap;
    log.reference(key, "cap", load.cap, cap_names(data));
    if (log.fine(key) && log.fine("mount") && mount_of(data, load.cap) == MountKind::rigid)
      log.add(key, "cap '" + load.cap + "' is held rigidly: a force there moves nothing",
              "a cap that is free or sprung, or state.offset." + load.cap);
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

void check_temperatures(const Case& data, const OperatingState& state, CheckLog& log) {
  std::vector<std::string> names;
  for (const Part& part : data.parts) names.push_back(part.name);
  for (const PartTemperature& t : state.temperature) {
    const std::string key = "state.temperature." + t.part;
    log.reference(key, "part", t.part, names);
    if (t.at.has_value() == !t.along.empty())
      log.add(key, t.at ? "has both at and along" : "has no temperature", "at, or along");
    else if (!increasing(t.along))
      log.add(key + ".along", "has places that do not increase", "[y, temperature], y increasing");
    if (!log.fine(key) || !log.fine("parts") || !log.fine("materials")) continue;
    const auto part = std::find_if(data.parts.begin(), data.parts.end(),
                                   [&](const Part& p) { return p.name == t.part; });
    if (part == data.parts.end()) continue;
    const std::string name = material_of(*part);
    const auto material = data.materials.find(name);
    if (material == data.materials.end()) {
      log.add(key, "part '" + t.part + "' is not made of a material of the case",
              "parts with a material: bellows, plates, surfaces, beams with a section");
      continue;
    }
    std::vector<double> reached{state.free_of_stress_at};
    if (t.at) reached.push_back(*t.at);
    for (const auto& row : t.along) reached.push_back(row[1]);
    const auto [low, high] = std::minmax_element(reached.begin(), reached.end());
    const Material& m = material->second;
    for (const auto& [what, table] : {std::pair{"E_over_temperature", &m.E_over_temperature},
                                      std::pair{"expansion", &m.expansion}})
      if (!check_within(key, *high, name, what, *table, log))
        check_within(key, *low, name, what, *table, log);
  }
}

void check_pressure(const Case& data, CheckLog& log) {
  std::vector<std::string> closed;
  for (const Cap& cap : data.caps) closed.insert(closed.end(), cap.of.begin(), cap.of.end());
  bool any = false;
  for (const Part& part : data.parts) {
    if (!std::holds_alternative<Bellows>(part.body)) continue;
    any = true;
    for (const char* side : {".left", ".right"})
      if (std::find(closed.begin(), closed.end(), part.name + side) == closed.end())
        log.add("state.pressure",
                "acts in bellows '" + part.name + "', whose end " + part.name + side + " is open",
                "a cap on it, which bears the thrust");
  }
  if (!any) log.add("state.pressure", "acts inside bellows, and the case has none", "a bellows");
}

} // namespace

void check_operating_state(const Case& data, CheckLog& log) {
  for (const auto& [name, material] : data.materials)
    for (const auto& [key, table] : {std::pair{"E_over_temperature", material.E_over_temperature},
                                     std::pair{"expansion", material.expansion}})
      if (!increasing(table))
        log.add("materials." + name + "." + key, "has temperatures that do not increase",
                "[temperature, value], temperature increasing");
  if (!data.state) return;
  const OperatingState& state = *data.state;
  check_offsets(data, state, log);
  check_temperatures(data, state, log);
  if (state.pressure != 0 && log.fine("parts") && log.fine("caps")) check_pressure(data, log);
  if (data.analyses.reduction)
    log.add("state",
            "and analyses.reduction are not possible together: superelements are of parts "
            "at rest",
            "one of them");
  if (has_friction(data))
    log.add("state", "and friction are not possible together: joints are those of the part at rest",
            "a case without friction, nonlinear springs and slipping plies");
}

} // namespace plica
