#include "io/report_response.hpp"

#include "io/report_markup.hpp"
#include "io/results_text.hpp"

#include <fmt/format.h>

#include <algorithm>
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

// Channels that stay below a thousandth of the largest are left out: rounding, or no path.
std::vector<int> shown_channels(const ResponseResult& r) {
  const double largest = r.transmissibility.cwiseAbs().maxCoeff();
  std::vector<int> shown;
  for (Eigen::Index c = 0; c < r.transmissibility.cols(); ++c)
    if (r.transmissibility.col(c).cwiseAbs().maxCoeff() > 1e-3 * largest)
      shown.push_back(static_cast<int>(c));
  return shown;
}

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

std::string plot(const ResponseResult& r, const std::vector<int>& shown) {
  double lowest = 1, highest = 1;
  for (int c : shown) {
    const Eigen::VectorXd magnitude = r.transmissibility.col(c).cwiseAbs();
    highest = std::max(highest, magnitude.maxCoeff());
    lowest = std::min(lowest, std::max(magnitude.minCoeff(), 1e-3 * magnitude.maxCoeff()));
  }
  const Axes axes{r.hertz[0], r.hertz[r.hertz.size() - 1], std::floor(std::log10(lowest)),
                  std::ceil(std::log10(highest) + 1e-9)};
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Response to "
                                "motion of the base in {}\">",
                                width, height, r.base);
  svg += grid_lines(axes);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    std::string points;
    for (Eigen::Index i = 0; i < r.hertz.size(); ++i)
      points += fmt::format("{:.1f},{:.1f} ", axes.x(r.hertz[i]),
                            axes.y(std::abs(r.transmissibility(i, shown[k]))));
    svg += fmt::format("<polyline fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.5\" "
                       "stroke-dasharray=\"{}\" points=\"{}\"/>",
                       dashes[k % dashes.size()], points);
  }
  return svg + "</svg>\n";
}

std::string legend(const ResponseResult& r, const std::vector<int>& shown) {
  constexpr std::array names{"full line", "dashed", "dotted", "dash-dotted"};
  std::string text;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const auto& [sensor, direction] = r.channels[shown[k]];
    text +=
        fmt::format("{}{} {} ({})", k == 0 ? "" : ", ", sensor, direction, names[k % names.size()]);
  }
  return "<p>" + html_escape(text) + "</p>\n";
}

std::string peaks_html(const ResponseResult& r, const std::vector<int>& shown) {
  std::string rows;
  for (const ResponsePeak& p : r.peaks) {
    if (std::find(shown.begin(), shown.end(), p.channel) == shown.end()) continue;
    const auto& [sensor, direction] = r.channels[p.channel];
    rows += fmt::format("<tr><td>{} {}</td><td>{:.1f}</td><td>{}</td><td>{}</td></tr>\n",
                        html_escape(sensor), direction, p.frequency, significant(p.amplitude, 3),
                        std::isfinite(p.damping) ? significant(100 * p.damping, 3) : "-");
  }
  return "<table><thead><tr><th>sensor</th><th>peak, Hz</th><th>acceleration / "
         "base</th><th>half-power "
         "damping, %</th></tr></thead><tbody>\n" +
         rows + "</tbody></table>\n";
}

} // namespace

std::string responses_html(const Results& results) {
  std::string html;
  for (const ResponseResult& r : results.responses) {
    if (r.channels.empty() || r.hertz.size() < 2) continue;
    const std::vector<int> shown = shown_channels(r);
    html += fmt::format("<h3>Base moved in {}</h3>\n", r.base) + plot(r, shown) + legend(r, shown) +
            peaks_html(r, shown);
  }
  if (!html.empty())
    html +=
        "<p>Absolute acceleration of the sensor over that of the base. A perfect body of "
        "revolution moved sideways does not answer at right angles to the motion, so a measured "
        "vertical response under transverse excitation is outside of this model.</p>\n";
  return html;
}

} // namespace plica
