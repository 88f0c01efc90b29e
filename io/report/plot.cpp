#include "io/report/plot.hpp"

#include "io/files/json_text.hpp"
#include "io/report/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plica {
namespace {

constexpr double width = 760, height = 260, left = 60, right = 30, bottom = 40, top = 10;
constexpr std::array dashes{"", "6 3", "2 3", "8 3 2 3"};

struct Axes {
  double low, high;        // Hz
  double decade0, decade1; // exponents of ten
  double x(double f) const { return left + (f - low) / (high - low) * (width - left - right); }
  double at_share(double share) const { return height - bottom - share * (height - bottom - top); }
  double y(double magnitude) const {
    const double e = std::log10(std::max(magnitude, 1e-300));
    return at_share((std::clamp(e, decade0, decade1) - decade0) / (decade1 - decade0));
  }
};

Axes axes_of(const std::vector<PlotCurve>& curves, const std::vector<PlotMark>& marks) {
  double low = 1e300, high = 0, lowest = 1e300, highest = 0;
  for (const PlotCurve& c : curves) {
    low = std::min(low, c.hertz[0]);
    high = std::max(high, c.hertz[c.hertz.size() - 1]);
    const double largest = c.magnitude.maxCoeff();
    highest = std::max(highest, largest);
    lowest = std::min(lowest, std::max(c.magnitude.minCoeff(), 1e-3 * largest));
  }
  for (const PlotMark& m : marks) {
    low = std::min(low, m.hertz);
    high = std::max(high, m.hertz);
  }
  if (!(highest > 0)) lowest = highest = 1;
  if (!(high > low)) high = low + 1;
  return {low, high, std::floor(std::log10(std::max(lowest, 1e-12 * highest))),
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

std::string grid_lines(const Axes& axes, bool curves) {
  std::string svg;
  for (double e = axes.decade0; curves && e <= axes.decade1 + 0.1; ++e) {
    const double y = axes.y(std::pow(10, e));
    svg += fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\" "
                       "stroke=\"currentColor\" opacity=\"0.2\"/>",
                       left, width - right, y, y) +
           text_at(left - 6, y + 4, "end", fmt::format("{:g}", std::pow(10, e)));
  }
  const double step = step_over(axes.high - axes.low);
  for (double f = std::ceil(axes.low / step) * step; f <= axes.high; f += step)
    svg += text_at(axes.x(f), height - bottom + 16, "middle", fmt::format("{:g}", f));
  return svg + text_at((width + left) / 2, height - 6, "middle", "frequency, Hz");
}

std::string mark_svg(const Axes& axes, const PlotMark& m) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.4\" fill=\"{}\" "
                     "stroke=\"currentColor\" stroke-width=\"0.8\" opacity=\"{}\"/>",
                     axes.x(m.hertz), axes.at_share(m.height), m.filled ? "currentColor" : "none",
                     m.filled ? 0.9 : 0.45);
}

std::string svg_of(const std::string& label, const std::vector<PlotCurve>& curves,
                   const std::vector<PlotMark>& marks, double mark_top,
                   const std::vector<double>& verticals) {
  const Axes axes = axes_of(curves, marks);
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", width,
                                height, html_escape(label));
  svg += grid_lines(axes, !curves.empty());
  for (const double f : verticals)
    svg += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" "
                       "stroke=\"currentColor\" opacity=\"0.35\"/>",
                       axes.x(f), top, height - bottom);
  for (const PlotCurve& c : curves) {
    std::string points;
    for (Eigen::Index i = 0; i < c.hertz.size(); ++i)
      points += fmt::format("{:.1f},{:.1f} ", axes.x(c.hertz[i]), axes.y(c.magnitude[i]));
    svg += fmt::format("<polyline fill=\"none\" stroke=\"currentColor\" stroke-width=\"{}\" "
                       "stroke-dasharray=\"{}\" opacity=\"{}\" points=\"{}\"/>",
                       c.faint ? 1 : 1.5, dashes[c.dashes % int(dashes.size())], c.faint ? 0.4 : 1.,
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

std::string data_of(const std::string& label, const std::string& ordinate,
                    const std::vector<PlotCurve>& curves, const std::vector<PlotMark>& marks,
                    double mark_top, const std::vector<double>& verticals) {
  constexpr int of_frequency = 7, of_value = 5;
  std::vector<const Eigen::VectorXd*> grids; // those that differ
  std::string list, grid_list, mark_list;
  for (const PlotCurve& c : curves) {
    auto own = std::find_if(grids.begin(), grids.end(), [&](const Eigen::VectorXd* g) {
      return g->size() == c.hertz.size() && *g == c.hertz;
    });
    if (own == grids.end()) {
      grid_list += (grids.empty() ? "" : ",") + list_of(c.hertz, of_frequency);
      own = grids.insert(grids.end(), &c.hertz);
    }
    list += fmt::format("{}{{\"name\":{},\"grid\":{},\"dashes\":{},\"faint\":{},\"values\":{}}}",
                        list.empty() ? "" : ",", json_in_page(c.name), own - grids.begin(),
                        c.dashes, c.faint, list_of(c.magnitude, of_value));
  }
  for (const PlotMark& m : marks)
    mark_list += fmt::format("{}[{:.7g},{:.5g},{}]", mark_list.empty() ? "" : ",", m.hertz,
                             m.height * mark_top, m.filled ? 1 : 0);
  return fmt::format("{{\"label\":{},\"ordinate\":{},\"grids\":[{}],\"curves\":[{}],\"marks\":[{}],"
                     "\"verticals\":{}}}",
                     json_in_page(label), json_in_page(ordinate), grid_list, list, mark_list,
                     list_of(verticals, of_frequency));
}

} // namespace

std::string plot_figure(const std::string& label, const std::string& ordinate,
                        const std::vector<PlotCurve>& curves, const std::vector<PlotMark>& marks,
                        double mark_top, const std::vector<double>& verticals) {
  return "<figure class=\"plot\">" + svg_of(label, curves, marks, mark_top, verticals) +
         json_script(data_of(label, ordinate, curves, marks, mark_top, verticals)) + "</figure>\n";
}

std::string plot_legend(const std::vector<PlotCurve>& curves) {
  constexpr std::array names{"full line", "dashed", "dotted", "dash-dotted"};
  std::string text;
  for (const PlotCurve& c : curves) {
    if (c.name.empty()) continue;
    text += fmt::format("{}{} ({}{})", text.empty() ? "" : ", ", html_escape(c.name),
                        c.faint ? "faint " : "", names[c.dashes % int(names.size())]);
  }
  return "<p>" + text + "</p>\n";
}

} // namespace plica
