#include "io/report/correlation.hpp"

#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/report/phase.hpp"
#include "io/report/plot.hpp"
#include "io/tables/correlation_words.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

using Eigen::Index;

std::string numbers_table(const Correlation& c) {
  std::vector<HtmlRow> rows;
  for (const ComparedNumber& n : c.numbers) {
    const auto [factor, unit] = shown_unit(n.measured, n.unit);
    rows.push_back(
        {{html_escape(n.quantity), unit, html_number(n.measured * factor, 4),
          n.sigma ? html_number(*n.sigma * factor, 2) : "–", html_number(n.simulated * factor, 4),
          html_signed(100 * (n.simulated / n.measured - 1), 1)},
         ""});
  }
  if (rows.empty()) return "";
  return html_table("",
                    {{"", "", false},
                     {"unit", "", false},
                     {"test", ""},
                     {"+/-", ""},
                     {"simulation", ""},
                     {"difference", "%"}},
                    rows);
}

std::string pairs_table(const Correlation& c, const TestData& a, const TestData& b) {
  std::vector<HtmlRow> rows;
  for (const PairedMode& p : c.pairs) {
    const MeasuredMode &s = a.data.modes[p.simulated], &t = b.data.modes[p.measured];
    rows.push_back(
        {{html_escape(mode_name(t, p.measured)), html_escape(mode_name(s, p.simulated)),
          html_number(t.frequency, 5), html_number(s.frequency, 5),
          html_signed(100 * p.frequency_error, 1),
          p.frequency_sigmas ? html_signed(*p.frequency_sigmas, 1) : "–",
          t.damping ? html_number(100 * *t.damping, 3) : "–",
          s.damping ? html_number(100 * *s.damping, 3) : "–", html_number(p.mac, 3), p.by},
         ""});
  }
  for (const int j : c.unpaired_measured)
    rows.push_back({{html_escape(mode_name(b.data.modes[j], j)), "no partner",
                     html_number(b.data.modes[j].frequency, 5), "–", "–", "–", "–", "–", "–", ""},
                    ""});
  return html_table("",
                    {{"test", "", false},
                     {"simulation", "", false},
                     {"test", "Hz"},
                     {"simulation", "Hz"},
                     {"difference", "%"},
                     {"", "sigma"},
                     {"damping, test", "%"},
                     {"simulation", "%"},
                     {"MAC", ""},
                     {"paired by", "", false}},
                    rows);
}

std::string mac_table(const Correlation& c, const TestData& a, const TestData& b) {
  if (c.mac.size() == 0) return "";
  std::vector<HtmlColumn> columns{{"simulation \\ test", "Hz", false}};
  for (const int j : c.mac_columns)
    columns.push_back({html_number(b.data.modes[j].frequency, 4), "Hz"});
  std::vector<HtmlRow> rows;
  for (Index i = 0; i < c.mac.rows(); ++i) {
    HtmlRow row{{html_number(a.data.modes[c.mac_rows[i]].frequency, 4)}, ""};
    for (Index j = 0; j < c.mac.cols(); ++j) {
      const std::string value = html_fixed(c.mac(i, j), 2);
      row.cells.push_back(c.mac(i, j) > 0.8 ? "<b>" + value + "</b>" : value);
    }
    rows.push_back(std::move(row));
  }
  std::string html = html_table("MAC over the common channels; bold above 0.8.", columns, rows);
  if (c.comac.size() == 0) return html;
  std::vector<HtmlRow> channels;
  for (Index q = 0; q < c.comac.size(); ++q)
    channels.push_back({{html_escape(c.channels[q]), html_fixed(c.comac[q], 3)}, ""});
  return html +
         html_table("COMAC over the pairs.", {{"channel", "", false}, {"COMAC", ""}}, channels);
}

std::string responses_section(const Correlation& c) {
  std::string html;
  for (const ComparedResponse& r : c.responses) {
    const std::vector<PlotCurve> curves{
        {.x = r.hertz, .y = r.measured.cwiseAbs(), .name = "test", .colour = 0},
        {.x = r.hertz,
         .y = r.simulated.cwiseAbs(),
         .name = "simulation",
         .colour = 1,
         .dashes = 1}};
    std::vector<PlotCurve> phases;
    for (const auto& [H, k] : {std::pair{&r.measured, 0}, {&r.simulated, 1}})
      if (!H->imag().isZero(0))
        phases.push_back(phase_curve(curves[std::size_t(k)], H->cwiseArg()));
    const PlotFrame frame{.label = "test and simulation", .ordinate = "response"};
    html += fmt::format("<h3>{} by {}{}: FRAC {}, {} with frequencies stretched by {} %</h3>\n",
                        html_escape(r.response), html_escape(r.reference),
                        r.level ? fmt::format(" at {:g}", *r.level) : "", html_fixed(r.frac, 3),
                        html_fixed(r.best_frac, 3), html_signed(100 * r.stretch, 2)) +
            plot_figure(frame, curves) + phase_figure(frame, phases) + plot_legend(curves);
  }
  for (const ComparedLines& l : c.lines)
    html += fmt::format("<p>{}: CSAC {}, CSF {} (means over the lines).</p>\n",
                        html_escape(l.reference), html_fixed(l.csac.mean(), 3),
                        html_fixed(l.csf.mean(), 3));
  return html;
}

} // namespace

std::string correlation_html(const Correlation& c, const TestData& a, const TestData& b) {
  std::string sections = html_section("numbers", "Mass and stiffness", numbers_table(c));
  sections += html_section("modes", "Modes", pairs_table(c, a, b));
  sections += html_section("mac", "Shapes", mac_table(c, a, b));
  sections += html_section("responses", "Responses", responses_section(c));
  sections += html_section("limits", "What these data cannot tell", html_list(c.limits));
  const std::string lead = html_escape(a.data.source.empty() ? "simulation" : a.data.source) +
                           " beside " + html_escape(b.data.source.empty() ? "test" : b.data.source);
  std::vector<std::string> warnings = warnings_of(a);
  for (std::string& warning : warnings_of(b)) warnings.push_back(std::move(warning));
  return report_page(b.data.specimen + ": simulation and test", lead, warnings, sections);
}

} // namespace plica
