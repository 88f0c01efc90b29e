#include "io/report_response.hpp"

#include "io/report_markup.hpp"
#include "io/results_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plica {
namespace {

constexpr double width = 760, height = 260, left = 60, bottom = 40, top = 10;
constexpr std::array dashes{"", "6 3", "2 3", "8 3 2 3"};

struct Axes {
  double low, high;        // Hz
  double decade0, decade1; // exponents of ten
  double x(double f) const { return left + (f - low) / (high - low) * (width - left - 10); }
  double y(double magnitude) const {
    const double e = std::log10(std::max(magnitude, 1e-300));
    const double share = (std::clamp(e, decade0, decade1) - decade0) / (decade1 - decade0);
    return height - bottom - share * (height - bottom - top);
  }
};

std::string grid_lines(const Axes& axes) {
  std::string svg;
  for (double e = axes.decade0; e <= axes.decade1 + 0.1; ++e)
    svg +=
        fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"currentColor\" "
                    "opacity=\"0.2\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\" "
                    "font-size=\"12\" fill=\"currentColor\">{:g}</text>",
                    left, width - 10, axes.y(std::pow(10, e)), axes.y(std::pow(10, e)), left - 6,
                    axes.y(std::pow(10, e)) + 4, std::pow(10, e));
  const double step = axes.high - axes.low > 250 ? 100 : axes.high - axes.low > 50 ? 20 : 5;
  for (double f = std::ceil(axes.low / step) * step; f <= axes.high; f += step)
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\" font-size=\"12\" "
                       "fill=\"currentColor\">{:g}</text>",
                       axes.x(f), height - bottom + 16, f);
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"12\" "
                     "fill=\"currentColor\">frequency, Hz</text>",
                     (width + left) / 2, height - 6);
  return svg;
}

std::string plot(const ResponseResult& r) {
  const std::vector<int>& shown = r.shown;
  double lowest = 1, highest = 1;
  for (int c : shown) {
    const Eigen::VectorXd magnitude = r.acceleration.col(c).cwiseAbs();
    highest = std::max(highest, magnitude.maxCoeff());
    lowest = std::min(lowest, std::max(magnitude.minCoeff(), 1e-3 * magnitude.maxCoeff()));
  }
  const Axes axes{r.hertz[0], r.hertz[r.hertz.size() - 1], std::floor(std::log10(lowest)),
                  std::ceil(std::log10(highest) + 1e-9)};
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", width,
                                height, html_escape(response_title(r)));
  svg += grid_lines(axes);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    std::string points;
    for (Eigen::Index i = 0; i < r.hertz.size(); ++i)
      points += fmt::format("{:.1f},{:.1f} ", axes.x(r.hertz[i]),
                            axes.y(std::abs(r.acceleration(i, shown[k]))));
    svg += fmt::format("<polyline fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.5\" "
                       "stroke-dasharray=\"{}\" points=\"{}\"/>",
                       dashes[k % dashes.size()], points);
  }
  return svg + "</svg>\n";
}

std::string channel(const ResponseResult& r, int c) {
  return html_escape(r.channels[c].first) + " " + r.channels[c].second;
}

std::string legend(const ResponseResult& r) {
  constexpr std::array names{"full line", "dashed", "dotted", "dash-dotted"};
  std::string text;
  for (std::size_t k = 0; k < r.shown.size(); ++k)
    text += fmt::format("{}{} ({})", k == 0 ? "" : ", ", channel(r, r.shown[k]),
                        names[k % names.size()]);
  return "<p>" + text + "</p>\n";
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
    html += fmt::format("<h3>{}</h3>\n", html_escape(response_title(r))) + plot(r) + legend(r) +
            peaks_html(r) + random_html(r);
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
  std::vector<HtmlRow> rows;
  for (const StressResult& s : results.stresses) {
    HtmlRow row{{html_escape(s.name), html_number(s.largest / 1e6, 4), s.face}, ""};
    for (const double x : s.at) row.cells.push_back(html_fixed(1e3 * x, 1));
    if (beams) row.cells.push_back(html_number(s.largest_beam / 1e6, 4));
    rows.push_back(std::move(row));
  }
  return html_table(
      "Largest over the part. Shells on both faces (above: the side the normal points "
      "to, outside of a pipe); harmonic: largest over a cycle. Fields in "
      "<code>stress.vtu</code>.",
      columns, rows);
}

} // namespace plica
