#include "io/report/diagnosis_parts.hpp"
#include "io/report/markup.hpp"
#include "io/report/plot.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/tables/text.hpp"

#include "diagnose/readings/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

enum class Shown { hertz, percent_of_critical, decibel, points, percent };

// How a reading is shown; the kinds by the names that readings.cpp gives them.
Shown shown_as(const ComparedReading& r) {
  if (r.unit == "Hz") return Shown::hertz;
  if (r.name.starts_with("damping")) return Shown::percent_of_critical;
  if (r.name.starts_with("amplitude")) return Shown::decibel;
  return r.name.starts_with("share in") ? Shown::points : Shown::percent;
}

// Model over test, as the readings are compared.
double log_difference(const ComparedReading& r, double model) {
  const double floor = shown_as(r) == Shown::points ? cross_floor : 0;
  return std::log((model + floor) / (r.measured + floor));
}

bool within(const ComparedReading& r, double model) {
  return std::abs(log_difference(r, model)) <= 2 * r.sigma;
}

std::string percent(double share) {
  return html_signed(100 * share, 1) + "\u00a0%";
}

std::string difference_html(const ComparedReading& r, double model) {
  if (!std::isfinite(model)) return "–";
  const double ratio = model / r.measured - 1;
  switch (shown_as(r)) {
  case Shown::hertz:
    return fmt::format("{}\u00a0Hz<span class=\"change\">{}</span>",
                       html_signed(model - r.measured, r.measured < 10 ? 2 : 1), percent(ratio));
  case Shown::decibel:
    return html_signed(20 * std::log10(model / r.measured), 1) + "\u00a0dB";
  case Shown::points:
    return html_signed(100 * (model - r.measured), 1) + "\u00a0points";
  default:
    return percent(ratio);
  }
}

std::string sigma_html(const ComparedReading& r) {
  switch (shown_as(r)) {
  case Shown::hertz:
    return html_number(r.sigma * r.measured, 2) + "\u00a0Hz";
  case Shown::decibel:
    return html_number(20 / std::log(10.) * r.sigma, 2) + "\u00a0dB";
  case Shown::points:
    return html_number(100 * r.sigma * (r.measured + cross_floor), 2) + "\u00a0points";
  default:
    return html_number(100 * r.sigma, 2) + "\u00a0%";
  }
}

std::string within_text(const ComparedReading& r) {
  if (!std::isfinite(r.best)) return "not given";
  const bool before = within(r, r.nominal), after = within(r, r.best);
  if (before && after) return "before and after";
  if (after) return "after";
  return before ? "before only" : "no";
}

HtmlRow row_of(const ComparedReading& r) {
  const Shown shown = shown_as(r);
  ShownUnit unit = shown_unit(r.measured, r.unit);
  if (shown == Shown::percent_of_critical || shown == Shown::points) unit = {100, "%"};
  const auto value = [&](double x) { return html_number(unit.factor * x, 4); };
  return {{html_escape(r.name) + (r.held_out ? " <b>(held out)</b>" : ""), html_escape(unit.unit),
           value(r.measured), value(r.nominal), value(r.best), r.second ? value(*r.second) : "–",
           difference_html(r, r.nominal), difference_html(r, r.best), sigma_html(r),
           within_text(r)},
          ""};
}

// A step of the waterfall: what goes, or what stands.
struct Step {
  std::string name;
  double from = 0, to = 0;
};

// From the nominal case over the best effect, of a pair the first one alone before both.
std::vector<Step> steps(const Diagnosis& d, const GapShrink& gap, bool held_out) {
  std::vector<Step> list{
      {held_out ? "held out: nominal case" : "fitted: nominal case", 0, gap.before}};
  const TriedHypothesis* best = best_hypothesis(d);
  double left = gap.before;
  if (best && best->effects.size() > 1)
    for (const TriedHypothesis& h : d.tried) {
      const std::optional<double> alone =
          held_out ? h.held_out_after : std::optional<double>(h.gap_after);
      if (h.effects.size() != 1 || !alone ||
          effect_label(h.effects.front()) != effect_label(best->effects.front()))
        continue;
      list.push_back({effect_label(h.effects.front()), left, *alone});
      left = *alone;
      break;
    }
  const bool split = left != gap.before;
  if (best)
    list.push_back(
        {split ? effect_label(best->effects.back()) : hypothesis_label(*best), left, gap.after});
  list.push_back({"remains", 0, gap.after});
  return list;
}

std::string waterfall(const Diagnosis& d) {
  std::vector<Step> all = steps(d, d.gap, false);
  if (d.held_out)
    for (Step& step : steps(d, *d.held_out, true)) all.push_back(std::move(step));
  double high = 1.1;
  for (const Step& s : all) high = std::max({high, s.from, s.to});
  std::vector<HtmlRow> rows;
  for (const Step& s : all) {
    const bool goes = s.from != 0;
    rows.push_back(
        {{html_escape(s.name), goes ? html_signed(s.to - s.from, 2) : html_fixed(s.to, 2),
          bar_svg({.from = std::min(s.from, s.to),
                   .to = std::max(s.from, s.to),
                   .low = 0,
                   .high = high,
                   .mark = 1,
                   .faint = goes,
                   .width = 24})},
         goes ? "" : "nominal"});
  }
  return html_table("Upright line: 1, what measurement and scatter leave. Dashed: what the effect "
                    "takes away.",
                    {{"", "", false}, {"G", ""}, {"", "", false}}, rows);
}

// Curves that a plot can show.
std::vector<PlotCurve> curves_of(const OverlaidResponse& r) {
  std::vector<PlotCurve> curves;
  const auto add = [&](const Eigen::VectorXd& magnitude, const char* name, int dashes, bool faint) {
    if (magnitude.size() == r.hertz.size() && magnitude.size() > 1 && magnitude.allFinite())
      curves.push_back({.hertz = r.hertz,
                        .magnitude = magnitude,
                        .name = name,
                        .dashes = dashes,
                        .faint = faint});
  };
  add(r.measured, "test", 0, false);
  add(r.nominal, "nominal", 2, false);
  add(r.best, "best", 1, false);
  add(r.second, "second best", 3, true);
  return curves;
}

} // namespace

std::array<int, 2> readings_within(const Diagnosis& d) {
  std::array<int, 2> count{};
  for (const ComparedReading& r : d.readings) {
    count[0] += within(r, r.nominal) ? 1 : 0;
    count[1] += within(r, r.best) ? 1 : 0;
  }
  return count;
}

std::string shrink_html(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  const auto add = [&](const std::string& name, const GapShrink& g) {
    rows.push_back(
        {{name, std::to_string(g.readings), html_fixed(g.before, 2), html_fixed(g.after, 2),
          html_fixed(100 * g.shrink(), 0), percent_range(g.interval)},
         ""});
  };
  add("fitted", d.gap);
  if (d.held_out) add("held out: " + html_escape(d.held_out_how), *d.held_out);
  std::string html = html_table(
      "G: RMS of the differences over their uncertainty; 1 = what measurement and the scatter of "
      "admissible specimens leave. Shrink: 1 − after / before; held out is what counts.",
      {{"readings", "", false},
       {"", "number"},
       {"G before", ""},
       {"G after", ""},
       {"shrink", "%"},
       {"90 %", ""}},
      rows);
  if (!d.held_out)
    html += "<p>Nothing is held out: the shrink is that of the fitted readings.</p>\n";
  html += waterfall(d);
  if (const TriedHypothesis* best = best_hypothesis(d); best && !best->worst_block.empty())
    html += fmt::format("<p>Least met by {}: {}, z {}.</p>\n", html_escape(hypothesis_label(*best)),
                        html_escape(best->worst_block), html_signed(best->worst_block_z, 1));
  return html;
}

std::string readings_html(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  for (const ComparedReading& r : d.readings) rows.push_back(row_of(r));
  if (rows.empty()) return "";
  return html_table("Differences: model less test. Sigma: of all uncertainties. Within: the "
                    "difference is at most two sigma.",
                    {{"reading", "", false},
                     {"unit", "", false},
                     {"test", ""},
                     {"nominal", ""},
                     {"best", ""},
                     {"second", ""},
                     {"difference before", ""},
                     {"after", ""},
                     {"sigma", ""},
                     {"within uncertainty", "", false}},
                    rows);
}

std::string baseline_html(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  for (const ComparedReading& r : d.baseline.readings) {
    HtmlRow row = row_of(r);
    row.cells = {row.cells[0], row.cells[1], row.cells[2],
                 row.cells[3], row.cells[6], row.cells[8]};
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return "";
  return html_table("What is looked for was not there: the model's own error. What is explained is "
                    "the change from here. Sigma: of all uncertainties, this error among them.",
                    {{"reading", "", false},
                     {"unit", "", false},
                     {"test", ""},
                     {"model", ""},
                     {"difference", ""},
                     {"sigma", ""}},
                    rows) +
         html_list(d.baseline.words);
}

std::string overlays_html(const Diagnosis& d) {
  std::string html;
  for (const OverlaidResponse& r : d.overlays) {
    const std::vector<PlotCurve> curves = curves_of(r);
    if (curves.empty()) continue;
    html +=
        "<h3>" + html_escape(r.name) + "</h3>\n" +
        plot_figure("test and models, " + r.name, "acceleration over that of the base", curves) +
        plot_legend(curves);
  }
  return html;
}

} // namespace plica
