#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/tables/effect_words.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double width = 400, height = 300, left = 100, right = 20, top = 10, bottom = 46;
constexpr Index most_dots = 1000;

struct Scale {
  double low = 0, high = 1, first = 0, last = 1; // values, and where they are drawn
  double at(double value) const { return first + (value - low) / (high - low) * (last - first); }
};

Scale scale_of(const VectorXd& values, double first, double last) {
  const double low = values.minCoeff(), high = values.maxCoeff();
  const double room = high > low ? 0 : std::max(1e-12, std::abs(low) / 10);
  return {low - room, high + room, first, last};
}

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"13\"{}>{}"
                     "</text>",
                     x, y, anchor, more, text);
}

std::string frame_svg(const Scale& x, const std::string& name) {
  std::string svg =
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
                  "stroke=\"currentColor\" stroke-opacity=\"0.3\"/>",
                  left - 4, top - 4, width - left - right + 8, height - top - bottom + 8);
  for (const double share : {0., 0.5, 1.}) {
    const double value = x.low + share * (x.high - x.low);
    svg += text_at(x.at(value), height - bottom + 20, "middle", significant(value, 3));
  }
  return svg + text_at((left + width - right) / 2, height - 6, "middle", html_escape(name));
}

std::string scatter_svg(const VectorXd& a, const VectorXd& b, const std::string& name_a,
                        const std::string& name_b) {
  const Scale x = scale_of(a, left, width - right), y = scale_of(b, height - bottom, top);
  std::string svg = frame_svg(x, name_a);
  for (const double share : {0., 0.5, 1.}) {
    const double value = y.low + share * (y.high - y.low);
    svg += text_at(left - 8, y.at(value) + 4, "end", significant(value, 3));
  }
  svg += text_at(
      14, (top + height - bottom) / 2, "middle", html_escape(name_b),
      fmt::format(" transform=\"rotate(-90 14 {:.0f})\"", (top + height - bottom) / 2).c_str());
  const Index step = std::max<Index>(1, a.size() / most_dots);
  for (Index i = 0; i < a.size(); i += step)
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.8\" fill=\"currentColor\" "
                       "fill-opacity=\"0.35\"/>",
                       x.at(a[i]), y.at(b[i]));
  return svg;
}

std::string histogram_svg(const VectorXd& a, const std::string& name) {
  constexpr int bins = 24;
  const Scale x = scale_of(a, left, width - right);
  std::array<int, bins> count{};
  for (const double value : a)
    ++count[std::size_t(std::clamp(int(bins * (value - x.low) / (x.high - x.low)), 0, bins - 1))];
  const int most = *std::max_element(count.begin(), count.end());
  const double step = (width - left - right) / bins;
  std::string svg = frame_svg(x, name);
  for (int k = 0; k < bins; ++k) {
    const double tall = (height - top - bottom) * double(count[std::size_t(k)]) / std::max(1, most);
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                       "fill=\"currentColor\" fill-opacity=\"0.55\"/>",
                       left + k * step + 0.5, height - bottom - tall, step - 1, tall);
  }
  return svg;
}

// Names of the parameters of a hypothesis, by its label.
std::vector<std::string> parameters_of(const Diagnosis& d, const std::string& label) {
  std::vector<std::string> names;
  for (const TriedHypothesis& h : d.tried) {
    if (hypothesis_label(h) != label) continue;
    for (const NamedEffect& e : h.effects)
      for (const EstimatedParameter& p : e.parameters)
        names.push_back(p.name + (p.unit.empty() ? "" : ", " + p.unit));
    break;
  }
  return names;
}

} // namespace

std::string posteriors_html(const Diagnosis& d) {
  std::string figures;
  for (const auto& [label, draws] : d.posteriors) {
    if (draws.rows() == 0 || draws.cols() < 2 || !draws.allFinite()) continue;
    std::vector<std::string> names = parameters_of(d, label);
    while (Index(names.size()) < draws.rows())
      names.push_back(fmt::format("parameter {}", names.size() + 1));
    const VectorXd first = draws.row(0).transpose();
    const std::string svg =
        draws.rows() == 1
            ? histogram_svg(first, names[0])
            : scatter_svg(first, VectorXd(draws.row(1).transpose()), names[0], names[1]);
    figures +=
        fmt::format("<figure><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"draws of "
                    "the posterior\">{}</svg><figcaption>{}: {} draws</figcaption></figure>\n",
                    width, height, svg, html_escape(label), draws.cols());
  }
  if (figures.empty()) return "";
  return "<h3>Posterior</h3>\n<p class=\"note\">Draws of the first two parameters, or how often "
         "one "
         "takes its values.</p>\n<div class=\"modes\" "
         "style=\"grid-template-columns:repeat(auto-fit,minmax(16rem,28rem))\">\n" +
         figures + "</div>\n";
}

} // namespace plica
