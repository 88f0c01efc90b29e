#include "io/decks/deck_refusal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plica {
namespace {

template <class Value, class Count>
std::vector<std::pair<std::string, Value>>
most_frequent_first(const std::map<std::string, Value>& all, Count&& count) {
  std::vector<std::pair<std::string, Value>> sorted(all.begin(), all.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto& a, const auto& b) { return count(a.second) > count(b.second); });
  return sorted;
}

std::string counted(int count, const std::string& name) {
  return count == 1 ? name : fmt::format("{} {}", count, name);
}

} // namespace

void PassedCards::finish(DeckModel& deck, const char* why) const {
  if (counts_.empty()) return;
  std::string list;
  for (const auto& [name, count] : most_frequent_first(counts_, [](int n) { return n; }))
    list += (list.empty() ? "" : ", ") + counted(count, name);
  deck.notes.push_back(std::string(why) + ": " + list);
}

void MissingCards::add(const std::string& card, const std::string& what, const DeckPosition& at) {
  Missing& m = missing_[card];
  if (m.count++ == 0) {
    m.what = what;
    m.at = at;
  }
}

void MissingCards::add_solid(const std::string& card, bool is_element, const DeckPosition& at,
                             int count) {
  Missing& m = solids_[card];
  if (m.count == 0) m.at = at;
  m.count += count;
  if (is_element) solid_elements_ += count;
}

void MissingCards::finish(DeckProblems& problems, DeckModel& deck,
                          const std::string& allowed) const {
  const auto say = [&](const DeckPosition& at, const std::string& card, const std::string& what,
                       const std::string& instead) {
    if (listed_)
      deck.left_out.push_back(fmt::format("{}:{}: {} {}", at.file, at.line, card, what));
    else
      problems.collect([&] { deck_error(at, card, what, instead); });
  };
  const auto count = [](const Missing& m) { return m.count; };
  if (!solids_.empty()) {
    std::string list;
    for (const auto& [name, m] : most_frequent_first(solids_, count))
      list += (list.empty() ? "" : ", ") + counted(m.count, name);
    const int all = elements_ + solid_elements_;
    const DeckPosition at = most_frequent_first(solids_, count).front().second.at;
    say(at, most_frequent_first(solids_, count).front().first,
        fmt::format("is of solids, {} of the {} elements of the deck ({:.0f} %): {}",
                    solid_elements_, all, 100. * solid_elements_ / std::max(all, 1), list),
        "shells, beams, masses and springs, or unknown_cards: list");
  }
  for (const auto& [name, m] : most_frequent_first(missing_, count))
    say(m.at, name, m.what + (m.count > 1 ? fmt::format(", {} times from here on", m.count) : ""),
        allowed);
}

} // namespace plica
