#include "io/report/stiffness.hpp"

#include "io/report/colour.hpp"
#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/report/phase.hpp"
#include "io/report/plot.hpp"
#include "io/tables/stiffness_words.hpp"
#include "words/directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using std::numbers::pi;

constexpr std::array titles{"across, x",   "along, y",    "across, z",
                            "bending, rx", "torsion, ry", "bending, rz"};

struct Shown {
  const StiffnessOverFrequency& over;
  int direction;
  double unit() const { return direction < 3 ? 1e-3 : 1; } // N/mm, Nm/rad
  const char* unit_name() const { return direction < 3 ? "N/mm" : "Nm/rad"; }
  std::complex<double> at(std::size_t level, Eigen::Index f) const {
    return transfer_stiffness(over.at[level][std::size_t(f)], direction);
  }
};

// Levels that differ in this direction.
std::vector<std::size_t> levels_of(const Shown& s) {
  std::vector<std::size_t> levels;
  double last = -1;
  for (std::size_t l = 0; l < s.over.levels.size(); ++l) {
    const MotionLevel& level = s.over.levels[l];
    const double X = s.direction < 3 ? level.translation : level.rotation;
    if (X != last) levels.push_back(l);
    last = X;
  }
  return levels;
}

std::string amplitude_name(const Shown& s, std::size_t level) {
  MotionLevel own = s.over.levels[level];
  (s.direction < 3 ? own.rotation : own.translation) = 0;
  return level_name(own);
}

// One curve a level; `value` of k_21.
template <class F> std::vector<PlotCurve> curves(const Shown& s, F&& value) {
  std::vector<PlotCurve> list;
  for (const std::size_t l : levels_of(s)) {
    std::vector<double> x, y;
    for (Eigen::Index f = 0; f < s.over.hertz.size(); ++f)
      if (const double v = value(s.at(l, f)); std::isfinite(v)) {
        x.push_back(s.over.hertz[f]);
        y.push_back(v);
      }
    if (x.size() < 2) continue;
    list.push_back({.x = Eigen::Map<Eigen::VectorXd>(x.data(), long(x.size())),
                    .y = Eigen::Map<Eigen::VectorXd>(y.data(), long(y.size())),
                    .name = amplitude_name(s, l),
                    .dashes = int(list.size() / 6)});
  }
  return list;
}

std::string cuts_html(const Shown& s) {
  const auto magnitude = curves(s, [&](auto k) { return s.unit() * std::abs(k); });
  auto angle = curves(s, [](auto k) { return std::arg(k); });
  for (PlotCurve& curve : angle) curve = phase_curve(curve, curve.y);
  if (magnitude.empty()) return "";
  return plot_figure({.label = fmt::format("blocked transfer stiffness {}",
                                           titles[std::size_t(s.direction)]),
                      .ordinate = fmt::format("magnitude, {}", s.unit_name())},
                     magnitude) +
         plot_figure({.label = "loss angle", .ordinate = "loss angle, degrees", .linear = true},
                     angle) +
         plot_legend(magnitude);
}

// Storage or loss as colours: frequency to the right, amplitude upwards, a row per level.
std::string surface_html(const Shown& s, const std::vector<std::size_t>& levels, bool loss) {
  constexpr double width = 760, left = 74, right = 30, row = 18, below = 40;
  const auto value = [&](std::size_t l, Eigen::Index f) {
    const std::complex<double> k = s.at(l, f);
    return s.unit() * (loss ? k.imag() : k.real());
  };
  const Eigen::Index count = s.over.hertz.size();
  double low = 1e300, high = -1e300;
  for (const std::size_t l : levels)
    for (Eigen::Index f = 0; f < count; ++f)
      if (std::isfinite(value(l, f))) {
        low = std::min(low, value(l, f));
        high = std::max(high, value(l, f));
      }
  if (!(high > low)) return "";
  const Eigen::Index step = std::max<Eigen::Index>(1, count / 240);
  const double top = row * double(levels.size()), first = s.over.hertz[0],
               span = s.over.hertz[count - 1] - first;
  std::string svg = fmt::format(
      "<figure><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} over frequency and "
      "amplitude\" font-size=\"11\">\n",
      width, top + below, loss ? "loss stiffness" : "storage stiffness");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const double y = top - row * double(k + 1);
    svg +=
        fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\" fill=\"currentColor\">{}</text>\n",
                    left - 6, y + row - 5, html_escape(amplitude_name(s, levels[k])));
    for (Eigen::Index f = 0; f + 1 < count; f += step) {
      const Eigen::Index next = std::min(f + step, count - 1);
      const double v = value(levels[k], f);
      if (!std::isfinite(v)) continue;
      const double x0 = left + (s.over.hertz[f] - first) / span * (width - left - right),
                   x1 = left + (s.over.hertz[next] - first) / span * (width - left - right);
      svg += fmt::format("<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>",
                         x0, y, x1 - x0 + 0.3, row, viridis((v - low) / (high - low)));
    }
    svg += "\n";
  }
  svg += fmt::format("<text x=\"{}\" y=\"{}\" fill=\"currentColor\">{:.4g} Hz</text>"
                     "<text x=\"{}\" y=\"{}\" text-anchor=\"end\" fill=\"currentColor\">{:.4g} "
                     "Hz</text>\n</svg>",
                     left, top + 16, first, width - right, top + 16, first + span);
  return svg +
         fmt::format("<figcaption>{} stiffness from {} {} (dark) to {} {} (bright), frequency "
                     "to the right, amplitude upwards.</figcaption></figure>\n",
                     loss ? "Loss" : "Storage", html_number(low, 4), s.unit_name(),
                     html_number(high, 4), s.unit_name());
}

std::string state_html(const StateStiffness& state) {
  std::string html;
  for (int d = 0; d < 6; ++d) {
    const Shown shown{state.over, d};
    const std::vector<std::size_t> levels = levels_of(shown);
    html += fmt::format("<h3>{}</h3>\n", titles[std::size_t(d)]) + cuts_html(shown);
    if (levels.size() > 2 && state.over.hertz.size() > 1)
      html += surface_html(shown, levels, false) + surface_html(shown, levels, true);
  }
  return html;
}

// Test and computation of one quantity over frequency.
std::string beside_html(const std::vector<StiffnessComparison>& compared) {
  std::string html;
  std::vector<HtmlRow> rows;
  for (const ShownDeviation& d : deviations(compared)) {
    rows.push_back({{html_escape(d.name), std::to_string(d.count), html_signed(d.mean, 2),
                     html_number(d.root_mean_square, 3), html_signed(d.largest, 2), d.unit},
                    ""});
    std::vector<std::array<double, 3>> points;
    double unit = 1;
    std::string unit_name;
    for (const StiffnessComparison& c : compared)
      if (measured_name(c.measured) == d.name && std::isfinite(c.computed)) {
        points.push_back({c.measured.hertz, c.measured.value, c.computed});
        const bool angle = c.measured.quantity == StiffnessQuantity::loss_angle;
        unit = angle ? 180 / pi : c.measured.direction < 3 ? 1e-3 : 1;
        unit_name = angle ? "degrees" : c.measured.direction < 3 ? "N/mm" : "Nm/rad";
      }
    std::stable_sort(points.begin(), points.end(),
                     [](const auto& a, const auto& b) { return a[0] < b[0]; });
    if (points.size() < 2) continue;
    Eigen::VectorXd x(long(points.size())), test = x, own = x;
    for (std::size_t k = 0; k < points.size(); ++k) {
      x[long(k)] = points[k][0];
      test[long(k)] = unit * points[k][1];
      own[long(k)] = unit * points[k][2];
    }
    const std::vector<PlotCurve> both{{.x = x, .y = test, .name = "test", .dashes = 1},
                                      {.x = x, .y = own, .name = "computed"}};
    html += plot_figure({.label = d.name, .ordinate = d.name + ", " + unit_name, .linear = true},
                        both) +
            plot_legend(both);
  }
  if (rows.empty()) return "";
  return html_table("Computed less measured, over measured; of angles the difference.",
                    {{"", "", false},
                     {"values", ""},
                     {"mean", ""},
                     {"rms", ""},
                     {"largest", ""},
                     {"unit", "", false}},
                    rows) +
         html;
}

} // namespace

std::string stiffness_report(const EndDynamicStiffness& s,
                             const std::vector<StiffnessComparison>& compared) {
  const PartBetweenEnds& part = s.states.front().part;
  std::string sections = html_section("test", "Beside the test", beside_html(compared));
  for (std::size_t k = 0; k < s.states.size(); ++k) {
    const StateStiffness& state = s.states[k];
    std::string body = fmt::format(
        "<p>By {}; {} modes with both ends held up to {} Hz, and static answers to all that "
        "acts.</p>\n",
        html_escape(state.route), state.modes, html_number(s.highest_mode, 4));
    std::vector<HtmlRow> rows;
    const Complex1212 Z = dynamic_stiffness(state.part, 0);
    for (int d = 0; d < 6; ++d)
      rows.push_back({{direction_names[std::size_t(d)],
                       html_number((d < 3 ? 1e-3 : 1) * transfer_stiffness(Z, d).real(), 4),
                       d < 3 ? "N/mm" : "Nm/rad"},
                      ""});
    body += html_table("At 0 Hz and small motion.", {{"", "", false}, {"", ""}, {"", "", false}},
                       rows) +
            state_html(state);
    sections += html_section("state" + std::to_string(k + 1), html_escape(state.name), body);
  }
  return report_page(
      s.case_name + ": dynamic stiffness",
      fmt::format("Blocked transfer stiffness (ISO 10846): force that the part exerts on its held "
                  "end {} over the motion of its end {}, one direction at a time.",
                  html_escape(part.names[1]), html_escape(part.names[0])),
      s.notes, sections);
}

} // namespace plica
