#include "io/report/markup.hpp"
#include "io/report/tables.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {

std::string error_bars_html(const Results& results) {
  const ErrorBars& errors = results.error_bars;
  if (errors.bars.empty()) return "";
  const bool tolerances = !errors.tolerances.empty();
  std::vector<HtmlColumn> columns{{"quantity", "", false},
                                  {"unit", "", false},
                                  {"computed", ""},
                                  {"mesh, along", "%"},
                                  {"mesh, around", "%"}};
  const bool reduced = results.reduced.has_value();
  if (reduced) columns.push_back({"cut-off of the superelements", "%"});
  if (tolerances) {
    columns.push_back({"90 % interval", ""});
    columns.push_back({"shares of the variance", "", false});
  }
  std::vector<HtmlRow> rows;
  for (const HeadlineQuantity& quantity : headline_quantities(results))
    for (const ErrorBar& bar : errors.bars) {
      if (bar.key != quantity.key) continue;
      const auto [factor, unit] = shown_unit(bar.value, quantity.unit);
      HtmlRow row{{html_escape(quantity.name), unit, html_number(bar.value * factor, 4),
                   errors.along ? html_signed(100 * bar.mesh.along / bar.value, 2) : "–",
                   errors.around ? html_signed(100 * bar.mesh.around / bar.value, 2) : "–"},
                  ""};
      if (reduced) row.cells.push_back(html_signed(100 * bar.mesh.cutoff / bar.value, 2));
      if (tolerances && bar.interval) {
        row.cells.push_back(html_number((*bar.interval)[0] * factor, 3) + " to " +
                            html_number((*bar.interval)[1] * factor, 3));
        row.cells.push_back(html_escape(shares_text(errors, bar)));
      }
      rows.push_back(std::move(row));
    }
  std::string note = "Mesh: what the converged value would differ by, estimated from two further "
                     "meshes, one finer along the meridian and one around. ";
  if (reduced)
    note += "Cut-off: what more modes of every superelement change, up to twice the "
            "cut-off and to four times the highest mode. ";
  if (tolerances)
    note += fmt::format("Interval: from the tolerances stated in the case, effects added; with all "
                        "of them drawn at random one run differed from the sum by {} %.",
                        html_number(100 * errors.interaction, 2));
  return html_table(note, columns, rows);
}

} // namespace plica
