#include "../share.hpp"
#include "marked_set.hpp"
#include "sets.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <map>

namespace sealed {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Check = std::function<bool(const MarkedSet&)>;

struct SetGoal {
  const char *name, *of;
  double least = 0, most = 1; // of the share
};

class SetTable {
public:
  explicit SetTable(const std::vector<MarkedSet>& all) : all_(all) {}

  void add(const SetGoal& goal, const Check& counts, const Check& good) {
    Share share;
    for (const MarkedSet& m : all_)
      if (counts(m)) share.add(good(m));
    print(goal, share, share.value());
  }
  void add(const SetGoal& goal, const Share& share) { print(goal, share, share.value()); }
  // The median is within a limit where half of them are.
  void add_median(const SetGoal& goal, const std::string& kind, double limit) {
    std::vector<double> seconds;
    Share within;
    for (const MarkedSet& m : all_)
      if (m.kind == kind && m.verdict != "missing") {
        seconds.push_back(m.seconds);
        within.add(m.seconds <= limit);
      }
    if (seconds.empty()) return;
    std::sort(seconds.begin(), seconds.end());
    print(goal, within, seconds[seconds.size() / 2]);
  }
  const json& rows() const { return rows_; }

private:
  static std::string words(const SetGoal& goal) {
    if (goal.least > 0 && goal.most < 1) return fmt::format("{} to {}", goal.least, goal.most);
    if (goal.least > 0) return fmt::format(">= {}", goal.least);
    return goal.most < 1 ? fmt::format("<= {}", goal.most) : "";
  }
  void print(const SetGoal& goal, const Share& share, double value) {
    if (share.of == 0) return;
    const std::string word = share.against(goal.least, goal.most);
    fmt::print("{:42} {:24} {:7.3f} [{:.3f}, {:.3f}]  {:3} of {:3}  {:12} {}\n", goal.name, goal.of,
               value, share.low(), share.high(), share.good, share.of, words(goal), word);
    rows_.push_back({{"name", goal.name},
                     {"of", goal.of},
                     {"value", value},
                     {"low", share.low()},
                     {"high", share.high()},
                     {"good", share.good},
                     {"count", share.of},
                     {"goal", words(goal)},
                     {"word", word}});
  }

  const std::vector<MarkedSet>& all_;
  json rows_ = json::array();
};

Check is_kind(const std::string& kind) {
  return [kind](const MarkedSet& m) { return m.kind == kind; };
}

json table_of(const std::vector<MarkedSet>& all) {
  fmt::print("{:42} {:24} {:>7} {:16}\n", "", "", "value", "90 % one-sided");
  SetTable table(all);
  const Check any = [](const MarkedSet&) { return true; };
  const Check confident = [](const MarkedSet& m) { return m.confident; };
  const Check wrong = [](const MarkedSet& m) { return m.wrong; };
  const Check whole = [](const MarkedSet& m) { return m.all_named; };
  table.add({"all three named", "triples", 0.60}, is_kind("triple"), whole);
  table.add({"two of three named", "triples", 0.90}, is_kind("triple"),
            [](const MarkedSet& m) { return m.found >= 2; });
  table.add({"both named", "pairs"}, is_kind("pair"), whole);
  table.add({"one of two named", "pairs"}, is_kind("pair"),
            [](const MarkedSet& m) { return m.found >= 1; });
  table.add({"first right", "singles"}, is_kind("effect"),
            [](const MarkedSet& m) { return m.first_right; });
  table.add({"the known one named", "known and stranger"}, is_kind("known_and_stranger"), whole);
  Share shares;
  for (const MarkedSet& m : all)
    for (int i = 0; i < m.shares; ++i) shares.add(i < m.shares_held);
  table.add({"90 % interval holds the true share", "effects in the ledger", 0.80, 0.97}, shares);
  table.add(
      {"interval of what is unexplained holds it", "strangers, alone or not", 0.80},
      [](const MarkedSet& m) { return m.unexplained.has_value(); },
      [](const MarkedSet& m) { return *m.unexplained; });
  table.add(
      {"the same", "where it is a twentieth"},
      [](const MarkedSet& m) { return m.unexplained && m.true_unexplained >= 0.05; },
      [](const MarkedSet& m) { return *m.unexplained; });
  table.add({"confident and wrong", "all specimens", 0, 0.01}, any, wrong);
  table.add({"confident and wrong", "confident answers"}, confident, wrong);
  table.add(
      {"lists at most three with the truth", "ambiguous answers"},
      [](const MarkedSet& m) { return m.ambiguous; },
      [](const MarkedSet& m) { return m.ambiguous_right; });
  table.add({"none", "healthy", 0.98}, is_kind("none"),
            [](const MarkedSet& m) { return m.verdict == "none"; });
  table.add_median({"median seconds, at most 30", "singles", 0.5}, "effect", 30);
  table.add_median({"median seconds, at most 180", "triples", 0.5}, "triple", 180);
  return table.rows();
}

json set_json(const MarkedSet& m) {
  return {{"id", m.id},
          {"structure", m.structure},
          {"kind", m.kind},
          {"class", m.cls},
          {"verdict", m.verdict},
          {"truths", m.truths},
          {"found", m.found},
          {"first_right", m.first_right},
          {"confident", m.confident},
          {"wrong", m.wrong},
          {"shares", m.shares},
          {"shares_held", m.shares_held},
          {"unexplained", m.unexplained ? json(*m.unexplained) : json()},
          {"seconds", m.seconds},
          {"truth", m.truth_words},
          {"said", m.said_words}};
}

} // namespace

bool score_sets(const fs::path& truth, const fs::path& out) {
  std::vector<MarkedSet> all;
  std::map<std::string, std::map<std::string, int>> verdicts;
  json specimens = json::array();
  int cannot = 0, without_shares = 0;
  bool whole = true;
  for (const Scored& s : read_verdicts(truth, out)) {
    std::ifstream in(out / s.id / "true" / "supposed.json");
    const json true_shares = in ? json::parse(in, nullptr, false) : json();
    const bool can_be_stated = supposed(s.truth).has_value();
    cannot += !can_be_stated;
    without_shares += can_be_stated && !true_shares.is_object();
    all.push_back(mark_set(s, true_shares));
    ++verdicts[s.kind][s.verdict];
    whole = whole && s.verdict != "missing";
    specimens.push_back(set_json(all.back()));
  }
  const json metrics = table_of(all);
  fmt::print("without true shares: {} that the library cannot state, {} others\n\n", cannot,
             without_shares);
  for (const auto& [kind, counts] : verdicts) {
    fmt::print("{:20}", kind);
    for (const auto& [verdict, n] : counts) fmt::print(" {} {}", verdict, n);
    fmt::print("\n");
  }
  fmt::print("\nconfident and wrong\n");
  for (const MarkedSet& m : all)
    if (m.wrong)
      fmt::print("  {} {:18} {}, said: {} {}\n", m.id, m.structure, m.truth_words, m.verdict,
                 m.said_words);
  std::ofstream(out / "score.json")
      << json{{"metrics", metrics}, {"verdicts", verdicts}, {"specimens", specimens}}.dump(1)
      << '\n';
  return whole;
}

} // namespace sealed
