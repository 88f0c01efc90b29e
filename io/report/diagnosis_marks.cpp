#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/tables/effect_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {

std::string tinted(double value, double full, const std::string& text) {
  constexpr double deepest = 0.5; // opacity: text stays readable on light and dark
  if (!std::isfinite(value)) return text;
  const double depth = deepest * std::min(1., std::abs(value) / full);
  return fmt::format("<span style=\"display:block;padding:0 0.4rem;"
                     "background:rgba({},{:.2f});print-color-adjust:exact;"
                     "-webkit-print-color-adjust:exact\">{}</span>",
                     value < 0 ? "33,102,172" : "224,130,20", depth, text);
}

std::string bar_svg(const LevelBar& bar) {
  constexpr double unit = 16, edge = 4; // per rem; free at either end
  const double width = unit * bar.width, range = bar.high > bar.low ? bar.high - bar.low : 1;
  const auto x = [&](double value) {
    const double share = std::isfinite(value) ? std::clamp((value - bar.low) / range, 0., 1.) : 0;
    return edge + share * (width - 2 * edge);
  };
  std::string svg = fmt::format(
      "<svg class=\"strip\" style=\"width:{0}rem\" viewBox=\"0 0 {1:.0f} 20\" aria-hidden=\"true\">"
      "<line class=\"rail\" x1=\"{2:.1f}\" x2=\"{3:.1f}\" y1=\"10\" y2=\"10\"/>"
      "<line class=\"bar\" x1=\"{4:.1f}\" x2=\"{5:.1f}\" y1=\"10\" y2=\"10\"{6}/>",
      bar.width, width, edge, width - edge, x(bar.from), x(bar.to),
      bar.faint ? " style=\"stroke-opacity:0.5;stroke-dasharray:3 2\"" : "");
  if (bar.mark)
    svg += fmt::format("<line class=\"zero\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"1\" y2=\"19\"/>",
                       x(*bar.mark));
  return svg + "</svg>";
}

std::string estimate_html(const EstimatedParameter& p) {
  return estimate_words(p, html_number);
}

std::string percent_range(const std::array<double, 2>& share) {
  return fmt::format("{} to {}\u00a0%", html_fixed(100 * share[0], 0),
                     html_fixed(100 * share[1], 0));
}

} // namespace plica
