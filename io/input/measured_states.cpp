#include "io/input/measured_states.hpp"

#include "lab/measured/entry_lists.hpp"
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

template <class Entry>
void check_quantities(const Measured& m, const std::vector<Entry>& entries, const char* list,
                      ReadLog& log) {
  std::map<std::string, std::set<std::string>> before; // of a thing its quantities
  for (const Entry& entry : entries)
    if (is_baseline(m, entry.state))
      for (const auto& [key, name] : further_quantities(entry)) before[thing(entry)].insert(key);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (is_baseline(m, entries[i].state)) continue;
    for (const auto& [key, name] : further_quantities(entries[i]))
      if (!before[thing(entries[i])].contains(key))
        log.add(item(list, i) + "." + key,
                std::string("no baseline has the ") + name + " of the " + thing(entries[i]),
                "the same measured in a state with baseline: true, or none here");
  }
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
  for (auto own = names.begin(); own != names.end(); ++own)
    if (std::find(names.begin(), own, *own) != own)
      log.add(item("states", std::size_t(own - names.begin())) + ".name",
              "the name is used by another state", "names must differ");
  const auto check = [&](const std::string& state, const std::string& key) {
    if (!is_known(names, state))
      log.add(key + ".state", "there is no state '" + shown(state) + "'",
              names.empty() ? "this file has no states" : suggestion(state, names));
  };
  for_each_list(m, [&](const auto& entries, const char* list) {
    for (std::size_t i = 0; i < entries.size(); ++i) check(entries[i].state, item(list, i));
  });
  for (std::size_t i = 0; i < m.weighings.size(); ++i)
    check(m.weighings[i].state, weighing_key(log, i));
}

void check_baselines(const Measured& m, ReadLog& log) {
  if (!has_baseline(m)) return;
  const std::vector<std::string> names = names_of(m.states);
  const auto check = [&](const auto& entries, const char* list) {
    std::set<std::string> before;
    for (const auto& entry : entries)
      if (is_baseline(m, entry.state)) before.insert(thing(entry));
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (is_baseline(m, entries[i].state) || !is_known(names, entries[i].state)) continue;
      if (!before.contains(thing(entries[i])))
        log.add(item(list, i), "no baseline has a " + thing(entries[i]),
                "the same measured in a state with baseline: true, or no such entry here");
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

void check_states_of_diagnosis(const Measured& m, ReadLog log) {
  const std::set<std::string> used = states_in_use(m);
  for (std::size_t i = 0; i < m.states.size(); ++i)
    if (!used.contains(m.states[i].name))
      log.add(item("states", i) + ".name", "nothing was measured in this state",
              "a state that entries name, or no such state");
  if (has_baseline(m)) {
    check_quantities(m, m.modes, "modes", log);
    check_quantities(m, m.peaks, "peaks", log);
  }
  if (log.problems.empty()) return;
  sort_by_line(log.problems, log.file);
  throw InputError(std::move(log.problems));
}

} // namespace plica
