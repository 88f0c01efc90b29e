#include "io/report/response.hpp"

#include "io/report/markup.hpp"
#include "io/report/plot.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plica {
namespace {

std::string channel(const ResponseResult& r, int c) {
  return html_escape(r.channels[c].first) + " " + r.channels[c].second;
}

std::vector<PlotCurve> curves(const ResponseResult& r) {
  std::vector<PlotCurve> list;
  for (int c : r.shown)
    list.push_back({.hertz = r.hertz,
                    .magnitude = r.acceleration.col(c).cwiseAbs(),
                    .name = r.channels[c].first + " " + r.channels[c].second,
                    .dashes = static_cast<int>(list.size())});
  for (const TestCurve& t : r.test)
    if (std::find(r.shown.begin(), r.shown.end(), t.channel) != r.shown.end())
      list.push_back({.hertz = t.hertz,
                      .magnitude = t.magnitude,
                      .name = fmt::format(
                          "test {} {}{}", r.channels[t.channel].first, r.channels[t.channel].second,
                          t.level ? fmt::format(", {:g} {}", *t.level, r.unit) : ""),
                      .dashes = static_cast<int>(list.size())});
  return list;
}

std::string peaks_html(const ResponseResult& r) {
  std::vector<HtmlRow> rows;
  for (const ResponsePeak& p : r.peaks)
    rows.push_back({{channel(r, p.channel), html_fixed(p.frequency, 1), html_number(p.amplitude, 3),
                     html_number(100 * p.damping, 3)},
                    ""});
  return html_table("",
                    {{"sensor", "", false},
                     {"peak", "Hz"},
                     {"acceleration", "m/s² per " + r.unit},
                     {"half-power damping", "%"}},
                    rows);
}

std::string random_html(const ResponseResult& r) {
  if (!r.random) return "";
  std::vector<HtmlColumn> columns{{"RMS in", "Hz", false}, {"input", r.unit}};
  for (int c : r.shown) columns.push_back({channel(r, c), "m/s²"});
  std::vector<HtmlRow> rows;
  for (const BandRms& b : r.random->bands) {
    HtmlRow row{{fmt::format("{:g} to {:g}", b.band[0], b.band[1]), html_number(b.input, 3)}, ""};
    for (int c : r.shown) row.cells.push_back(html_number(b.rms[c], 3));
    rows.push_back(std::move(row));
  }
  return html_table("Under the random input of the case.", columns, rows);
}

} // namespace

std::string responses_html(const Results& results) {
  std::string html;
  bool base = false;
  for (const ResponseResult& r : results.responses) {
    if (r.channels.empty() || r.hertz.size() < 2) continue;
    base = base || !r.is_force;
    html += fmt::format("<h3>{}</h3>\n", html_escape(response_title(r))) +
            plot_figure(response_title(r), "acceleration, m/s² per " + r.unit, curves(r)) +
            plot_legend(curves(r)) + peaks_html(r) + random_html(r);
  }
  if (base)
    html += "<p>Absolute acceleration of the sensor in its own axes over that of the base.</p>\n";
  if (!results.unanswered.empty())
    html += "<h3>What this model cannot show</h3>\n" + html_list(results.unanswered);
  return html;
}

std::string stresses_html(const Results& results) {
  if (results.stresses.empty()) return "";
  bool beams = false;
  for (const StressResult& s : results.stresses) beams = beams || s.largest_beam > 0;
  std::vector<HtmlColumn> columns{
      {"stress of", "", false}, {"von Mises", "MPa"}, {"face", "", false},
      {"at x", "mm"},           {"y", "mm"},          {"z", "mm"}};
  if (beams) columns.push_back({"beams, axial", "MPa"});
  const std::vector<MeshError>& errors = results.error_bars.stresses;
  if (!errors.empty()) columns.push_back({"mesh error", "%"});
  std::vector<HtmlRow> rows;
  for (const StressResult& s : results.stresses) {
    HtmlRow row{{html_escape(s.name), html_number(s.largest / 1e6, 4), s.face}, ""};
    for (const double x : s.at) row.cells.push_back(html_fixed(1e3 * x, 1));
    if (beams) row.cells.push_back(html_number(s.largest_beam / 1e6, 4));
    if (!errors.empty()) {
      const double share = errors[rows.size()].total() / std::max(s.largest, s.largest_beam);
      row.cells.push_back(std::isfinite(share) ? html_signed(100 * share, 1) : "–");
    }
    rows.push_back(std::move(row));
  }
  return html_table(
      "Largest over the part. Shells on both faces (above: the side the normal points "
      "to, outside of a pipe); harmonic: largest over a cycle. Mesh error: what the largest of the "
      "row is estimated to change by on a converged mesh. Fields in "
      "<code>stress.vtu</code>.",
      columns, rows);
}

} // namespace plica
