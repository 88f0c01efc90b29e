#include "io/report/identification.hpp"

#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/report/phase.hpp"
#include "io/report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Root of the summed squares of all responses to one reference.
VectorXd summed(const Eigen::MatrixXcd& H) {
  return H.rowwise().norm();
}

std::string diagram_html(const Identification& found) {
  std::vector<PlotCurve> curves;
  for (std::size_t i = 0; i < found.set.H.size(); ++i)
    curves.push_back({.x = found.set.hertz,
                      .y = summed(found.set.H[i]),
                      .name = "all responses by " + found.set.references[i],
                      .dashes = static_cast<int>(i),
                      .faint = true});
  int top = 1;
  for (const DiagramPole& p : found.diagram) top = std::max(top, p.order);
  std::vector<PlotMark> marks;
  for (const DiagramPole& p : found.diagram)
    marks.push_back({.x = p.pole.frequency(),
                     .height = double(p.order) / top,
                     .filled = p.stability == Stability::all});
  std::vector<double> chosen;
  for (const IdentifiedMode& m : found.modes) chosen.push_back(m.frequency);
  return plot_figure({.label = "stabilisation diagram", .ordinate = "response"}, curves, marks, top,
                     chosen) +
         plot_legend(curves) +
         "<p>Filled: stable in frequency, damping and participation against the order below; scale "
         "of "
         "the order at the right. Vertical lines: the modes that were taken.</p>\n";
}

std::string modes_table(const Identification& found) {
  std::vector<HtmlRow> rows;
  for (const IdentifiedMode& m : found.modes)
    rows.push_back(
        {{html_fixed(m.frequency, 3), html_number(m.sigma_frequency, 2),
          html_number(100 * m.damping, 4), html_number(100 * m.sigma_damping, 2),
          html_fixed(m.circle_frequency, 3), html_number(100 * m.circle_damping, 3),
          html_fixed(m.peak_frequency, 3), html_number(100 * m.peak_damping, 3),
          html_number(100 * m.share, 3), html_fixed(m.collinearity, 3), std::to_string(m.orders)},
         ""});
  return html_table(
      "Least squares over all responses; beside it the strongest response alone, by a "
      "circle fit and by peak and half power.",
      {{"mode", "Hz"},
       {"+/-", "Hz"},
       {"damping", "%"},
       {"+/-", "%"},
       {"circle", "Hz"},
       {"damping", "%"},
       {"peak", "Hz"},
       {"half power", "%"},
       {"share", "%"},
       {"collinearity", ""},
       {"orders", ""}},
      rows);
}

std::string shapes_table(const Identification& found) {
  std::vector<HtmlColumn> columns{{"response", "", false}};
  for (const IdentifiedMode& m : found.modes)
    columns.push_back(
        {html_fixed(m.frequency, 2) + " Hz", m.mass_normalised ? "1/√kg" : "relative"});
  std::vector<HtmlRow> rows;
  for (std::size_t c = 0; c < found.set.responses.size(); ++c) {
    HtmlRow row{{html_escape(found.set.responses[c])}, ""};
    for (const IdentifiedMode& m : found.modes)
      row.cells.push_back(html_number(m.shape[Index(c)].real(), 4) + " ± " +
                          html_number(m.sigma_shape[Index(c)], 2));
    rows.push_back(std::move(row));
  }
  return found.modes.empty() ? "" : html_table("Real parts.", columns, rows);
}

std::string mac_table(const Identification& found) {
  std::vector<HtmlColumn> columns{{"Hz", "", false}};
  for (const IdentifiedMode& m : found.modes) columns.push_back({html_fixed(m.frequency, 2), ""});
  std::vector<HtmlRow> rows;
  for (std::size_t i = 0; i < found.modes.size(); ++i) {
    HtmlRow row{{html_fixed(found.modes[i].frequency, 2)}, ""};
    for (std::size_t j = 0; j < found.modes.size(); ++j)
      row.cells.push_back(html_fixed(found.auto_mac(Index(i), Index(j)), 3));
    rows.push_back(std::move(row));
  }
  return found.modes.empty()
             ? ""
             : html_table("Auto-MAC: modes that look alike at these responses.", columns, rows);
}

std::string synthesis_html(const Identification& found) {
  std::string html;
  for (std::size_t i = 0; i < found.synthesised.size(); ++i) {
    // The response that is met worst, and the largest.
    Index worst = 0, largest = 0;
    found.frac.col(Index(i)).minCoeff(&worst);
    found.set.H[i].colwise().norm().maxCoeff(&largest);
    for (const Index o : {largest, worst}) {
      const std::vector<PlotCurve> curves{{.x = found.set.hertz,
                                           .y = found.set.H[i].col(o).cwiseAbs(),
                                           .name = "measured",
                                           .colour = 0,
                                           .faint = true},
                                          {.x = found.set.hertz,
                                           .y = found.synthesised[i].col(o).cwiseAbs(),
                                           .name = "from the modes",
                                           .colour = 1,
                                           .dashes = 1}};
      std::vector<PlotCurve> phases;
      if (!found.set.H[i].imag().isZero(0))
        phases = {phase_curve(curves[0], found.set.H[i].col(o).cwiseArg()),
                  phase_curve(curves[1], found.synthesised[i].col(o).cwiseArg())};
      const PlotFrame frame{.label = "measured and synthesised response", .ordinate = "response"};
      html += fmt::format("<h3>{} by {}, FRAC {}{}</h3>\n", html_escape(found.set.responses[o]),
                          html_escape(found.set.references[i]),
                          html_fixed(found.frac(o, Index(i)), 4), o == worst ? ", met worst" : "") +
              plot_figure(frame, curves) + phase_figure(frame, phases) + plot_legend(curves);
      if (worst == largest) break;
    }
  }
  return html;
}

} // namespace

std::string identification_html(const Identification& found, const std::string& title) {
  const Eigen::VectorXd& hertz = found.set.hertz;
  const std::string lead = fmt::format(
      "{} modes from {} responses and {} references, {} to {} Hz; what they leave unexplained is "
      "{} % "
      "RMS.",
      found.modes.size(), found.set.responses.size(), found.set.H.size(), html_number(hertz[0], 4),
      html_number(hertz[hertz.size() - 1], 4), html_number(100 * found.misfit, 3));
  std::string sections = html_section("modes", "Modes", modes_table(found));
  sections += html_section("diagram", "Stabilisation diagram", diagram_html(found));
  sections += html_section("shapes", "Shapes", shapes_table(found) + mac_table(found));
  if (!found.synthesised.empty())
    sections += html_section("synthesis", "Measured beside synthesised", synthesis_html(found));
  return report_page("Modes of " + title, lead, found.warnings, sections);
}

} // namespace plica
