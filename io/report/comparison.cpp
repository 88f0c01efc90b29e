#include "io/report/markup.hpp"
#include "io/report/tables.hpp"
#include "io/tables/farthest.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

// Half the range of the strips: everything fits, and 5 % is never blown up to look like much.
double strip_range(const std::vector<MeasuredComparison>& comparison) {
  double range = 0.05;
  for (const MeasuredComparison& row : comparison) {
    const double deviation = std::abs(relative_deviation(row));
    if (std::isfinite(deviation)) range = std::max(range, deviation);
    if (row.sigma > 0 && row.measured != 0) {
      range = std::max(range, row.sigma / std::abs(row.measured));
    }
  }
  return 1.1 * range;
}

// Measured: line at zero with a bar of one sigma to either side; computed: the dot.
std::string strip(const MeasuredComparison& row, double range) {
  const double deviation = relative_deviation(row);
  if (!std::isfinite(deviation)) return "";
  const auto place = [&](double x) { return 80 + 76 * x / range; };
  std::string svg = fmt::format(
      "<svg class=\"strip\" viewBox=\"0 0 160 20\" role=\"img\" aria-label=\"computed {} % off\">"
      "<line class=\"rail\" x1=\"2\" y1=\"10\" x2=\"158\" y2=\"10\"/>",
      html_signed(100 * deviation, 1));
  if (row.sigma > 0) {
    const double half = row.sigma / std::abs(row.measured);
    svg += fmt::format("<line class=\"bar\" x1=\"{:.1f}\" y1=\"10\" x2=\"{:.1f}\" y2=\"10\"/>",
                       place(-half), place(half));
  }
  return svg + fmt::format("<line class=\"zero\" x1=\"80\" y1=\"2\" x2=\"80\" y2=\"18\"/>"
                           "<circle class=\"dot\" cx=\"{:.1f}\" cy=\"10\" r=\"4\"/></svg>",
                           place(deviation));
}

} // namespace

std::string farthest_html(const Results& results) {
  const FarthestOff found = farthest_off(results);
  const MeasuredComparison* row = found.row;
  if (!row) return "";
  const bool is_good = found.within == found.computed;
  const auto [factor, unit] = shown_unit(row->measured, row->unit);
  const int decimals = decimals_of(*row, factor);
  const std::string off =
      row->sigma > 0 ? ", " + html_signed(sigma_deviation(*row), 1) + "\u00a0σ" : "";
  std::string drawn;
  if (const std::optional<std::size_t> m = mode_that_shows(results, *row))
    drawn = fmt::format(" Drawn: mode {}, {}.", *m + 1, html_escape(mode_label(results.modes[*m])));
  return fmt::format("<p class=\"verdict{}\"><b>{}&nbsp;Farthest from the test: {}</b>, {} {} "
                     "computed, {} measured ({}\u00a0%{}); {}.{}</p>\n",
                     is_good ? "" : " open", is_good ? "✓" : "!", html_escape(row->quantity),
                     html_fixed(row->computed * factor, decimals), html_escape(unit),
                     html_fixed(row->measured * factor, decimals),
                     html_signed(100 * relative_deviation(*row), 1), off, within_words(found, "σ"),
                     drawn);
}

std::string numbers_html(const Results& results) {
  const std::map<std::string, double> numbers = headline(results);
  std::vector<HtmlRow> rows;
  for (const HeadlineQuantity& quantity : headline_quantities(results)) {
    const auto value = numbers.find(quantity.key);
    if (value == numbers.end()) continue;
    const auto [factor, unit] = shown_unit(value->second, quantity.unit);
    rows.push_back(
        {{html_escape(quantity.name), html_number(value->second * factor, 4), unit}, ""});
  }
  if (rows.empty()) return "";
  return html_table("", {{"", "", false}, {"", ""}, {"", "", false}}, rows);
}

std::string comparison_html(const Results& results) {
  if (results.comparison.empty()) return "";
  const double range = strip_range(results.comparison);
  std::vector<HtmlRow> rows;
  for (const MeasuredComparison& row : results.comparison) {
    const auto [factor, unit] = shown_unit(row.measured, row.unit);
    const int decimals = decimals_of(row, factor);
    rows.push_back(
        {{html_escape(row.quantity), html_escape(unit), html_fixed(row.measured * factor, decimals),
          row.sigma > 0 ? "±\u00a0" + html_fixed(row.sigma * factor, decimals) : "–",
          "<strong>" + html_fixed(row.computed * factor, decimals) + "</strong>",
          html_signed(100 * relative_deviation(row), 1), html_signed(sigma_deviation(row), 1),
          strip(row, range)},
         ""});
  }
  return html_table("Strip: bar = measured ± 1 σ, dot = computed, ends at ±\u00a0" +
                        html_number(100 * range, 2) + "\u00a0%.",
                    {{"quantity", "", false},
                     {"unit", "", false},
                     {"measured", ""},
                     {"1 σ", ""},
                     {"computed", ""},
                     {"deviation", "%"},
                     {"deviation", "σ"},
                     {"", "", false}},
                    rows);
}

} // namespace plica
