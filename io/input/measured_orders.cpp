#include "io/input/measured_orders.hpp"

#include "lab/measured/measured_words.hpp"
#include "model/description/check_log.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace plica {
namespace {

// What the modes of one direction are counted in, in one state and run: all of these increase.
std::string counted_with(const MeasuredMode& m) {
  std::string text = std::string(word_of(m.shape)) + m.state + "/" + m.sensor + "/" + m.drive;
  if (m.direction) text += word_of(*m.direction);
  if (m.base) text += std::string("/") + word_of(*m.base);
  for (const std::optional<double>& held : {m.level, m.acceleration, m.force})
    text += held ? "/" + std::to_string(*held) : "/";
  return text;
}

// Modes that are known by their kind and order: one that a table moved is known by its frequency,
// and two without a direction may be a pair, which a part that is not round has far apart.
bool is_known_by_order(const MeasuredMode& m) {
  const bool may_be_of_a_pair =
      (m.shape == MeasuredShape::transverse || m.shape == MeasuredShape::shell) && !m.direction;
  return !m.base && !may_be_of_a_pair;
}

bool states_order(const ReadLog& log, std::size_t i) {
  return log.lines.contains(item("modes", i) + ".order");
}

// Those of one order are one mode that was measured again, and make one reading: neighbours lie
// near each other.
void check_repeats(const Measured& m, ReadLog& log) {
  constexpr double measured_again = 1.2; // ratio of frequencies
  std::map<std::string, std::vector<std::size_t>> repeats;
  for (std::size_t i = 0; i < m.modes.size(); ++i)
    if (is_known_by_order(m.modes[i]))
      repeats[counted_with(m.modes[i]) + "/" + std::to_string(m.modes[i].order)].push_back(i);
  for (auto& [kind, list] : repeats) {
    std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
      return m.modes[a].frequency < m.modes[b].frequency;
    });
    for (std::size_t k = 1; k < list.size(); ++k) {
      const auto [first, second] = std::minmax(list[k - 1], list[k]);
      const MeasuredMode &a = m.modes[first], &b = m.modes[second];
      if (m.modes[list[k]].frequency <= measured_again * m.modes[list[k - 1]].frequency) continue;
      const std::string own = item("modes", second);
      log.add(states_order(log, second) ? own + ".order" : own,
              fmt::format("is mode {} at {:.6g} Hz, as is the one of the same kind at {:.6g} Hz",
                          b.order, b.frequency, a.frequency),
              "orders count modes upwards from 1, which is taken where none is given; a mode that "
              "was measured again lies within a fifth");
      break;
    }
  }
}

} // namespace

void count_modes_of_no_kind(Measured& m, const ReadLog& log) {
  std::map<std::string, std::vector<std::size_t>> groups;
  std::set<std::string> stated;
  for (std::size_t i = 0; i < m.modes.size(); ++i) {
    if (m.modes[i].shape != MeasuredShape::other || m.modes[i].base) continue;
    const std::string group = counted_with(m.modes[i]);
    groups[group].push_back(i);
    if (states_order(log, i)) stated.insert(group);
  }
  for (auto& [group, list] : groups) {
    if (stated.contains(group)) continue;
    std::stable_sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
      return m.modes[a].frequency < m.modes[b].frequency;
    });
    for (std::size_t k = 0; k < list.size(); ++k) m.modes[list[k]].order = int(k) + 1;
  }
}

void check_orders(const Measured& m, ReadLog& log) {
  check_repeats(m, log);
  for (std::size_t i = 0; i < m.modes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const MeasuredMode &a = m.modes[k], &b = m.modes[i];
      if (a.order == b.order || counted_with(a) != counted_with(b) ||
          (a.order < b.order) == (a.frequency < b.frequency))
        continue;
      log.add(item("modes", i) + ".order",
              fmt::format("order {} at {:.6g} Hz, order {} of the same kind at {:.6g} Hz", b.order,
                          b.frequency, a.order, a.frequency),
              "orders count modes upwards; one of them is taken for another");
      break;
    }
}

} // namespace plica
