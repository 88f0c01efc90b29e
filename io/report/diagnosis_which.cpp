#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/tables/diagnosis_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

std::string join(const std::vector<std::string>& blocks) {
  std::string html;
  for (const std::string& block : blocks) html += block;
  return html;
}

std::string in_lines(const std::vector<std::string>& lines) {
  std::string html;
  for (const std::string& line : lines) html += (html.empty() ? "" : "<br>") + line;
  return html;
}

HtmlRow row_of(const TriedHypothesis& h, bool best) {
  std::vector<std::string> names, values, distances;
  for (const NamedEffect& e : h.effects) {
    names.push_back(html_escape(e.name) + "<span class=\"change\">" +
                    html_escape(e.place + (e.way.empty() ? "" : " (" + e.way + ")")) + "</span>");
    for (const EstimatedParameter& p : e.parameters) {
      values.push_back("<span class=\"line\">" + html_escape(p.name) + " " + estimate_html(p) +
                       "</span>");
      distances.push_back(html_fixed(std::abs(p.z), 1));
    }
  }
  std::string bayes = html_signed(h.log_bayes_factor, 1);
  bayes += fmt::format("<span class=\"change\">{}; {}</span>", html_signed(h.half_width, 1),
                       html_signed(h.double_width, 1));
  if (h.effects.empty()) {
    names = {"none<span class=\"change\">nominal case</span>"};
    bayes = "0";
  }
  std::string remarks = html_escape(h.rejected);
  for (const std::string& reading : h.aside)
    remarks += (remarks.empty() ? "" : "; ") + html_escape(reading) + " does not follow";
  HtmlRow row{{join(names), in_lines(values), in_lines(distances), bayes,
               html_number(h.share_of_healthy_worse, 2) + (h.adequate ? "" : " ✗"),
               html_number(h.gap_after, 3),
               html_number(h.held_out_after, 3) + (h.fails_held_out ? " ✗" : ""), remarks},
              best ? "nominal" : ""};
  if (h.rejected.empty()) return row;
  for (std::string& cell : row.cells)
    if (!cell.empty()) cell = fmt::format("<span style=\"color:var(--muted)\">{}</span>", cell);
  return row;
}

std::string probabilities_of(const Weighing& weighing) {
  const auto over = [&] {
    switch (weighing.over) {
    case Weighing::Over::singles:
      return "Of each effect and of none, were one of them all there is";
    case Weighing::Over::standing_sets:
      return "Of each effect, over the sets that explain the test";
    case Weighing::Over::all_sets:
      return "Of each effect, averaged over all sets that were tried";
    }
    return "";
  };
  return std::string(over()) +
         (weighing.limited ? ", and no more than the share of the gap that what leads closes."
                           : ".");
}

constexpr double worth_showing = 0.005; // of a probability

// Where an effect most probably sits: "bellows.convolution[3] 61 %, ...".
std::string places_html(const Diagnosis& d, const std::string& effect) {
  constexpr std::size_t most = 3;
  std::string html;
  for (const EffectInclusion& e : d.inclusion) {
    if (e.effect != effect) continue;
    for (std::size_t i = 0; i < std::min(most, e.places.size()); ++i)
      if (const auto& [place, p] = e.places[i]; p >= worth_showing)
        html += fmt::format("{}{} {}\u00a0%", html.empty() ? "" : ", ", html_escape(place),
                            html_fixed(100 * p, 1));
  }
  return html;
}

// "÷ 28", "× 1.4"
std::string factor_html(double factor) {
  return factor > 0 && factor < 1 ? "÷\u00a0" + html_number(1 / factor, 3)
                                  : "×\u00a0" + html_number(factor, 3);
}

} // namespace

std::string hypotheses_html(const Diagnosis& d) {
  const TriedHypothesis* best = d.verdict == Verdict::none ? nullptr : best_hypothesis(d);
  std::vector<HtmlRow> rows;
  for (const TriedHypothesis& h : d.tried) rows.push_back(row_of(h, &h == best));
  if (rows.empty()) return "";
  return html_table(
      "The best place of each effect, then sets of several. |z|: distance of a value from the "
      "centre of its "
      "prior; above 3 is absurd. ln BF over the nominal case; below it with priors half and twice "
      "as wide. p: share of admissible specimens that fit no better; ✗ = not adequate. Gap: RMS of "
      "the differences over their uncertainty. Grey: rejected.",
      {{"effect", "place", false},
       {"value", "90 %", false},
       {"|z|", ""},
       {"ln BF", ""},
       {"p", ""},
       {"gap, fitted", ""},
       {"gap, held out", ""},
       {"rejected because, remarks", "", false}},
      rows);
}

std::string probabilities_html(const Diagnosis& d) {
  std::vector<std::pair<std::string, double>> list = d.probabilities;
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<HtmlRow> rows;
  int others = 0;
  double rest = 0;
  for (const auto& [name, p] : list) {
    if (p < worth_showing) {
      ++others;
      rest += p;
      continue;
    }
    rows.push_back({{html_escape(name), html_fixed(100 * p, 1),
                     bar_svg({.from = 0, .to = p, .mark = 0, .width = 16}), places_html(d, name)},
                    ""});
  }
  if (list.empty()) return "";
  if (others > 0)
    rows.push_back(
        {{fmt::format("{} below 0.5 %", others), html_fixed(100 * rest, 1), "", ""}, "total"});
  return "<h3>Probabilities</h3>\n" +
         html_table(probabilities_of(d.weighing),
                    {{"effect", "", false}, {"", "%"}, {"", "", false}, {"at", "", false}}, rows);
}

std::string compensators_html(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  for (const Compensator& c : d.compensators)
    rows.push_back({{html_escape(c.name), factor_html(c.factor), html_number(c.prior_sigmas, 2),
                     html_number(c.gap_after, 3), html_number(c.held_out_after, 3),
                     html_escape(c.contradicted_by)},
                    ""});
  if (rows.empty()) return "";
  return html_table(
      fmt::format(
          "Parameters that would close the gap and are not its cause. It is {} before{} (RMS).",
          html_number(d.gap.before, 3),
          d.held_out ? fmt::format(", {} held out", html_number(d.held_out->before, 3)) : ""),
      {{"parameter", "", false},
       {"on its nominal value", ""},
       {"off its prior", "sigma"},
       {"gap, fitted", ""},
       {"gap, held out", ""},
       {"contradicted by", "", false}},
      rows);
}

} // namespace plica
