#include "io/input/measured_states.hpp"

#include "lab/measured/measured_words.hpp"
#include "lab/measured/states.hpp"
#include "model/description/check_log.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>
#include <set>

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

} // namespace

std::string weighing_key(const ReadLog& log, std::size_t i) {
  return log.lines.contains("mass[0]") ? item("mass", i) : "mass";
}

void check_states(const Measured& m, ReadLog& log) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < m.states.size(); ++i) {
    const std::string key = item("states", i) + ".name";
    if (std::find(names.begin(), names.end(), m.states[i].name) != names.end())
      log.add(key, "the name is used by another state", "names must differ");
    names.push_back(m.states[i].name);
  }
  const auto check_one = [&](const std::string& state, const std::string& entry) {
    if (!state.empty() && std::find(names.begin(), names.end(), state) == names.end())
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
}

void check_baselines(const Measured& m, ReadLog& log) {
  if (!has_baseline(m)) return;
  const auto check = [&](const auto& entries, const char* list) {
    std::set<std::string> before;
    for (const auto& entry : entries)
      if (is_baseline(m, entry.state)) before.insert(thing(entry));
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (is_baseline(m, entries[i].state)) continue;
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

} // namespace plica
