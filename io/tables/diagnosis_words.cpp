#include "io/tables/diagnosis_words.hpp"

#include "diagnose/effects/effect.hpp"
#include "diagnose/weigh/blocks.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

std::vector<LocatedGap> farthest_first(const Diagnosis& d, bool components) {
  std::vector<LocatedGap> list;
  for (const LocatedGap& b : d.where)
    if (b.component.empty() != components) list.push_back(b);
  std::stable_sort(list.begin(), list.end(), [](const LocatedGap& a, const LocatedGap& b) {
    return std::abs(a.z) > std::abs(b.z);
  });
  return list;
}

constexpr std::size_t shown_blocks = 12, shown_components = 6;

std::string or_dash(const std::optional<double>& x, int digits) {
  return x ? significant(*x, digits) : "-";
}

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.0f}", 100 * share) : "-";
}

// Of a size over so many powers of ten only the lower end is known: a spring that holds rigidly.
bool is_known_from_below(const EstimatedParameter& p) {
  constexpr double wide = 1e3;
  return p.interval[0] > 0 && p.interval[1] > wide * p.interval[0];
}

// A parameter as a plain sentence asks for it: "mass", "loss%", "ratio+". Where an effect has a
// size in each state, the first.
std::string value_words(const NamedEffect& e, std::string name) {
  const char form = name.back();
  if (form == '%' || form == '+') name.pop_back();
  for (const EstimatedParameter& p : e.parameters) {
    if (p.name != name && !p.name.starts_with(name + ", ")) continue;
    if (form == '%') return significant(100 * p.value, 2) + " %";
    if (form == '+') return with_sign(100 * (p.value - 1), 0) + " %";
    const bool from_below = is_known_from_below(p);
    const double value = from_below ? p.interval[0] : p.value;
    const auto [factor, unit] = handy_unit(value, p.unit);
    const std::string words = significant(rounded(factor * value, 2), 2) +
                              (unit.empty() || unit == "°" ? "" : " ") + unit;
    return from_below ? "anything from " + words + " up" : words;
  }
  return "an amount";
}

// ", 0.38 m along": of what may sit anywhere along its part.
std::string along_words(const NamedEffect& e) {
  for (const EstimatedParameter& p : e.parameters)
    if (p.name == "at") return ", " + significant(p.value, 3) + " m along";
  return "";
}

std::string where_text(const Diagnosis& d) {
  const std::vector<LocatedGap> blocks = located_blocks(d), components = located_components(d);
  const auto beyond = static_cast<std::size_t>(std::count_if(
      blocks.begin(), blocks.end(), [](const LocatedGap& b) { return b.significant; }));
  std::string text = fmt::format(
      "\nWhere: {} of {} blocks beyond admissible specimens; z > 0: the test shows more\n", beyond,
      blocks.size());
  TextRows rows;
  for (const LocatedGap& b : blocks)
    if (b.significant && rows.size() < shown_blocks)
      rows.push_back({name_of(b), with_sign(b.z, 1)});
  text += text_table(rows, "<>");
  if (beyond > rows.size()) text += fmt::format("  and {} more\n", beyond - rows.size());
  rows.clear();
  for (const LocatedGap& b : components)
    if (rows.size() < shown_components) rows.push_back({name_of(b), with_sign(b.z, 1)});
  if (!rows.empty()) text += "  by component\n" + text_table(rows, "<>");
  rows.clear();
  for (const LevelTrend& t : d.trends)
    rows.push_back({t.quantity, with_sign(t.slope, 3), "+/- " + significant(t.sigma, 2),
                    with_sign(t.best, 3)});
  if (!rows.empty())
    text += "  over the level, d ln / d ln level: the test, the model with the best hypothesis\n" +
            text_table(rows, "<>");
  return text;
}

std::string effects_text(const Diagnosis& d) {
  if (d.effects.empty()) return "";
  TextRows rows{
      {"effect", "parameter", "unit", "value", "90 % from", "to", "prior z", "probability %"}};
  for (const NamedEffect& e : d.effects) {
    std::string label = effect_label(e), odds = fmt::format("{:.1f}", 100 * e.probability);
    for (const EstimatedParameter& p : e.parameters) {
      rows.push_back({label, p.name, p.unit, significant(p.value, 4), significant(p.interval[0], 4),
                      significant(p.interval[1], 4), with_sign(p.z, 1), odds});
      label = odds = "";
    }
    if (e.parameters.empty()) rows.push_back({label, "", "", "", "", "", "", odds});
  }
  std::string text = "\nEffects (SI)\n" + text_table(rows, "<<<>");
  if (const TriedHypothesis* best = best_hypothesis(d))
    for (const std::string& reading : best->aside)
      text += "  " + reading + " does not follow " + hypothesis_label(*best) + "\n";
  return text;
}

std::string baseline_text(const Diagnosis& d) {
  if (d.baseline.readings.empty()) return "";
  TextRows rows{{"", "unit", "test", "model", "off %"}};
  for (const ComparedReading& r : d.baseline.readings)
    rows.push_back({r.name, r.unit, significant(r.measured, 5), significant(r.nominal, 5),
                    with_sign(100 * (r.kind == ReadingKind::component ? r.nominal - r.measured
                                                                      : r.nominal / r.measured - 1),
                              1)});
  std::string text = "\nBaseline: the change from it is explained\n" + text_table(rows, "<<>");
  for (const std::string& w : d.baseline.words) text += "  " + w + "\n";
  return text;
}

std::string gap_text(const Diagnosis& d) {
  TextRows rows{{"", "before", "after", "shrink %", "90 % from", "to", "readings"}};
  const auto add = [&](const std::string& name, const GapShrink& g) {
    rows.push_back({name, significant(g.before, 3), significant(g.after, 3), percent(g.shrink()),
                    percent(g.interval[0]), percent(g.interval[1]), std::to_string(g.readings)});
  };
  add("fitted", d.gap);
  if (d.held_out) add("held out: " + d.held_out_how, *d.held_out);
  const TriedHypothesis* best = best_hypothesis(d);
  return fmt::format("\nHow far{}: RMS, 1 = what measurement and scatter leave\n",
                     best ? " with " + hypothesis_label(*best) : "") +
         text_table(rows, "<>");
}

std::string compensators_text(const Diagnosis& d) {
  if (d.compensators.empty()) return "";
  TextRows rows{{"", "factor", "prior sigmas", "gap after", "held out"}};
  for (const Compensator& c : d.compensators)
    rows.push_back({c.name, significant(c.factor, 3), significant(c.prior_sigmas, 2),
                    significant(c.gap_after, 3), or_dash(c.held_out_after, 3)});
  std::string text = "\nTempting but wrong\n" + text_table(rows, "<>");
  for (const Compensator& c : d.compensators)
    if (!c.contradicted_by.empty())
      text += "  " + c.name + " is contradicted by " + c.contradicted_by + "\n";
  return text;
}

std::string next_text(const Diagnosis& d) {
  if (d.next.empty() && d.advice.empty()) return "";
  TextRows rows{{"", "about", "changes the ledger by", "hours"}};
  for (const ProposedMeasurement& m : d.next)
    rows.push_back({m.what, m.about, percent(m.change) + " %", significant(m.cost, 2)});
  std::string text = "\nNext measurement\n";
  if (!d.next.empty()) text += text_table(rows, "<<>");
  for (const std::string& a : d.advice) text += "  " + a + "\n";
  return text;
}

} // namespace

ShownUnit handy_unit(double value, const std::string& unit) {
  const double size = std::abs(value);
  if (unit == "m" && size < 1e-4) return {1e6, "µm"};
  if (unit == "m" && size < 0.1) return {1e3, "mm"};
  if (unit == "kg" && size < 0.1) return {1e3, "g"};
  if (unit == "rad") return {180 / std::numbers::pi, "°"};
  if (unit == "N/m" && size >= 1e7) return {1e-6, "MN/m"};
  return shown_unit(value, unit);
}

std::string verdict_name(Verdict verdict) {
  constexpr std::array names{"none", "identified", "ambiguous", "several", "mostly", "unknown"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::string effect_label(const NamedEffect& e) {
  return e.name + (e.place.empty() ? "" : " at " + e.place) +
         (e.way.empty() ? "" : " (" + e.way + ")");
}

std::string hypothesis_label(const TriedHypothesis& h) {
  std::string label;
  for (const NamedEffect& e : h.effects) label += (label.empty() ? "" : " and ") + effect_label(e);
  return label.empty() ? "none" : label;
}

std::string plain_words(const NamedEffect& e) {
  const std::string& plain = effect_named(e.name).plain;
  std::string text;
  for (std::size_t at = 0; at < plain.size();) {
    const std::size_t open = plain.find('{', at), close = plain.find('}', at);
    text += plain.substr(at, open - at);
    if (open == std::string::npos) break;
    text += value_words(e, plain.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return text;
}

bool is_long(const LedgerRow& row) {
  constexpr std::size_t at_a_glance = 3;
  return row.effects.size() > at_a_glance;
}

std::string row_words(const LedgerRow& row) {
  if (row.left == "measurement") return "what measuring leaves open";
  if (row.left == "mounting") return "scatter of mounting anew";
  if (row.left == "model") return "tolerances and error of the model";
  if (row.left == "unexplained") return "not explained";
  const NamedEffect& first = row.effects.front();
  const std::string words = plain_words(first) + ", at " + first.place + along_words(first) +
                            (first.way.empty() ? "" : " (" + first.way + ")");
  if (row.effects.size() == 1) return words;
  if (is_long(row))
    return words + fmt::format("; or one of {} others that the test does not tell from it",
                               row.effects.size() - 1);
  std::string text;
  for (const NamedEffect& e : row.effects)
    text += (text.empty() ? "one of: " : " or ") + effect_label(e);
  return text;
}

const TriedHypothesis* best_hypothesis(const Diagnosis& d) {
  return d.best ? &d.tried.at(*d.best) : nullptr;
}

std::vector<std::pair<std::string, double>> most_left_in(const Ledger& ledger) {
  constexpr double worth_a_word = 0.01, nothing = 0.01;
  constexpr std::size_t most = 4;
  std::vector<std::pair<std::string, double>> readings;
  for (const LedgerRow& row : ledger.rows)
    if (row.left == "unexplained" && row.share < nothing) return readings;
  for (const auto& own : ledger.left_in)
    if (own.second >= worth_a_word && readings.size() < most) readings.push_back(own);
  return readings;
}

// What is left where nothing is known of it is told in a row; small parts together.
std::string ledger_text(const Ledger& ledger) {
  constexpr double worth_a_row = 0.005;
  TextRows rows;
  for (const LedgerRow& row : ledger.rows) {
    if (row.effects.empty() && row.left != "unexplained" && std::abs(row.share) < worth_a_row)
      continue;
    std::string included;
    if (row.effects.size() == 1)
      included = fmt::format("probability {:.0f} %", 100 * row.effects.front().anywhere);
    rows.push_back({row_words(row), fmt::format("{:.0f} %", 100 * row.share),
                    fmt::format("[{:.0f}, {:.0f}]", 100 * row.interval[0], 100 * row.interval[1]),
                    included});
  }
  std::string text = fmt::format(
      "\nLedger: the gap, G = {} over {} readings (1 = what measuring and scatter leave)\n",
      significant(ledger.gap, 3), ledger.readings);
  text += text_table(rows, "<>");
  std::string readings;
  for (const auto& [reading, share] : most_left_in(ledger))
    readings += fmt::format("{}{} {:.0f} %", readings.empty() ? "" : ", ", reading, 100 * share);
  return readings.empty() ? text : text + "  what is left sits in " + readings + "\n";
}

std::vector<LocatedGap> located_blocks(const Diagnosis& d) {
  return farthest_first(d, false);
}

std::vector<LocatedGap> located_components(const Diagnosis& d) {
  return farthest_first(d, true);
}

std::string diagnosis_text(const Diagnosis& d) {
  std::string text = fmt::format("{}: {}\n", d.case_name, d.headline) + ledger_text(d.ledger) +
                     baseline_text(d) + where_text(d) + effects_text(d) + gap_text(d) +
                     compensators_text(d) + next_text(d);
  text += fmt::format("\n{} hypotheses, {} evaluations\n", d.hypotheses, d.evaluations);
  std::string without;
  for (const EffectNotTried& e : d.not_tried) without += (without.empty() ? "" : ", ") + e.name;
  if (!without.empty()) text += "not tried, as the case has no place for them: " + without + "\n";
  for (const std::string& w : d.warnings) text += "warning: " + w + "\n";
  return text;
}

} // namespace plica
