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

// Groups of effects that stand for one another, as rows of the ledger have them: each stands for
// one of the truth at most.
class Matching {
public:
  Matching(const Scored& s, const json& said, const json& truth)
      : s_(s), said_(said), truth_(truth), by_(said.size(), -1) {
    for (const bool exactly : {true, false}) // what is said to the letter first
      for (std::size_t t = 0; t < truth.size(); ++t) {
        std::vector<bool> asked(said.size(), false);
        if (!found(t)) place(int(t), exactly, asked);
      }
  }
  bool found(std::size_t t) const { return std::find(by_.begin(), by_.end(), int(t)) != by_.end(); }
  bool stands_for_one(std::size_t group) const { return by_[group] >= 0; }
  int count() const {
    return int(std::count_if(by_.begin(), by_.end(), [](int t) { return t >= 0; }));
  }

private:
  bool holds(std::size_t group, std::size_t t, bool exactly) const {
    return std::any_of(said_[group].begin(), said_[group].end(), [&](const json& e) {
      return exactly ? e.value("name", "") == truth_[t]["name"] &&
                           e.value("place", "") == truth_[t]["place"]
                     : is_right(s_, e, truth_[t]);
    });
  }
  // Finds a group for one of the truth; those that have one may change to another.
  bool place(int t, bool exactly, std::vector<bool>& asked) {
    for (std::size_t i = 0; i < said_.size(); ++i)
      if (!asked[i] && holds(i, std::size_t(t), exactly)) {
        asked[i] = true;
        if (by_[i] < 0 || place(by_[i], exactly, asked)) {
          by_[i] = t;
          return true;
        }
      }
    return false;
  }

  const Scored& s_;
  const json &said_, &truth_;
  std::vector<int> by_; // of each group: which of the truth it stands for, -1 = none
};

// Each effect by itself.
json groups_of(const json& effects) {
  json groups = json::array();
  for (const json& e : effects) groups.push_back(json::array({e}));
  return groups;
}

// What the answer stands for: the set whose ledger is told, or any row of which an effect is nearly
// sure to be part of the cause. Groups of alternatives.
json said_for_sure(const Scored& s, bool by_verdict) {
  const json rows = rows_of(s);
  if (by_verdict && rows.empty()) return groups_of(s.diagnosis.value("effects", json::array()));
  const auto is_sure = [](const json& e) {
    return e.contains("anywhere") && e["anywhere"].is_number() && double(e["anywhere"]) >= sure;
  };
  json said = json::array();
  for (const json& row : rows)
    if (by_verdict || std::any_of(row["effects"].begin(), row["effects"].end(), is_sure))
      said.push_back(row["effects"]);
  return said;
}

// An ambiguous answer: one group of effects; or of sets what the first has, each with what takes
// its place in the others.
json listed(const Scored& s) {
  json groups = json::array();
  for (const json& row : rows_of(s)) groups.push_back(row["effects"]);
  if (groups.empty()) groups.push_back(s.diagnosis.value("effects", json::array()));
  return groups;
}

// Of the truth what an ambiguous answer holds; too long a list holds nothing.
int held_by_list(const Scored& s, const json& truth) {
  const json groups = listed(s);
  const bool too_many = std::any_of(groups.begin(), groups.end(),
                                    [](const json& group) { return group.size() > most_listed; });
  return too_many ? 0 : Matching(s, groups, truth).count();
}

// Several sets may be listed that explain the test alike: an effect of another one may stand for
// one of the first.
int stand_ins(const Scored& s, const json& said, const Matching& matching, const json& truth) {
  if (s.verdict != "several") return 0;
  json others = json::array(), missed = json::array();
  for (const json& e : s.diagnosis.value("effects", json::array()))
    if (std::none_of(said.begin(), said.end(), [&](const json& group) {
          return std::any_of(group.begin(), group.end(), [&](const json& own) {
            return own["name"] == e["name"] && own["place"] == e["place"];
          });
        }))
      others.push_back(e);
  for (std::size_t t = 0; t < truth.size(); ++t)
    if (!matching.found(t)) missed.push_back(truth[t]);
  const json groups = groups_of(others);
  return Matching(s, groups, missed).count();
}

// What else may stand where a stranger acts, as stated with the specimen. A fixture has no place on
// the part, and what acts on all of it may look like what acts somewhere.
int look_alikes(const Scored& s, const json& said, const Matching& matching, const json& truth) {
  const json stated = s.truth.value("look_alikes", json::array());
  json strange = json::array();
  for (const json& e : s.truth["effects"])
    if (std::find(truth.begin(), truth.end(), e) == truth.end()) strange.push_back(e);
  const auto looks_alike = [&](const json& own) {
    return std::find(stated.begin(), stated.end(), own["name"]) != stated.end() &&
           std::any_of(strange.begin(), strange.end(), [&](const json& e) {
             return own["name"] == "fixture_flexibility" || e["place"] == "all" ||
                    says_place(s, own, e["place"]);
           });
  };
  std::size_t alike = 0;
  for (std::size_t i = 0; i < said.size(); ++i)
    alike +=
        !matching.stands_for_one(i) && std::any_of(said[i].begin(), said[i].end(), looks_alike);
  return int(std::min(alike, strange.size()));
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

// "added_mass@sensor.mid or damping@all, temperature@all"
std::string effect_words(const json& groups) {
  std::string text;
  for (const json& group : groups) {
    const char* between = text.empty() ? "" : ", ";
    for (const json& e : group) {
      text += between + e.value("name", "") + "@" + e.value("place", "");
      between = " or ";
    }
  }
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
  const Matching matching(s, said, truth);
  m.wrong = int(said.size()) > matching.count() + stand_ins(s, said, matching, truth) +
                                   look_alikes(s, said, matching, truth);
  m.ambiguous = s.verdict == "ambiguous";
  const json each_named = groups_of(named);
  m.found = m.ambiguous ? held_by_list(s, truth) : Matching(s, each_named, truth).count();
  m.all_named = m.truths > 0 && m.found == m.truths;
  m.ambiguous_right = m.ambiguous && m.all_named;
  m.first_right = m.ambiguous_right ||
                  (by_verdict && m.truths > 0 && !named.empty() && is_right(s, named[0], truth[0]));
  if (true_shares.is_object()) mark_shares(m, s, truth, true_shares);
  const double own = number_at(s.diagnosis, "/seconds");
  m.seconds = std::isnan(own) ? s.seconds : own;
  m.truth_words = effect_words(groups_of(s.truth["effects"]));
  m.said_words = effect_words(said.empty() ? each_named : said);
  return m;
}

} // namespace sealed
