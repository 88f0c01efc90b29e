#include "marked_set.hpp"

#include "sets.hpp"

#include <cmath>

namespace sealed {
namespace {

using nlohmann::json;

constexpr std::size_t most_listed = 3; // of an ambiguous answer
constexpr double sure = 0.9;           // inclusion

json rows_of(const Scored& s) {
  json rows = json::array();
  for (const json& row : s.diagnosis.value(json::json_pointer("/ledger/rows"), json::array()))
    if (!row.value("effects", json::array()).empty()) rows.push_back(row);
  return rows;
}

bool is_right(const Scored& s, const json& said, const json& truth) {
  return said.value("name", "") == truth["name"] && says_place(s, said, truth["place"]);
}

// For each of the truth which of those said it is, -1 = none; each is said once.
std::vector<int> matches_of(const Scored& s, const json& said, const json& truth) {
  std::vector<int> of(truth.size(), -1);
  std::vector<bool> used(said.size(), false);
  const auto match = [&](const auto& fits) {
    for (std::size_t t = 0; t < truth.size(); ++t)
      for (std::size_t i = 0; i < said.size() && of[t] < 0; ++i)
        if (!used[i] && fits(said[i], truth[t])) {
          of[t] = int(i);
          used[i] = true;
        }
  };
  match([&](const json& a, const json& b) {
    return a.value("name", "") == b["name"] && a.value("place", "") == b["place"];
  });
  match([&](const json& a, const json& b) { return is_right(s, a, b); });
  return of;
}

int count_found(const std::vector<int>& matches) {
  return int(std::count_if(matches.begin(), matches.end(), [](int i) { return i >= 0; }));
}

// What the answer stands for: the set whose ledger is told, or any row that is nearly sure to be
// part of the cause.
json said_for_sure(const Scored& s, bool by_verdict) {
  const json rows = rows_of(s);
  if (by_verdict && rows.empty()) return s.diagnosis.value("effects", json::array());
  json said = json::array();
  for (const json& row : rows) {
    if (row["effects"].size() != 1) continue; // alternatives
    const json& e = row["effects"][0];
    const bool is_sure =
        e.contains("anywhere") && e["anywhere"].is_number() && double(e["anywhere"]) >= sure;
    if (by_verdict || is_sure) said.push_back(e);
  }
  return said;
}

// Several sets may be listed that explain the test alike: an effect of another one may stand for
// one of the first.
int stand_ins(const Scored& s, const json& said, const json& truth) {
  if (s.verdict != "several") return 0;
  json others = json::array(), missed = json::array();
  for (const json& e : s.diagnosis.value("effects", json::array()))
    if (std::none_of(said.begin(), said.end(), [&](const json& own) {
          return own["name"] == e["name"] && own["place"] == e["place"];
        }))
      others.push_back(e);
  const std::vector<int> matches = matches_of(s, said, truth);
  for (std::size_t t = 0; t < truth.size(); ++t)
    if (matches[t] < 0) missed.push_back(truth[t]);
  return count_found(matches_of(s, others, missed));
}

// What else may stand where a stranger acts, as stated with the specimen. A fixture has no place on
// the part, and what acts on all of it may look like what acts somewhere.
int look_alikes(const Scored& s, const json& said, const json& truth) {
  const json stated = s.truth.value("look_alikes", json::array());
  json strange = json::array(), others = json::array();
  for (const json& e : s.truth["effects"])
    if (std::find(truth.begin(), truth.end(), e) == truth.end()) strange.push_back(e);
  const std::vector<int> matches = matches_of(s, said, truth);
  for (std::size_t i = 0; i < said.size(); ++i)
    if (std::find(matches.begin(), matches.end(), int(i)) == matches.end() &&
        std::find(stated.begin(), stated.end(), said[i]["name"]) != stated.end() &&
        std::any_of(strange.begin(), strange.end(), [&](const json& e) {
          return said[i]["name"] == "fixture_flexibility" || e["place"] == "all" ||
                 says_place(s, said[i], e["place"]);
        }))
      others.push_back(said[i]);
  return int(std::min(others.size(), strange.size()));
}

bool within(const json& interval, double share) {
  constexpr double digits = 1e-6; // what nothing is known of has an interval of no width
  return interval.is_array() && interval.size() == 2 && interval[0].is_number() &&
         interval[1].is_number() && share >= double(interval[0]) - digits &&
         share <= double(interval[1]) + digits;
}

// Rows of effects of supposed.json stand in the order of the truth.
void mark_shares(MarkedSet& m, const Scored& s, const json& truth, const json& true_shares) {
  const json rows = rows_of(s);
  const json known = true_shares.value("rows", json::array());
  std::vector<bool> used(rows.size(), false);
  for (std::size_t t = 0; t < truth.size() && t < known.size(); ++t)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const json& said = rows[i]["effects"];
      if (used[i] || !known[t].value("share", json()).is_number() ||
          std::none_of(said.begin(), said.end(),
                       [&](const json& e) { return is_right(s, e, truth[t]); }))
        continue;
      used[i] = true;
      ++m.shares;
      m.shares_held += within(rows[i].value("interval", json()), known[t]["share"]);
      break;
    }
  if (s.kind != "stranger" && s.kind != "known_and_stranger") return;
  for (const json& row : known)
    if (row.value("left", "") == "unexplained") {
      m.true_unexplained = row["share"];
      for (const json& own : s.diagnosis.value(json::json_pointer("/ledger/rows"), json::array()))
        if (own.value("left", "") == "unexplained")
          m.unexplained = within(own.value("interval", json()), m.true_unexplained);
    }
}

std::string effect_words(const json& effects) {
  std::string text;
  for (const json& e : effects)
    text += (text.empty() ? "" : ", ") + e.value("name", "") + "@" + e.value("place", "");
  return text.empty() ? "nothing" : text;
}

} // namespace

MarkedSet mark_set(const Scored& s, const json& true_shares) {
  const json truth = known_effects(s.truth), named = s.diagnosis.value("effects", json::array());
  MarkedSet m{.id = s.id,
              .structure = s.truth["structure"],
              .kind = s.kind,
              .cls = s.cls,
              .verdict = s.verdict,
              .truths = int(truth.size())};
  const bool by_verdict =
      s.verdict == "identified" || s.verdict == "several" || s.verdict == "mostly";
  const json said = said_for_sure(s, by_verdict);
  m.confident = by_verdict || !said.empty();
  m.wrong = int(said.size()) > count_found(matches_of(s, said, truth)) + stand_ins(s, said, truth) +
                                   look_alikes(s, said, truth);
  m.ambiguous = s.verdict == "ambiguous";
  const bool lists_too_many = m.ambiguous && named.size() > most_listed;
  m.found = lists_too_many ? 0 : count_found(matches_of(s, named, truth));
  m.all_named = m.truths > 0 && m.found == m.truths;
  m.ambiguous_right = m.ambiguous && m.found > 0;
  m.first_right = m.ambiguous_right ||
                  (by_verdict && m.truths > 0 && !named.empty() && is_right(s, named[0], truth[0]));
  if (true_shares.is_object()) mark_shares(m, s, truth, true_shares);
  const double own = number_at(s.diagnosis, "/seconds");
  m.seconds = std::isnan(own) ? s.seconds : own;
  m.truth_words = effect_words(s.truth["effects"]);
  m.said_words = effect_words(said.empty() ? named : said);
  return m;
}

} // namespace sealed
