#include "lab/measured/states.hpp"

#include "lab/measured/entries.hpp"
#include "lab/measured/entry_lists.hpp"

#include <algorithm>
#include <map>

namespace plica {
namespace {

const MeasuredState* state_named(const Measured& measured, const std::string& name) {
  const auto found = std::find_if(measured.states.begin(), measured.states.end(),
                                  [&](const MeasuredState& s) { return s.name == name; });
  return found == measured.states.end() ? nullptr : &*found;
}

} // namespace

bool is_baseline(const Measured& measured, const std::string& state) {
  const MeasuredState* own = state_named(measured, state);
  return own && own->baseline;
}

bool has_baseline(const Measured& measured) {
  return std::any_of(measured.states.begin(), measured.states.end(),
                     [](const MeasuredState& s) { return s.baseline; });
}

bool is_weighed_in_all_states(const Measured& measured) {
  std::set<std::string> weighed;
  for (const MeasuredMass& w : measured.weighings) weighed.insert(w.state);
  const std::set<std::string> used = states_in_use(measured);
  return std::includes(weighed.begin(), weighed.end(), used.begin(), used.end());
}

Measured measured_in(const Measured& measured,
                     const std::function<bool(const std::string& state)>& kept) {
  Measured result = measured;
  std::map<std::string, std::string> renamed; // of those kept: "modes[3]" to "modes[1]"
  std::erase_if(result.weighings, [&](const MeasuredMass& w) { return !kept(w.state); });
  if (!result.weighings.empty()) renamed["mass"] = "mass"; // all of them
  std::size_t weighing = 0;
  for (std::size_t i = 0; i < measured.weighings.size(); ++i)
    if (kept(measured.weighings[i].state))
      renamed[weighing_name(measured, i)] = weighing_name(result, weighing++);
  for_each_list(result, [&](auto& entries, const char* list) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (!kept(entries[i].state)) continue;
      renamed[entry_name(list, i)] = entry_name(list, next);
      if (next != i) entries[next] = std::move(entries[i]);
      ++next;
    }
    entries.resize(next);
  });
  std::erase_if(result.states, [&](const MeasuredState& s) { return !kept(s.name); });
  result.hold_out = renamed_paths(result.hold_out, renamed);
  return result;
}

bool as_drawn(const Measured& measured, const std::string& state) {
  const bool changes = has_baseline(measured);
  if (state.empty()) return !changes;
  const MeasuredState* own = state_named(measured, state);
  return changes && own && own->baseline && own->set.empty();
}

Measured measured_as_drawn(const Measured& measured) {
  return measured_in(measured, [&](const std::string& state) { return as_drawn(measured, state); });
}

} // namespace plica
