#include "io/report/diagnosis.hpp"

#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/tables/effect_words.hpp"
#include "io/tables/ledger_words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

const char* verdict_words(const Diagnosis& d) {
  switch (d.verdict) {
  case Verdict::none:
    return "none: the nominal case explains the test";
  case Verdict::identified:
    return "identified: one effect explains the test";
  case Verdict::ambiguous:
    return d.effects.size() == 1
               ? "ambiguous: one effect leads, but these data do not make it sure"
               : "ambiguous: several effects explain the test, these data do not tell them apart";
  case Verdict::several:
    return "several: these effects together explain the test";
  case Verdict::mostly:
    return "mostly: this closes at least half of the gap, what remains is not explained";
  default:
    return "unknown: nothing that is known here stands out as the cause";
  }
}

// In words that need no knowledge of effects and odds; those stand in short, below.
std::string banner(const Diagnosis& d) {
  const bool open = d.verdict == Verdict::ambiguous || d.verdict == Verdict::unknown;
  return fmt::format("<p class=\"verdict{}\"><b>{}&nbsp;{}</b></p>\n", open ? " open" : "",
                     open ? "!" : "✓", html_escape(plain_verdict(d)));
}

std::string shrink_text(const GapShrink& g, bool nominal) {
  if (nominal) return fmt::format("{}, {} readings", html_fixed(g.before, 2), g.readings);
  return fmt::format("{} % ({}), from {} to {}, {} readings", html_fixed(100 * g.shrink(), 0),
                     percent_range(g.interval), html_fixed(g.before, 2), html_fixed(g.after, 2),
                     g.readings);
}

// Where else it explains the test: of the many spots of a wall the first, as how far they reach is
// told beside.
std::string elsewhere(const NamedEffect& e) {
  constexpr std::size_t most_spots = 5;
  const std::size_t all = e.other_places.size(), shown = e.within ? std::min(most_spots, all) : all;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
    text += (i == 0 ? "; or at " : ", ") + html_escape(e.other_places[i]);
  return shown < all ? text + fmt::format(" and {} more", all - shown) : text;
}

std::string facts(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  const auto add = [&](const std::string& name, const std::string& value) {
    rows.push_back({{name, value}, ""});
  };
  add("verdict", verdict_words(d));
  add("evidence", html_escape(d.headline));
  for (const NamedEffect& e : d.effects) {
    std::string value = html_escape(effect_label(e));
    for (const EstimatedParameter& p : e.parameters)
      value += "; " + html_escape(p.name) + " " + estimate_html(p);
    value += elsewhere(e);
    add("effect, place, value (90 %)",
        fmt::format("{}; probability {} %", value, html_fixed(100 * e.probability, 1)));
  }
  if (d.resonator)
    add("no effect here",
        fmt::format("a mass on a spring of its own, at {}: {}; it leaves a gap of {}",
                    html_escape(d.resonator->found.place),
                    values_words(d.resonator->found, html_number),
                    html_fixed(d.resonator->gap_after, 2)));
  const TriedHypothesis* best = best_hypothesis(d);
  if (d.effects.empty() && best)
    add("best of what was tried", html_escape(hypothesis_label(*best)) +
                                      (best->rejected.empty() ? "" : "; rejected: ") +
                                      html_escape(best->rejected));
  const bool nominal = d.verdict == Verdict::none;
  const std::string head = nominal ? "gap (root of G)" : "gap (root of G) shrinks by";
  add(head + ", fitted", shrink_text(d.gap, nominal));
  add(head + ", held out",
      d.held_out ? shrink_text(*d.held_out, nominal) + "; " + html_escape(d.held_out_how)
                 : "nothing is held out");
  const std::array<int, 2> within = readings_within(d);
  add("within uncertainty", fmt::format("{} of {} readings before, {} after (two sigma)", within[0],
                                        d.readings.size(), within[1]));
  add("tried", fmt::format("{} hypotheses, {} evaluations, {} s", d.hypotheses, d.evaluations,
                           html_number(d.seconds, 2)));
  if (!d.warnings.empty())
    add("warnings", fmt::format("<a href=\"#warnings\">{}, at the end</a>", d.warnings.size()));
  return html_table("", {{"", "", false}, {"", "", false}}, rows);
}

std::string assumptions(const Diagnosis& d) {
  std::vector<std::string> lines = d.assumptions;
  for (const EffectNotTried& e : d.not_tried)
    lines.push_back("not tried: " + e.name + "; the case has no place for it, which is " + e.needs);
  return html_list(lines) +
         fmt::format(
             "<p>Hypotheses are tried on a reduced model; of a frequency of the best one it "
             "is off by {}.</p>\n",
             std::isfinite(d.basis_error) ? html_number(100 * d.basis_error, 2) + " %"
                                          : "nobody knows how much: the changed structure is "
                                            "barely stable");
}

} // namespace

std::string diagnosis_html(const Diagnosis& d, const std::string& title) {
  std::string sections = banner(d);
  sections += html_section("ledger", "What the gap is made of", ledger_html(d));
  sections += html_section("facts", "In short", facts(d));
  sections += html_section("baseline", "Baseline", baseline_html(d));
  sections += html_section("where", "Where the gap lies",
                           blocks_html(d) + components_html(d) + trends_html(d));
  sections += html_section("which", "Which effect", hypotheses_html(d) + probabilities_html(d));
  sections += html_section("tempting", "Tempting but wrong", compensators_html(d));
  sections += html_section("gap", "How far the gap shrinks", shrink_html(d));
  sections += html_section("readings", "Readings", readings_html(d));
  sections +=
      html_section("responses", "Test beside models", overlays_html(d) + posteriors_html(d));
  sections += html_section("likeness", "What this test can tell apart",
                           likeness_html(d) + detectable_html(d));
  sections += html_section("next", "Next measurement", next_html(d));
  sections += html_section("assumptions", "Assumptions", assumptions(d));
  sections += html_section("warnings", "Warnings", html_list(d.warnings));
  return report_page(title + ": diagnosis", html_escape(d.case_name) + ": test beside model", {},
                     sections);
}

} // namespace plica
