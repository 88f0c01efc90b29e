#include "io/input/measured_states.hpp"

#include "lab/measured/measured_words.hpp"
#include "lab/measured/states.hpp"
#include "model/description/check_log.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace plica {
namespace {

// What makes two entries measurements of one thing, whatever the state.
std::string thing(const MeasuredStatic& s) {
  return std::string(word_of(s.direction)) + " stiffness";
}
std::string thing(const MeasuredStiffnessTable& s) {
  return "dynamic stiffness" + (s.ends.empty() ? "" : " from " + s.ends[0]);
}
std::string thing(const MeasuredMode& m) {
  std::string text = std::string(word_of(m.shape)) + " mode " + std::to_string(m.order);
  if (m.direction) text += std::string(" in ") + word_of(*m.direction);
  if (m.base) text += std::string(", base ") + word_of(*m.base);
  return m.sensor.empty() ? text : text + ", sensor " + m.sensor;
}
std::string thing(const MeasuredPeaks& p) {
  return "peak of " + p.sensor + "." + word_of(p.direction) + ", base " + word_of(p.base);
}
std::string thing(const MeasuredFrf& f) {
  return f.base ? std::string("response to base ") + word_of(*f.base)
                : "response to a force at " + f.force;
}

// What of an entry a baseline must have as well: its key and what it is called.
using Quantities = std::vector<std::pair<const char*, const char*>>;
template <class Entry> Quantities further_quantities(const Entry&) {
  return {};
}
Quantities further_quantities(const MeasuredMode& m) {
  Quantities all;
  if (m.damping) all.emplace_back("damping", "damping");
  if (m.vector) all.emplace_back("vector", "shape");
  return all;
}
Quantities further_quantities(const MeasuredPeaks& p) {
  Quantities all;
  if (!p.amplitude.empty()) all.emplace_back("amplitude", "amplitude");
  if (!p.damping.empty()) all.emplace_back("damping", "damping");
  return all;
}

std::vector<std::string> names_of(const std::vector<MeasuredState>& states) {
  std::vector<std::string> names;
  for (const MeasuredState& s : states) names.push_back(s.name);
  return names;
}

bool is_known(const std::vector<std::string>& names, const std::string& state) {
  return state.empty() || std::find(names.begin(), names.end(), state) != names.end();
}

} // namespace

std::string weighing_key(const ReadLog& log, std::size_t i) {
  return log.lines.contains("mass[0]") ? item("mass", i) : "mass";
}

void check_states(const Measured& m, ReadLog& log) {
  const std::vector<std::string> names = names_of(m.states);
  std::set<std::string> used;
  const auto check_one = [&](const std::string& state, const std::string& entry) {
    used.insert(state);
    if (!is_known(names, state))
      log.add(entry + ".state", "there is no state '" + shown(state) + "'",
              names.empty() ? "this file has no states" : suggestion(state, names));
  };
  const auto check = [&](const auto& entries, const char* list) {
    for (std::size_t i = 0; i < entries.size(); ++i) check_one(entries[i].state, item(list, i));
  };
  check(m.statics, "static");
  check(m.stiffness, "stiffness");
  check(m.modes, "modes");
  check(m.peaks, "peaks");
  check(m.frf, "frf");
  check(m.signals, "signals");
  for (std::size_t i = 0; i < m.weighings.size(); ++i)
    check_one(m.weighings[i].state, weighing_key(log, i));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string key = item("states", i) + ".name";
    if (std::find(names.begin(), names.begin() + std::ptrdiff_t(i), names[i]) !=
        names.begin() + std::ptrdiff_t(i))
      log.add(key, "the name is used by another state", "names must differ");
    else if (!used.contains(names[i]))
      log.add(key, "nothing was measured in this state",
              "a state that entries name, or no such state");
  }
}

void check_baselines(const Measured& m, ReadLog& log) {
  if (!has_baseline(m)) return;
  const std::vector<std::string> names = names_of(m.states);
  const auto check = [&](const auto& entries, const char* list) {
    std::map<std::string, std::set<std::string>> before; // of a thing its quantities
    for (const auto& entry : entries)
      if (is_baseline(m, entry.state)) {
        std::set<std::string>& known = before[thing(entry)];
        for (const auto& [key, name] : further_quantities(entry)) known.insert(key);
      }
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (is_baseline(m, entries[i].state) || !is_known(names, entries[i].state)) continue;
      const auto known = before.find(thing(entries[i]));
      if (known == before.end()) {
        log.add(item(list, i), "no baseline has a " + thing(entries[i]),
                "the same measured in a state with baseline: true, or no such entry here");
        continue;
      }
      for (const auto& [key, name] : further_quantities(entries[i]))
        if (!known->second.contains(key))
          log.add(item(list, i) + "." + key,
                  std::string("no baseline has the ") + name + " of the " + thing(entries[i]),
                  "the same measured in a state with baseline: true, or none here");
    }
  };
  check(m.statics, "static");
  check(m.stiffness, "stiffness");
  check(m.modes, "modes");
  check(m.peaks, "peaks");
  check(m.frf, "frf");
  for (std::size_t i = 0; i < m.weighings.size(); ++i)
    if (m.weighings[i].state.empty())
      log.add(weighing_key(log, i), "does not say in which state it was weighed",
              "state: one of `states`, as there is a baseline");
}

} // namespace plica
