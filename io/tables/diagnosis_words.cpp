#include "io/tables/diagnosis_words.hpp"

#include "diagnose/weigh/blocks.hpp"
#include "io/tables/effect_words.hpp"
#include "io/tables/ledger_words.hpp"
#include "io/tables/located_gaps.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

constexpr std::size_t shown_blocks = 12, shown_components = 6;

std::string or_dash(const std::optional<double>& x, int digits) {
  return x ? significant(*x, digits) : "-";
}

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.0f}", 100 * share) : "-";
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

std::string verdict_name(Verdict verdict) {
  constexpr std::array names{"none", "identified", "ambiguous", "several", "mostly", "unknown"};
  return names.at(static_cast<std::size_t>(verdict));
}

const TriedHypothesis* best_hypothesis(const Diagnosis& d) {
  return d.best ? &d.tried.at(*d.best) : nullptr;
}

std::string diagnosis_text(const Diagnosis& d) {
  std::string text = first_screen_text(d) + "\nEvidence: " + d.headline + "\n" + baseline_text(d) +
                     where_text(d) + effects_text(d) + gap_text(d) + compensators_text(d) +
                     next_text(d);
  text += fmt::format("\n{} hypotheses, {} evaluations\n", d.hypotheses, d.evaluations);
  std::string without;
  for (const EffectNotTried& e : d.not_tried) without += (without.empty() ? "" : ", ") + e.name;
  if (!without.empty())
    text += "not tried, as the case or the test has not what they need: " + without + "\n";
  for (const std::string& w : d.warnings) text += "warning: " + w + "\n";
  return text;
}

} // namespace plica
