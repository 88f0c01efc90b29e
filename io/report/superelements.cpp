#include "io/report/superelements.hpp"

#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/report/plot.hpp"
#include "io/tables/certificate_words.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

std::string frequencies_html(const std::string& caption, const std::vector<FrequencyCheck>& list) {
  std::vector<HtmlRow> rows;
  rows.reserve(list.size());
  for (const FrequencyCheck& f : list)
    rows.push_back(
        {{html_fixed(f.full, 3), html_fixed(f.reduced, 3), html_signed(100 * f.error(), 4)}, ""});
  if (rows.empty()) return "";
  return html_table(caption, {{"part", "Hz"}, {"superelement", "Hz"}, {"off by", "%"}}, rows);
}

// Of the last boundary node with all others held, and from it to the first: along the pipe and
// across.
std::string stiffness_html(const ReducedCase& r) {
  const Superelement& s = r.element;
  if (s.nodes.empty() || !(r.certificate.good_up_to > 0)) return "";
  constexpr int points = 600;
  const Eigen::VectorXd hertz = Eigen::VectorXd::LinSpaced(
      points, r.certificate.good_up_to / points, r.certificate.good_up_to);
  const int last = s.boundary() - 6;
  constexpr double per_mm = 1e-3; // N/mm of N/m
  std::vector<PlotCurve> curves;
  const auto add = [&](int row, int column, const std::string& name) {
    curves.push_back({.x = hertz,
                      .y = per_mm * dynamic_stiffness(s, row, column, hertz).cwiseAbs(),
                      .name = name,
                      .dashes = static_cast<int>(curves.size())});
  };
  const std::string& end = s.node_names.back();
  add(last + 1, last + 1, "along, at " + end);
  add(last, last, "across, at " + end);
  if (last > 0) {
    add(1, last + 1, "along, " + end + " to " + s.node_names.front());
    add(0, last, "across, " + end + " to " + s.node_names.front());
  }
  return plot_figure({.label = "dynamic stiffness", .ordinate = "force / displacement, N/mm"},
                     curves) +
         plot_legend(curves) +
         "<p>Force at a boundary node over the displacement of one, all other motions of the "
         "boundary held, undamped: up to where the certificate is good.</p>\n";
}

} // namespace

std::string superelements_html(const Results& results) {
  if (!results.reduced) return "";
  const Reduced& reduced = *results.reduced;
  std::vector<HtmlRow> rows;
  rows.reserve(reduced.superelements.size());
  for (const SuperelementResult& s : reduced.superelements) {
    std::string between;
    for (const std::string& cap : s.between) between += (between.empty() ? "" : ", ") + cap;
    rows.push_back(
        {{std::to_string(rows.size() + 1), html_escape(s.parts), html_escape(between),
          grouped(s.unknowns, "\u202f"), std::to_string(s.boundary), std::to_string(s.modes),
          s.copy_of > 0 ? fmt::format("that of {}", s.copy_of) : html_escape(s.route),
          s.proved ? "proved" : "not proved"},
         ""});
  }
  return html_table(
      fmt::format("Craig-Bampton superelements with modes up to {} Hz; {} unknowns are left of {}.",
                  html_number(reduced.cutoff, 4), grouped(reduced.unknowns, "\u202f"),
                  grouped(results.model.dofs, "\u202f")),
      {{"", ""},
       {"parts", "", false},
       {"between", "", false},
       {"unknowns", ""},
       {"boundary", ""},
       {"modes", ""},
       {"reduction", "", false},
       {"no mode missing", "", false}},
      rows);
}

std::string certificate_report(const ReducedCase& r, const std::string& units) {
  const Certificate& c = r.certificate;
  const Superelement& s = r.element;
  const bool good = c.passed && r.proved;
  const std::string header = fmt::format(
      "<h1>Superelement {}</h1>\n<p class=\"verdict{}\"><b>{}&nbsp;{}</b> {}</p>\n",
      html_escape(s.name), good ? "" : " open", good ? "✓" : "!",
      good ? "The certificate is passed." : "The certificate failed.", html_escape(reach_of(r)));
  std::vector<std::string> failures = c.failures;
  if (!r.proved) failures.push_back("not proved: " + r.reason);
  std::string html;
  if (!failures.empty()) html += "<div class=\"warnings\">" + html_list(failures) + "</div>\n";
  std::string names;
  for (const std::string& name : s.node_names)
    names += (names.empty() ? "" : ", ") + html_escape(name);
  html += html_section(
      "element", "What it is",
      html_table("", {{"", "", false}, {"", "", false}},
                 {{{"boundary nodes", names}, ""},
                  {{"modes with the boundary held",
                    fmt::format("{}, up to {} Hz", s.modal(), html_number(r.cutoff, 4))},
                   ""},
                  {{"modes left out for want of interface mass",
                    fmt::format("{}, with {} % of it", r.left_out.count,
                                html_number(100 * r.left_out.sum, 2))},
                   ""},
                  {{"reduced by", html_escape(r.route)}, ""},
                  {{"units of the files", html_escape(units)}, ""}}));
  std::vector<HtmlRow> rows;
  for (const CertificateLine& line : certificate_lines(c))
    rows.push_back({{html_escape(line.text), html_number(line.value, 2)}, ""});
  rows.push_back({{"zero eigenvalues of K", std::to_string(c.zero_stiffness)}, ""});
  html += html_section("checks", "Checks", html_table("", {{"", "", false}, {"", ""}}, rows));
  html += html_section("stiffness", "Dynamic stiffness", stiffness_html(r));
  html += html_section(
      "frequencies", "Part and superelement",
      frequencies_html(c.preloaded ? "First cap held." : "Boundary free; rigid motions left out.",
                       c.free) +
          frequencies_html("Boundary held.", c.fixed));
  return html_page(s.name + ": superelement", header, html);
}

} // namespace plica
