#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/tables/effect_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;

constexpr double names = 190, wide = 52, tall = 24; // of the matrix

// One square of the matrix, its middle at (x, y).
std::string cell_svg(double x, double y, double cosine) {
  if (!std::isfinite(cosine)) return "";
  const bool mimic = cosine >= hardly_told_apart;
  return fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" "
                     "fill=\"rgb(224,130,20)\" fill-opacity=\"{:.2f}\" stroke=\"currentColor\" "
                     "stroke-opacity=\"{}\"/>"
                     "<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\"{}>{}{:.2f}</text>",
                     x - wide / 2, y - tall / 2, wide, tall, mimic ? 0.5 * cosine : 0,
                     mimic ? 0.8 : 0.12, x, y + 5, mimic ? " font-weight=\"700\"" : "",
                     mimic ? "●" : "", cosine);
}

std::string smallest_html(const SmallestDetectable& s) {
  if (!s.value) return "not within its prior";
  const auto [factor, unit] = handy_unit(*s.value, s.unit);
  return html_number(factor * *s.value, 2) + "\u00a0" + html_escape(unit);
}

std::string mimics_list(const Diagnosis& d) {
  std::vector<std::string> lines;
  for (const Mimic& m : d.mimics)
    lines.push_back(fmt::format("{} and {}: {:.2f}", m.a, m.b, m.cosine));
  return html_list(lines);
}

} // namespace

std::string likeness_html(const Diagnosis& d) {
  const auto n = Index(d.effect_names.size());
  if (n < 2 || d.likeness.rows() != n || d.likeness.cols() != n) return "";
  const double width = names + double(n - 1) * wide + 2, height = double(n + 1) * tall;
  std::string svg;
  for (Index i = 0; i < n; ++i) {
    const double y = (double(i) + 1.5) * tall;
    svg += fmt::format("<text x=\"0\" y=\"{:.0f}\">{} {}</text>", y + 5, i + 1,
                       html_escape(d.effect_names[std::size_t(i)]));
    if (i + 1 < n)
      svg += fmt::format("<text x=\"{:.0f}\" y=\"16\" text-anchor=\"middle\">{}</text>",
                         names + (double(i) + 0.5) * wide, i + 1);
    for (Index j = 0; j < i; ++j)
      svg += cell_svg(names + (double(j) + 0.5) * wide, y, d.likeness(i, j));
  }
  return fmt::format("<p class=\"note\">Largest cosine of the signatures of two effects in these "
                     "readings. ●, bold and framed: {3:g} and more, these data hardly tell them "
                     "apart.</p>\n<figure style=\"max-width:{0:.0f}px\"><svg viewBox=\"0 0 {0:.0f} "
                     "{1:.0f}\" role=\"img\" aria-label=\"likeness of effects\" "
                     "font-size=\"13\">{2}</svg></figure>\n",
                     width, height, svg, hardly_told_apart) +
         mimics_list(d);
}

std::string detectable_html(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  for (const SmallestDetectable& s : d.detectable) {
    const bool most = std::none_of(
        d.detectable.begin(), d.detectable.end(), [&](const SmallestDetectable& other) {
          return other.name == s.name && other.noncentrality > s.noncentrality;
        });
    if (!most) continue;
    rows.push_back(
        {{html_escape(s.name), html_escape(s.place + (s.way.empty() ? "" : " (" + s.way + ")")),
          html_escape(s.parameter), smallest_html(s), html_number(s.noncentrality, 2)},
         ""});
  }
  if (rows.empty()) return "";
  return "<h3>Smallest size that would show</h3>\n" +
         html_table("Of each effect at the place where it shows most. Noncentrality: of the size "
                    "that can be "
                    "expected of it.",
                    {{"effect", "", false},
                     {"place", "", false},
                     {"parameter", "", false},
                     {"smallest", ""},
                     {"noncentrality", ""}},
                    rows);
}

std::string next_html(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  double most = 0;
  for (const ProposedMeasurement& m : d.next) most = std::max(most, m.change);
  for (const ProposedMeasurement& m : d.next)
    rows.push_back({{html_escape(m.what), html_escape(m.about), html_number(100 * m.change, 2),
                     bar_svg({.from = 0, .to = m.change, .high = most}), html_number(m.cost, 2),
                     html_escape(m.separates), html_number(m.separation, 3)},
                    ""});
  std::string html;
  if (!rows.empty())
    html = html_table("Change: expected of the shares of the ledger, over the sets of effects and "
                      "their numbers that the test leaves open; by change per hour. Separation: of "
                      "two sets, expected squared difference over its uncertainty; 25 is beyond "
                      "doubt.",
                      {{"measurement", "", false},
                       {"about the share of", "", false},
                       {"change", "% of the gap"},
                       {"", "", false},
                       {"cost", "hours at the rig"},
                       {"separates", "", false},
                       {"separation", ""}},
                      rows);
  return html + html_list(d.advice);
}

} // namespace plica
