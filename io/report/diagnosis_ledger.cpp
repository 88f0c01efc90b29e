#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/report/phase.hpp"
#include "io/report/plot.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/tables/effect_words.hpp"
#include "io/tables/ledger_words.hpp"
#include "io/tables/text.hpp"

#include "diagnose/readings/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

enum class Shown { hertz, percent_of_critical, decibel, points, of_a_shape, percent };

Shown shown_as(const ComparedReading& r) {
  switch (r.kind) {
  case ReadingKind::frequency:
    return Shown::hertz;
  case ReadingKind::component:
    return Shown::of_a_shape;
  case ReadingKind::damping:
    return Shown::percent_of_critical;
  case ReadingKind::amplitude:
    return Shown::decibel;
  case ReadingKind::cross:
    return Shown::points;
  default:
    return Shown::percent;
  }
}

// Model less test, as the readings are compared: by logarithms, components of shapes as they are.
double difference(const ComparedReading& r, double model) {
  if (shown_as(r) == Shown::of_a_shape) return model - r.measured;
  const double floor = shown_as(r) == Shown::points ? cross_floor : 0;
  return std::log((model + floor) / (r.measured + floor));
}

bool within(const ComparedReading& r, double model) {
  return std::abs(difference(r, model)) <= 2 * r.sigma;
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
  case Shown::of_a_shape:
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
  case Shown::of_a_shape:
    return html_number(100 * r.sigma, 2) + "\u00a0points";
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
  if (shown == Shown::percent_of_critical || shown == Shown::points || shown == Shown::of_a_shape)
    unit = {100, "%"};
  const auto value = [&](double x) { return html_number(unit.factor * x, 4); };
  return {{html_escape(r.name) + (r.held_out ? " <b>(held out)</b>" : ""), html_escape(unit.unit),
           value(r.measured), value(r.nominal), value(r.best), r.second ? value(*r.second) : "–",
           difference_html(r, r.nominal), difference_html(r, r.best), sigma_html(r),
           within_text(r)},
          ""};
}

// Effects as their field calls them, with their numbers; of a long list the numbers of the first.
std::string fields_names(const LedgerRow& row) {
  std::string html;
  for (const NamedEffect& e : row.effects) {
    const bool told = !is_long(row) || &e == &row.effects.front();
    const std::string values = told ? values_words(e, html_number) : "";
    html += fmt::format("<span class=\"change\">{}</span>",
                        html_escape(effect_label(e) + (values.empty() ? "" : ": " + values)));
  }
  return html;
}

// From the gap of the nominal case, each row takes its share away; what is left stands.
std::string waterfall(const Ledger& ledger) {
  std::vector<HtmlRow> rows;
  double low = 0, high = 1, left = 1;
  for (const LedgerRow& row : ledger.rows) {
    left -= row.share;
    low = std::min(low, left);
    high = std::max(high, left);
  }
  const auto bar = [&](double from, double to, bool faint) {
    return bar_svg({.from = std::min(from, to),
                    .to = std::max(from, to),
                    .low = low,
                    .high = high,
                    .faint = faint,
                    .width = 9});
  };
  rows.push_back({{"the gap of the nominal case", "100", "", "", bar(0, 1, false)}, "nominal"});
  left = 1;
  for (std::size_t i = 0; i < ledger.rows.size(); ++i) {
    const LedgerRow& row = ledger.rows[i];
    const bool effect = !row.effects.empty();
    std::string name = html_escape(row_words(row));
    if (effect) name = fmt::format("<b>{}</b> {}", i + 1, name); // as the picture has it
    name += fields_names(row);
    if (!row.told_apart_by.empty())
      name += "<span class=\"change\">to tell them apart: " + html_escape(row.told_apart_by) +
              "</span>";
    rows.push_back(
        {{name, html_fixed(100 * row.share, 0), percent_range(row.interval),
          row.effects.size() == 1 ? html_fixed(100 * row.effects.front().anywhere, 0) + "\u00a0%"
                                  : "",
          bar(left, left - row.share, effect)},
         ""});
    left -= row.share;
  }
  return html_table(
      "Of the gap G, the mean of squares. Dashed: what an effect takes away when it is added to "
      "the model, averaged over "
      "the orders in which effects can be added. Solid: what is left.",
      {{"", "", false}, {"share", "%"}, {"90 %", ""}, {"probability", ""}, {"", "", false}}, rows);
}

// Curves that a plot can show.
struct MagnitudesAndPhases {
  std::vector<PlotCurve> magnitudes, phases;
};

// A test of magnitudes alone has no phase.
MagnitudesAndPhases curves_of(const OverlaidResponse& r) {
  MagnitudesAndPhases curves;
  const auto add = [&](const Eigen::VectorXcd& H, const char* name, int dashes, bool faint) {
    if (H.size() != r.hertz.size() || H.size() < 2 || !H.allFinite()) return;
    curves.magnitudes.push_back({.x = r.hertz,
                                 .y = H.cwiseAbs(),
                                 .name = name,
                                 .colour = int(curves.magnitudes.size()),
                                 .dashes = dashes,
                                 .faint = faint});
    if (!H.imag().isZero(0))
      curves.phases.push_back(phase_curve(curves.magnitudes.back(), H.cwiseArg()));
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

std::string ledger_html(const Diagnosis& d) {
  if (d.ledger.rows.empty()) return "";
  std::string html = "<div class=\"answer\">\n<div>" + waterfall(d.ledger) + "</div>\n" +
                     place_html(d) + "</div>\n";
  std::vector<std::string> readings;
  for (const auto& [reading, share] : most_left_in(d.ledger))
    readings.push_back(fmt::format("{}: {:.0f} % of the gap", reading, 100 * share));
  if (!readings.empty()) html += "<p>What is left sits in:</p>\n" + html_list(readings);
  if (!d.next.empty())
    html += "<p>To measure next: " + html_escape(d.next.front().what) + " (about " +
            html_escape(d.next.front().about) + ").</p>\n";
  return html;
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
      "Gap: RMS of the differences over their uncertainty, the root of G of the ledger; 1 = what "
      "measurement and the scatter of admissible specimens leave. Shrink: 1 − after / before; "
      "held out is what counts.",
      {{"readings", "", false},
       {"", "number"},
       {"gap before", ""},
       {"gap after", ""},
       {"shrink", "%"},
       {"90 %", ""}},
      rows);
  if (!d.held_out)
    html += "<p>Nothing is held out: the shrink is that of the fitted readings.</p>\n";
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
    const auto [magnitudes, phases] = curves_of(r);
    if (magnitudes.empty()) continue;
    const PlotFrame frame{.label = "test and models, " + r.name,
                          .ordinate = "acceleration over that of the base"};
    html += "<h3>" + html_escape(r.name) + "</h3>\n" + plot_figure(frame, magnitudes) +
            phase_figure(frame, phases) + plot_legend(magnitudes);
  }
  return html;
}

} // namespace plica
