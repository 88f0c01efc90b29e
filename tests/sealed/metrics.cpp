#include "metrics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace sealed {
namespace {

using nlohmann::json;

bool is_effect(const Scored& s) {
  return s.kind == "effect";
}
bool detected_effect(const Scored& s) {
  return is_effect(s) && s.is_detectable;
}
bool holds_truth(const Scored& s) {
  return names(s, true_effect(s));
}
bool top_is_right(const Scored& s) {
  return !s.named.empty() && s.named[0] == true_effect(s);
}

bool all_named_are_true(const Scored& s) {
  return std::all_of(s.named.begin(), s.named.end(), [&](const std::string& name) {
    for (const json& e : s.truth.value("effects", json::array()))
      if (e["name"] == name) return true;
    return false;
  });
}

bool confidently_wrong(const Scored& s) {
  return (s.verdict == "identified" && !top_is_right(s)) ||
         ((s.verdict == "several" || s.verdict == "mostly") && !all_named_are_true(s));
}

// The verdict, or what it declares to look like it, is what the stranger could be taken for.
bool caveat_names_look_alike(const Scored& s) {
  if (s.verdict == "unknown") return true;
  for (const json& look_alike : s.truth["look_alikes"])
    for (const std::string& name : s.named)
      if (name == look_alike || declared_cosine(s, name, look_alike) >= 0.9) return true;
  return false;
}

// Held-out gap of the verdict over that of the true hypothesis.
double against_oracle(const Scored& s) {
  double oracle = NAN;
  for (const json& h : s.diagnosis.value("hypotheses", json::array()))
    if (h.value("name", "") == true_effect(s) && h.value("place", "") == true_place(s))
      oracle = number_at(h, "/heldout_after");
  return number_at(s.diagnosis, "/gap/heldout/after") / oracle;
}

// Parameters of a rightly named effect whose stated interval holds the truth.
void count_intervals(const Scored& s, int& inside, int& of) {
  const json& e = s.diagnosis["effects"][0];
  const json interval = e.value("interval", json());
  for (const auto& [key, truth] : s.truth["effects"][0]["value"].items()) {
    json limits = interval.is_object() && interval.contains(key) ? interval[key] : json();
    if (interval.is_array() && e.contains("value") && e["value"].contains(key)) limits = interval;
    if (!limits.is_array() || limits.size() != 2 || !limits[0].is_number()) continue;
    ++of;
    inside += double(truth) >= double(limits[0]) && double(truth) <= double(limits[1]);
  }
}

Metric calibration(const std::vector<Scored>& all, double& skill) {
  std::array<double, 10> stated{}, right{}, count{};
  double brier = 0, base = 0, n = 0;
  for (const Scored& s : all) {
    if (!is_effect(s)) continue;
    for (const json& e : s.diagnosis.value("effects", json::array())) {
      if (!e.contains("probability") || !e["probability"].is_number()) continue;
      const double p = e["probability"], hit = e["name"] == true_effect(s);
      const auto bin = std::size_t(std::clamp(p * 10, 0., 9.));
      stated[bin] += p;
      right[bin] += hit;
      ++count[bin];
      brier += (p - hit) * (p - hit);
      base += hit;
      ++n;
    }
  }
  double error = 0;
  for (std::size_t b = 0; b < 10; ++b) error += std::abs(stated[b] - right[b]) / std::max(n, 1.);
  const double rate = base / std::max(n, 1.), spread = n * rate * (1 - rate);
  skill = spread > 0 ? 1 - brier / spread : NAN;
  return {.number = 12,
          .name = "calibration error of the probabilities",
          .value = error,
          .of = int(n),
          .accept = 0.10,
          .at_most = true};
}

double runtime(const Scored& s) {
  const double own = number_at(s.diagnosis, "/seconds");
  return std::isnan(own) ? s.seconds : own;
}

std::vector<double> collected(const std::vector<Scored>& all, const Test& counts,
                              const std::function<double(const Scored&)>& value) {
  std::vector<double> values;
  for (const Scored& s : all)
    if (counts(s)) values.push_back(value(s));
  return values;
}

// Of the ambiguous verdicts that hold the truth: the first measurement proposed, by its own
// declaration, separates the truth from the others. Random choice among the menu is beside it.
Metric next_measurement(const std::vector<Scored>& all) {
  int n = 0, k = 0;
  double random = 0;
  for (const Scored& s : all) {
    if (!is_effect(s) || s.verdict != "ambiguous" || !holds_truth(s)) continue;
    const json menu = s.diagnosis.value("next_measurement", json::array());
    if (!menu.is_array() || menu.empty() || !menu[0].contains("resolves")) continue;
    const auto resolves = [&](const json& m) {
      for (const json& name : m.value("resolves", json::array()))
        if (name == true_effect(s)) return true;
      return false;
    };
    ++n;
    k += resolves(menu[0]);
    for (const json& m : menu) random += double(resolves(m)) / double(menu.size());
  }
  Metric m = share(14, "next measurement separates the truth, as declared", k, n, 0.70, false);
  m.note = n == 0 ? "needs next_measurement[].resolves, a list of effects"
                  : "random choice of the menu: " + std::to_string(random / n);
  return m;
}

// Right, and not confidently wrong: of the effects of the library.
void add_effects(const std::vector<Scored>& all, std::vector<Metric>& list) {
  list.push_back(share_of(1, "confident and wrong, in library", all, is_effect, confidently_wrong,
                          0.03, true));
  list.push_back(share_of(2, "truth in the reported set, detectable", all, detected_effect,
                          holds_truth, 0.95));
  list.push_back(
      share_of(3, "first effect right, detectable", all, detected_effect, top_is_right, 0.85));
  list.push_back(share_of(3, "first effect right, all", all, is_effect, top_is_right, 0.75));
}

// Over the effects with a reported set at all.
Metric mean_size(const std::vector<Scored>& all) {
  double sum = 0;
  int sets = 0;
  for (const Scored& s : all)
    if (is_effect(s) && !s.named.empty()) {
      sum += double(s.named.size());
      ++sets;
    }
  return {.number = 4,
          .name = "mean size of the set",
          .value = sets ? sum / sets : 0,
          .of = sets,
          .accept = 1.6,
          .at_most = true};
}

void add_resolution_and_place(const std::vector<Scored>& all, std::vector<Metric>& list) {
  list.push_back(mean_size(all));
  list.push_back(share_of(
      4, "fully resolved, detectable", all, detected_effect,
      [](const Scored& s) { return s.verdict == "identified" && top_is_right(s); }, 0.65));
  list.push_back(share_of(
      5, "place right where the effect is", all,
      [](const Scored& s) { return is_effect(s) && top_is_right(s); }, place_is_right, 0.85));
}

void add_healthy_and_strangers(const std::vector<Scored>& all, std::vector<Metric>& list) {
  list.push_back(share_of(
      6, "false alarm without effect", all, [](const Scored& s) { return s.kind == "none"; },
      [](const Scored& s) { return s.verdict != "none"; }, 0.05, true));
  list.push_back(share_of(
      7, "abstention on strangers outside the library", all,
      [](const Scored& s) { return s.truth["outside_by_design"] == true; },
      [](const Scored& s) { return s.verdict == "unknown" || s.verdict == "none"; }, 0.90));
  list.push_back(share_of(
      8, "mimics: a look-alike is named, or none known", all,
      [](const Scored& s) {
        return s.kind == "stranger" && s.truth["outside_by_design"] == false && s.verdict != "none";
      },
      caveat_names_look_alike, 0.80));
}

void add_gaps(const std::vector<Scored>& all, std::vector<Metric>& list) {
  list.push_back(median_of(9, "held-out gap, verdict over oracle",
                           collected(all, detected_effect, against_oracle), 1.15, true));
  list.push_back(median_of(
      10, "held-out gap shrink, detectable",
      collected(all, detected_effect,
                [](const Scored& s) { return number_at(s.diagnosis, "/gap/heldout/shrink"); }),
      0.60, false));
}

// Intervals and probabilities.
void add_stated_certainty(const std::vector<Scored>& all, std::vector<Metric>& list) {
  int inside = 0, of = 0;
  for (const Scored& s : all)
    if (is_effect(s) && top_is_right(s)) count_intervals(s, inside, of);
  list.push_back(share(11, "90 % intervals hold the truth (80 to 97 %)", inside, of, 0.80, false));
  list.back().most = 0.97;
  double skill = NAN;
  list.push_back(calibration(all, skill));
  list.push_back({.number = 12,
                  .name = "Brier skill",
                  .value = std::isnan(skill) ? 0 : skill,
                  .of = std::isnan(skill) ? 0 : list.back().of,
                  .accept = 0});
}

void add_pairs(const std::vector<Scored>& all, std::vector<Metric>& list) {
  const auto pair = [](const Scored& s) { return s.kind == "pair"; };
  list.push_back(share_of(
      13, "pairs: at least one right", all, pair,
      [](const Scored& s) { return names(s, true_effect(s)) || names(s, true_effect(s, 1)); },
      0.90));
  list.push_back(share_of(
      13, "pairs: both in the set", all, pair,
      [](const Scored& s) { return names(s, true_effect(s)) && names(s, true_effect(s, 1)); },
      0.50));
}

} // namespace

std::vector<Metric> metrics_of(const std::vector<Scored>& all) {
  std::vector<Metric> list;
  add_effects(all, list);
  add_resolution_and_place(all, list);
  add_healthy_and_strangers(all, list);
  add_gaps(all, list);
  add_stated_certainty(all, list);
  add_pairs(all, list);
  list.push_back(next_measurement(all));
  list.push_back(median_of(16, "seconds a diagnosis, median",
                           collected(
                               all, [](const Scored&) { return true; }, runtime),
                           60, true));
  return list;
}

} // namespace sealed
