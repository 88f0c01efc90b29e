#include "changes.hpp"

#include "../share.hpp"
#include "../verdicts.hpp"
#include "structures.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <set>

namespace sealed {
namespace {

using nlohmann::json;

// What says the same of the same place: the scale does not see a specimen again after the change,
// and at low frequencies a soft fixture is a soft clamp.
bool say_the_same(const std::string& a, const std::string& b) {
  static const std::vector<std::set<std::string>> groups{
      {"added_mass", "component_mass"}, {"boundary_compliance", "fixture_flexibility"}};
  return a == b || std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
           return group.contains(a) && group.contains(b);
         });
}

class Marker {
public:
  explicit Marker(const json& truth) : truth_(truth) {
    for (auto& s : changed_structures())
      if (s->name() == truth.at("structure")) structure_ = std::move(s);
  }

  // The effect and its place, within 5 % of the structure or the interval that it states.
  bool is_right(const json& said) const {
    if (truth_["effects"].empty()) return false;
    const json& effect = truth_["effects"][0];
    const std::string name = said.value("name", "");
    if (structure_->alike(name, said.value("place", ""), effect["name"], effect["place"]))
      return true;
    return say_the_same(name, effect["name"]) && place_is_right(said);
  }
  bool has_interval_of_place(const json& said) const {
    return said.contains("interval") && said["interval"].contains("at") &&
           !truth_["position"].empty();
  }
  bool place_in_interval(const json& said) const {
    const std::vector<double> from = structure_->point(said["place"]);
    return either([&](const std::vector<double>& p) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        if (!said["interval"].contains(axes[i]) || from.size() != p.size()) return false;
        const json& range = said["interval"][axes[i]];
        if (p[i] < from[i] + double(range[0]) || p[i] > from[i] + double(range[1])) return false;
      }
      return true;
    });
  }
  std::optional<bool> size_in_interval(const json& said) const {
    const json& effect = truth_["effects"][0];
    if (said.value("name", "") != effect["name"] || !said.contains("interval")) return {};
    for (const char* key : {"mass", "loss", "ratio", "k"})
      if (effect["value"].contains(key) && said["interval"].contains(key)) {
        const json& range = said["interval"][key];
        const double own = effect["value"][key];
        return own >= double(range[0]) && own <= double(range[1]);
      }
    return {};
  }

private:
  bool either(const std::function<bool(const std::vector<double>&)>& holds) const {
    const std::vector<double> p = truth_["position"]; // halves may be alike
    return holds(p) || holds(structure_->mirrored(p));
  }
  bool place_is_right(const json& said) const {
    const json& truth = truth_["effects"][0];
    const bool anywhere = truth["value"].contains("at"); // its point says where, not the part
    if (!anywhere && said.value("place", "") == truth["place"] && !has_interval_of_place(said))
      return true;
    if (truth_["position"].empty()) return false;
    for (const json& other : said.value("other_places", json::array()))
      if (!anywhere && other == truth["place"]) return true;
    if (has_interval_of_place(said) && place_in_interval(said)) return true;
    std::vector<double> own = structure_->point(said.value("place", ""));
    for (std::size_t i = 0; i < own.size(); ++i)
      own[i] += said.value("value", json::object()).value(axes[i], 0.);
    return either([&](const std::vector<double>& p) {
      double away = 0;
      for (std::size_t i = 0; i < std::min(p.size(), own.size()); ++i)
        away = std::hypot(away, p[i] - own[i]);
      return p.size() == own.size() && away <= 0.05 * structure_->length();
    });
  }

  static constexpr const char* axes[] = {"at", "across"};
  const json& truth_;
  std::unique_ptr<ChangedStructure> structure_;
};

struct Marked {
  std::string verdict;
  bool changed = false, detectable = false, confident = false, wrong = false, best = false,
       named = false;
  double ratio = 0;
  std::optional<bool> size, place; // within their intervals
};

// What leads, named or not.
json best_guess(const json& diagnosis) {
  for (const char* list : {"effects", "hypotheses"})
    for (const json& said : diagnosis.value(list, json::array())) {
      const json& first =
          said.contains("effects") && !said["effects"].empty() ? said["effects"][0] : said;
      if (first.value("name", "none") != "none") return first;
    }
  return json::object();
}

// What is told for sure: what a verdict names, or a row of the ledger with 0.9 and more, wherever
// the effect sits.
json told_for_sure(const Scored& s) {
  if (s.verdict == "identified" || s.verdict == "several" || s.verdict == "mostly")
    return s.diagnosis.value("effects", json::array());
  constexpr double sure = 0.9;
  json told = json::array();
  for (const json& row : s.diagnosis.value(json::json_pointer("/ledger/rows"), json::array()))
    for (const json& e : row.value("effects", json::array()))
      if (e.value("anywhere", 0.) >= sure) told.push_back(e);
  return told;
}

Marked marked(const Scored& s) {
  Marked m;
  m.verdict = s.verdict;
  m.changed = s.cls != "none";
  m.detectable = s.truth["detectable"];
  m.ratio = s.truth["ratio"];
  const Marker marker(s.truth);
  const json said = s.diagnosis.value("effects", json::array()), sure = told_for_sure(s);
  const auto right = [&](const json& e) { return marker.is_right(e); };
  m.confident = !sure.empty();
  m.wrong = !std::all_of(sure.begin(), sure.end(), right);
  const json best = best_guess(s.diagnosis);
  m.best = m.changed && marker.is_right(best);
  constexpr std::size_t most_listed = 3;
  m.named = m.changed && ((s.verdict == "identified" && !m.wrong) ||
                          (s.verdict == "ambiguous" && said.size() <= most_listed &&
                           std::any_of(said.begin(), said.end(), right)));
  if (m.best && (m.confident || s.verdict == "ambiguous")) {
    m.size = marker.size_in_interval(best);
    if (marker.has_interval_of_place(best)) m.place = marker.place_in_interval(best);
  }
  return m;
}

struct Goal {
  const char* name;
  double least, most; // of the share
};

void print(json& score, const Goal& goal, const std::string& of, const Share& share, bool judged) {
  if (share.of == 0) return;
  const std::string word = judged ? share.against(goal.least, goal.most) : "";
  fmt::print("  {:44} {:26} {:6.3f} [{:.3f}, {:.3f}]  {:3} of {:3}  {}\n", goal.name, of,
             share.value(), share.low(), share.high(), share.good, share.of, word);
  score["metrics"].push_back({{"name", goal.name},
                              {"of", of},
                              {"value", share.value()},
                              {"low", share.low()},
                              {"high", share.high()},
                              {"count", share.of},
                              {"goal", word}});
}

struct Band {
  const char* name;
  double from, to;
};
constexpr Band bands[] = {{"change below its error", 0, 1},
                          {"1 to 2 errors", 1, 2},
                          {"2 to 5 errors", 2, 5},
                          {"above 5 errors", 5, 1e9}};

using Counts = std::function<bool(const Marked&)>;

void print_shares(json& score, const Goal& goal, const std::vector<Marked>& all,
                  const Counts& counts, const Counts& good, const char* of, bool in_bands) {
  const auto share = [&](const Counts& also) {
    Share s;
    for (const Marked& m : all)
      if (counts(m) && also(m)) s.add(good(m));
    return s;
  };
  print(score, goal, of, share([](const Marked&) { return true; }), true);
  if (!in_bands) return;
  print(score, goal, "detectable ones", share([](const Marked& m) { return m.detectable; }), false);
  for (const Band& b : bands)
    print(score, goal, b.name,
          share([&](const Marked& m) { return m.ratio >= b.from && m.ratio < b.to; }), false);
}

} // namespace

bool score_changes(const std::filesystem::path& truth, const std::filesystem::path& out) {
  const std::vector<Scored> scored = read_verdicts(truth, out);
  std::vector<Marked> all;
  json score{{"specimens", json::array()}, {"metrics", json::array()}};
  std::map<std::string, std::map<std::string, int>> table;
  bool whole = true;
  for (const Scored& s : scored) {
    all.push_back(marked(s));
    const Marked& m = all.back();
    whole = whole && s.verdict != "missing";
    ++table[s.cls][s.verdict];
    const json best = best_guess(s.diagnosis);
    score["specimens"].push_back({{"id", s.id},
                                  {"structure", s.truth["structure"]},
                                  {"mechanism", s.truth["mechanism"]},
                                  {"class", s.cls},
                                  {"ratio", m.ratio},
                                  {"verdict", s.verdict},
                                  {"best", best.value("name", "") + "@" + best.value("place", "")},
                                  {"best_right", m.best},
                                  {"wrong", m.wrong}});
  }
  for (const auto& [cls, verdicts] : table) {
    fmt::print("{:22}", cls);
    for (const auto& [verdict, count] : verdicts) fmt::print(" {} {}", verdict, count);
    fmt::print("\n");
  }
  fmt::print("share [one-sided 90 % bounds]\n");
  const auto changed = [](const Marked& m) { return m.changed; };
  const auto any = [](const Marked&) { return true; };
  print_shares(
      score, {"confident and wrong", 0, 0.01}, all, any, [](const Marked& m) { return m.wrong; },
      "all specimens", true);
  print_shares(
      score, {"confident and wrong", 0, 1}, all, [](const Marked& m) { return m.confident; },
      [](const Marked& m) { return m.wrong; }, "confident answers", true);
  print_shares(
      score, {"best guess right", 0.9, 1}, all, changed, [](const Marked& m) { return m.best; },
      "changed", true);
  print_shares(
      score, {"named right", 0.75, 1}, all, changed, [](const Marked& m) { return m.named; },
      "changed", true);
  print_shares(
      score, {"none where nothing changed", 0.98, 1}, all,
      [](const Marked& m) { return !m.changed; },
      [](const Marked& m) { return m.verdict == "none"; }, "unchanged", false);
  print_shares(
      score, {"90 % intervals hold the size", 0.85, 0.95}, all,
      [](const Marked& m) { return m.size.has_value(); }, [](const Marked& m) { return *m.size; },
      "named rightly", true);
  print_shares(
      score, {"place within its interval", 0.9, 1}, all,
      [](const Marked& m) { return m.place.has_value(); }, [](const Marked& m) { return *m.place; },
      "named rightly", true);
  std::ofstream(out / "score.json") << score.dump(1) << '\n';
  return whole;
}

} // namespace sealed
