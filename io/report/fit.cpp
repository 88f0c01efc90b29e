#include "io/report/fit.hpp"

#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/tables/fit_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::string parameters_table(const FitResult& fit) {
  std::vector<HtmlRow> rows;
  for (const FittedParameter& p : fit.parameters)
    rows.push_back({{html_escape(p.path), html_escape(p.unit), html_number(p.start, 4),
                     html_number(p.value, 5), html_number(p.sigma, 2), html_fixed(100 * p.known, 0),
                     p.at_bound ? "at its bound" : ""},
                    ""});
  for (const auto& [path, value, unit] : fit.ties)
    rows.push_back(
        {{html_escape(path), html_escape(unit), "–", html_number(value, 5), "–", "–", "follows"},
         ""});
  return html_table("Known: share of the width of the bounds that the data remove.",
                    {{"number of the case", "", false},
                     {"unit", "", false},
                     {"before", ""},
                     {"after", ""},
                     {"+/-", ""},
                     {"known", "%"},
                     {"", "", false}},
                    rows);
}

std::string targets_table(const FitResult& fit) {
  std::vector<HtmlRow> rows;
  for (const FittedTarget& t : fit.targets)
    rows.push_back({{html_escape(t.quantity) + (t.held_out ? " (held out)"
                                                : t.goal   ? " (goal)"
                                                           : ""),
                     html_escape(t.unit), html_number(t.measured, 5), html_number(t.sigma, 2),
                     html_number(t.start, 5), html_number(t.value, 5),
                     html_signed(100 * (t.value / t.measured - 1), 2),
                     html_signed((t.value - t.measured) / t.sigma, 1)},
                    ""});
  for (const FittedResponse& r : fit.responses)
    rows.push_back({{html_escape(r.name) + fmt::format(" ({} lines)", r.lines), "dB RMS", "–", "",
                     html_number(r.start, 3), html_number(r.value, 3), "", ""},
                    ""});
  for (const FittedStiffness& s : fit.stiffness)
    rows.push_back({{html_escape(s.name) + fmt::format(" ({} numbers)", s.numbers) +
                         (s.held_out ? " (held out)" : ""),
                     "% RMS of the magnitude", "–", html_number(100 * s.sigma, 2),
                     html_number(100 * s.start, 3), html_number(100 * s.value, 3), "",
                     html_number(s.value / s.sigma, 2)},
                    ""});
  for (const FittedAim& a : fit.aims)
    rows.push_back({{html_escape(a.quantity) + (a.least ? " (least)" : " (most)"),
                     html_escape(a.unit), "", "", html_number(a.start, 5), html_number(a.value, 5),
                     html_signed(100 * (a.value / a.start - 1), 2), ""},
                    ""});
  for (const FittedConstraint& c : fit.constraints)
    rows.push_back({{html_escape(c.name) + " (limit)", html_escape(c.unit), constraint_limits(c),
                     "", "", html_number(c.value, 5), "", ""},
                    ""});
  return html_table("",
                    {{"", "", false},
                     {"unit", "", false},
                     {"test", ""},
                     {"+/-", ""},
                     {"before", ""},
                     {"after", ""},
                     {"difference", "%"},
                     {"", "sigma"}},
                    rows);
}

std::string correlation_table(const FitResult& fit) {
  if (fit.parameters.size() < 2) return "";
  std::vector<HtmlColumn> columns{{"", "", false}};
  for (std::size_t i = 0; i < fit.parameters.size(); ++i)
    columns.push_back({std::to_string(i + 1), ""});
  std::vector<HtmlRow> rows;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    HtmlRow row{{fmt::format("{} {}", i + 1, html_escape(fit.parameters[i].path))}, ""};
    for (std::size_t j = 0; j < fit.parameters.size(); ++j)
      row.cells.push_back(html_fixed(fit.correlation(Index(i), Index(j)), 2));
    rows.push_back(std::move(row));
  }
  return html_table("Near 1 or −1: the data know a combination of the two, not each.", columns,
                    rows);
}

std::string open_section(const FitResult& fit) {
  std::vector<std::string> lines;
  for (const OpenDirection& o : fit.open) lines.push_back(open_text(o));
  return html_list(lines);
}

std::string islands_table(const FitResult& fit) {
  std::vector<HtmlRow> rows;
  for (const Island& i : fit.islands)
    rows.push_back(
        {{html_escape(i.strategy), html_number(i.cost, 4), std::to_string(i.improvements)}, ""});
  if (rows.empty()) return "";
  return html_table("Half the sum of squares of the best design of each island.",
                    {{"strategy", "", false}, {"cost", ""}, {"rounds it led", ""}}, rows);
}

// One panel of dots, dark for good designs.
struct Panel {
  double x = 0, y = 0, size = 0;
};

std::string dots(const Panel& at, const std::vector<std::array<double, 3>>& points) {
  double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
  for (const auto& [x, y, rank] : points) {
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
    low_y = std::min(low_y, y);
    high_y = std::max(high_y, y);
  }
  const double width = high_x > low_x ? high_x - low_x : 1,
               height = high_y > low_y ? high_y - low_y : 1;
  std::string svg = fmt::format("<rect x='{:.0f}' y='{:.0f}' width='{:.0f}' height='{:.0f}' "
                                "fill='none' stroke='currentColor' stroke-opacity='0.3'/>",
                                at.x, at.y, at.size, at.size);
  for (const auto& [x, y, rank] : points)
    svg +=
        fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='1.6' fill='currentColor' "
                    "fill-opacity='{:.2f}'/>",
                    at.x + 3 + (at.size - 6) * (x - low_x) / width,
                    at.y + at.size - 3 - (at.size - 6) * (y - low_y) / height, 0.08 + 0.6 * rank);
  return svg;
}

// Every parameter against every target and the cost, over designs that were tried: dark = good.
std::string scatter_plots(const FitResult& fit) {
  constexpr std::size_t most_points = 300;
  if (fit.samples.size() < 30) return "";
  std::vector<std::size_t> order(fit.samples.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return fit.samples[a].cost < fit.samples[b].cost;
  });
  const std::size_t good = std::max<std::size_t>(30, order.size() / 2); // far ones squeeze the rest
  const std::size_t stride = std::max<std::size_t>(1, good / most_points);
  const MatrixXd ranks = rank_correlation(fit);
  const std::size_t rows = fit.targets.size() + 1, columns = fit.parameters.size();
  constexpr double size = 120, left = 150, top = 20;
  std::string svg;
  for (std::size_t r = 0; r < rows; ++r) {
    const bool is_cost = r + 1 == rows;
    const double y = top + double(r) * (size + 26);
    svg += fmt::format("<text x='0' y='{:.0f}'>{}</text>", y + size / 2,
                       html_escape(is_cost ? "log10 of cost" : fit.targets[r].quantity));
    for (std::size_t c = 0; c < columns; ++c) {
      std::vector<std::array<double, 3>> points;
      for (std::size_t k = 0; k < good && k < order.size(); k += stride) {
        const FitSample& s = fit.samples[order[k]];
        const double value = is_cost ? std::log10(std::max(1e-12, s.cost)) : s.targets[Index(r)];
        points.push_back({s.design[Index(c)], value, 1 - double(k) / double(good)});
      }
      const double x = left + double(c) * (size + 14);
      svg += dots({x, y, size}, points);
      svg += fmt::format("<text x='{:.0f}' y='{:.0f}'>{} : {}</text>", x, y + size + 14, c + 1,
                         html_fixed(ranks(Index(c), Index(r)), 2));
    }
  }
  const double width = left + double(columns) * (size + 14),
               height = top + double(rows) * (size + 26);
  return fmt::format("<p>Designs that were tried, the better half, dark = good. Below each panel: "
                     "number of the parameter and its rank correlation over all designs.</p>\n"
                     "<div class='wide'><svg class='scatter' viewBox='0 0 {0:.0f} {1:.0f}' "
                     "width='{0:.0f}' height='{1:.0f}' "
                     "role='img' aria-label='designs that were tried' font-size='12' "
                     "fill='currentColor'>{2}</svg></div>\n",
                     width, height, svg);
}

} // namespace

std::string fit_html(const FitResult& fit, const std::string& title) {
  std::string sections = html_section("parameters", "Parameters", parameters_table(fit));
  sections += html_section("targets", "Targets", targets_table(fit));
  sections += html_section("open", "What the data leave open", open_section(fit));
  sections += html_section("correlation", "Correlation of the parameters", correlation_table(fit));
  sections += html_section("islands", "Strategies of the search", islands_table(fit));
  sections += html_section("designs", "Designs", scatter_plots(fit));
  const std::string lead =
      fmt::format("Half the sum of squares {} before, {} after, {} evaluations.",
                  html_number(fit.start_cost, 4), html_number(fit.cost, 4), fit.evaluations);
  return report_page(title + ": fit", lead, fit.warnings, sections);
}

} // namespace plica
