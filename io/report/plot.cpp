#include "io/report/plot.hpp"

#include "io/files/json_text.hpp"
#include "io/report/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plica {
namespace {

constexpr double width = 760, height = 260, left = 74, right = 30, bottom = 40, top = 10;
constexpr std::array dashes{"", "6 3", "2 3", "8 3 2 3"};
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

int colour_of(const PlotCurve& c, std::size_t place) {
  return (c.colour >= 0 ? c.colour : int(place)) % int(colours.size());
}

std::string stroke_of(const PlotCurve& c, std::size_t place) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\" opacity=\"{}\"",
                     c.faint ? "currentColor" : colours[std::size_t(colour_of(c, place))],
                     c.faint ? 1 : 1.5, dashes[std::size_t(c.dashes) % dashes.size()],
                     c.faint ? 0.4 : 1.);
}

struct Axes {
  double low, high;     // of the abscissa
  bool linear;          // the ordinate
  double bottom_, top_; // of the ordinate; logarithmic: exponents of ten
  double x(double f) const { return left + (f - low) / (high - low) * (width - left - right); }
  double at_share(double share) const { return height - bottom - share * (height - bottom - top); }
  double y(double value) const {
    const double e = linear ? value : std::log10(std::max(value, 1e-300));
    return at_share((std::clamp(e, bottom_, top_) - bottom_) / (top_ - bottom_));
  }
};

Axes axes_of(const PlotFrame& frame, const std::vector<PlotCurve>& curves,
             const std::vector<PlotMark>& marks) {
  double low = 1e300, high = -1e300, lowest = 1e300, highest = -1e300;
  for (const PlotCurve& c : curves) {
    low = std::min(low, c.x.minCoeff());
    high = std::max(high, c.x.maxCoeff());
    double smallest = 1e300, largest = -1e300;
    for (const double y : c.y)
      if (std::isfinite(y)) {
        smallest = std::min(smallest, y);
        largest = std::max(largest, y);
      }
    if (largest < smallest) continue;
    highest = std::max(highest, largest);
    lowest = std::min(lowest, frame.linear ? smallest : std::max(smallest, 1e-3 * largest));
  }
  for (const PlotMark& m : marks) {
    low = std::min(low, m.x);
    high = std::max(high, m.x);
  }
  if (!(high > low)) high = low + 1;
  if (frame.range) return {low, high, true, (*frame.range)[0], (*frame.range)[1]};
  if (frame.linear) {
    if (!(highest > lowest)) highest = lowest + 1;
    return {low, high, true, lowest, highest};
  }
  if (!(highest > 0)) lowest = highest = 1;
  return {low, high, false, std::floor(std::log10(std::max(lowest, 1e-12 * highest))),
          std::ceil(std::log10(highest) + 1e-9)};
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"12\" "
                     "fill=\"currentColor\">{}</text>",
                     x, y, anchor, text);
}

// Steps of 1, 2 or 5 times a power of ten, four to ten of them.
double step_over(double range) {
  const double power = std::pow(10, std::floor(std::log10(range / 4)));
  for (const double factor : {1., 2., 5., 10.})
    if (range / (factor * power) <= 10) return factor * power;
  return 10 * power;
}

std::string level_line(const Axes& axes, double value) {
  const double y = axes.y(value);
  return fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\" "
                     "stroke=\"currentColor\" opacity=\"0.2\"/>",
                     left, width - right, y, y) +
         text_at(left - 6, y + 4, "end", fmt::format("{:g}", value));
}

// Rounds what steps of a grid leave of zero.
double tidy(double value, double step) {
  return std::abs(value) < 1e-9 * step ? 0 : value;
}

std::string grid_lines(const Axes& axes, const PlotFrame& frame, bool curves) {
  std::string svg;
  if (curves && axes.linear) {
    const double step = frame.step > 0 ? frame.step : step_over(axes.top_ - axes.bottom_);
    for (double v = std::ceil(axes.bottom_ / step) * step; v <= axes.top_; v += step)
      svg += level_line(axes, tidy(v, step));
  }
  for (double e = axes.bottom_; curves && !axes.linear && e <= axes.top_ + 0.1; ++e)
    svg += level_line(axes, std::pow(10, e));
  const double step = step_over(axes.high - axes.low);
  for (double f = std::ceil(axes.low / step) * step; f <= axes.high; f += step)
    svg += text_at(axes.x(f), height - bottom + 16, "middle", fmt::format("{:g}", tidy(f, step)));
  return svg + text_at((width + left) / 2, height - 6, "middle", html_escape(frame.abscissa)) +
         fmt::format("<text transform=\"translate(12 {:.0f}) rotate(-90)\" text-anchor=\"middle\" "
                     "font-size=\"12\" fill=\"currentColor\">{}</text>",
                     (height - bottom + top) / 2, html_escape(frame.ordinate));
}

std::string mark_svg(const Axes& axes, const PlotMark& m) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.4\" fill=\"{}\" "
                     "stroke=\"currentColor\" stroke-width=\"0.8\" opacity=\"{}\"/>",
                     axes.x(m.x), axes.at_share(m.height), m.filled ? "currentColor" : "none",
                     m.filled ? 0.9 : 0.45);
}

// Points of the pieces between values that are not finite.
std::vector<std::string> pieces_of(const PlotCurve& curve, const Axes& axes) {
  std::vector<std::string> pieces;
  bool open = false;
  for (Eigen::Index i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.y[i])) {
      open = false;
      continue;
    }
    if (!open) pieces.emplace_back();
    open = true;
    pieces.back() += fmt::format("{:.1f},{:.1f} ", axes.x(curve.x[i]), axes.y(curve.y[i]));
  }
  return pieces;
}

std::string svg_of(const PlotFrame& frame, const std::vector<PlotCurve>& curves,
                   const std::vector<PlotMark>& marks, double mark_top,
                   const std::vector<double>& verticals) {
  const Axes axes = axes_of(frame, curves, marks);
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", width,
                                height, html_escape(frame.label));
  svg += grid_lines(axes, frame, !curves.empty());
  for (const double f : verticals)
    svg += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" "
                       "stroke=\"currentColor\" opacity=\"0.35\"/>",
                       axes.x(f), top, height - bottom);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (const std::string& points : pieces_of(curves[k], axes))
      svg += fmt::format("<polyline fill=\"none\" {} points=\"{}\"/>", stroke_of(curves[k], k),
                         points);
  }
  for (const PlotMark& m : marks) svg += mark_svg(axes, m);
  if (mark_top > 0)
    for (const double share : {0., 0.5, 1.})
      svg += text_at(width - right + 4, axes.at_share(share) + 4, "start",
                     fmt::format("{:g}", share * mark_top));
  return svg + "</svg>\n";
}

// Numbers as JSON, as many digits as a picture needs.
template <class Numbers> std::string list_of(const Numbers& numbers, int digits) {
  std::string text = "[";
  for (const double x : numbers)
    text += (text.size() > 1 ? "," : "") +
            (std::isfinite(x) ? fmt::format("{:.{}g}", x, digits) : std::string("null"));
  return text + "]";
}

std::string data_of(const PlotFrame& frame, const std::vector<PlotCurve>& curves,
                    const std::vector<PlotMark>& marks, double mark_top,
                    const std::vector<double>& verticals) {
  constexpr int of_abscissa = 7, of_value = 5;
  std::vector<const Eigen::VectorXd*> grids; // those that differ
  std::string list, grid_list, mark_list;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const PlotCurve& c = curves[k];
    auto own = std::find_if(grids.begin(), grids.end(), [&](const Eigen::VectorXd* g) {
      return g->size() == c.x.size() && *g == c.x;
    });
    if (own == grids.end()) {
      grid_list += (grids.empty() ? "" : ",") + list_of(c.x, of_abscissa);
      own = grids.insert(grids.end(), &c.x);
    }
    list += fmt::format(
        "{}{{\"name\":{},\"grid\":{},\"colour\":{},\"dashes\":{},\"faint\":{},\"values\":{}}}",
        list.empty() ? "" : ",", json_in_page(c.name), own - grids.begin(), colour_of(c, k),
        c.dashes, c.faint, list_of(c.y, of_value));
  }
  for (const PlotMark& m : marks)
    mark_list += fmt::format("{}[{:.7g},{:.5g},{}]", mark_list.empty() ? "" : ",", m.x,
                             m.height * (mark_top > 0 ? mark_top : 1), m.filled ? 1 : 0);
  return fmt::format(
      "{{\"label\":{},\"abscissa\":{},\"ordinate\":{},\"linear\":{},\"range\":{},\"step\":{},"
      "\"grids\":[{}],\"curves\":[{}],\"marks\":[{}],\"verticals\":{}}}",
      json_in_page(frame.label), json_in_page(frame.abscissa), json_in_page(frame.ordinate),
      frame.linear, frame.range ? list_of(*frame.range, of_value) : "null", frame.step, grid_list,
      list, mark_list, list_of(verticals, of_abscissa));
}

} // namespace

std::vector<ChannelStyle>
channel_styles(const std::vector<std::pair<std::string, std::string>>& channels,
               const std::vector<int>& drawn) {
  constexpr std::array further{0, 2, 3};
  std::vector<std::string> sensors;
  for (const auto& channel : channels)
    if (std::find(sensors.begin(), sensors.end(), channel.first) == sensors.end())
      sensors.push_back(channel.first);
  std::array<std::size_t, colours.size()> used{};
  std::vector<ChannelStyle> styles;
  for (const int c : drawn) {
    const auto sensor =
        std::find(sensors.begin(), sensors.end(), channels[std::size_t(c)].first) - sensors.begin();
    const auto colour = std::size_t(sensor) % colours.size();
    styles.push_back({int(colour), further[used[colour]++ % further.size()]});
  }
  return styles;
}

std::string plot_figure(const PlotFrame& frame, const std::vector<PlotCurve>& curves,
                        const std::vector<PlotMark>& marks, double mark_top,
                        const std::vector<double>& verticals) {
  return "<figure class=\"plot\">" + svg_of(frame, curves, marks, mark_top, verticals) +
         json_script(data_of(frame, curves, marks, mark_top, verticals)) + "</figure>\n";
}

std::string plot_legend(const std::vector<PlotCurve>& curves) {
  std::string text;
  for (std::size_t k = 0; k < curves.size(); ++k)
    if (!curves[k].name.empty())
      text +=
          fmt::format("<span><svg viewBox=\"0 0 34 8\" width=\"34\" height=\"8\" "
                      "aria-hidden=\"true\"><line x1=\"0\" x2=\"34\" y1=\"4\" y2=\"4\" {}/></svg> "
                      "{}</span>\n",
                      stroke_of(curves[k], k), html_escape(curves[k].name));
  return "<p class=\"lines\">" + text + "</p>\n";
}

} // namespace plica
