#include "diagnose/weigh/blocks.hpp"
#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/tables/located_gaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

constexpr double full_tint = 6; // standard score

std::string score(const LocatedGap& b) {
  const std::string z = html_signed(b.z, 1);
  if (!b.significant) return tinted(b.z, full_tint, z);
  return tinted(b.z, full_tint, fmt::format("<b>{}\u00a0{}</b>", b.z < 0 ? "▼" : "▲", z));
}

std::string row_name(const LocatedGap& b) {
  std::string name = b.direction;
  for (const std::string& part : {b.band, b.state})
    if (!part.empty()) name += (name.empty() ? "" : ", ") + part;
  return name.empty() ? kind_word(b) : name;
}

// One kind of reading: rows in the order of the test, a column for every level.
std::string heat_map(const Diagnosis& d, ReadingKind kind) {
  std::vector<LocatedGap> blocks;
  std::vector<std::string> names;
  std::set<double> levels; // 0: not stated
  for (const LocatedGap& b : d.where) {
    if (!b.component.empty() || b.kind != kind) continue;
    blocks.push_back(b);
    levels.insert(b.level.value_or(0));
    if (std::find(names.begin(), names.end(), row_name(b)) == names.end())
      names.push_back(row_name(b));
  }
  if (blocks.empty()) return "";
  std::vector<HtmlColumn> columns{{"base, peak", "", false}};
  for (const double level : levels)
    columns.push_back(level > 0 ? HtmlColumn{fmt::format("{:g}", level), "m/s²"}
                                : HtmlColumn{levels.size() > 1 ? "no level" : "z", ""});
  std::vector<HtmlRow> rows;
  for (const std::string& name : names) {
    HtmlRow row{{html_escape(name)}, ""};
    for (const double level : levels) {
      const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const LocatedGap& b) {
        return row_name(b) == name && b.level.value_or(0) == level;
      });
      row.cells.push_back(found == blocks.end() ? dash : score(*found));
    }
    rows.push_back(std::move(row));
  }
  return "<div><h3>" +
         html_escape(kind == ReadingKind::cross ? "motion along other axes" : word_of(kind)) +
         "</h3>\n" + html_table("", columns, rows) + "</div>\n";
}

bool is_still(ReadingKind kind) {
  return kind == ReadingKind::mass || kind == ReadingKind::stiffness ||
         kind == ReadingKind::dynamic_stiffness || kind == ReadingKind::loss;
}

// Mass, stiffness and what a rig reads: no runs, one column.
std::string still_readings(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  for (const LocatedGap& b : d.where)
    if (b.component.empty() && b.kind && is_still(*b.kind))
      rows.push_back({{html_escape(name_of(b)), score(b)}, ""});
  if (rows.empty()) return "";
  return "<div><h3>mass and stiffness</h3>\n" + html_table("", {{"", "", false}, {"z", ""}}, rows) +
         "</div>\n";
}

std::string drifts_table(const Diagnosis& d) {
  std::vector<HtmlRow> rows;
  for (const ParameterDrift& drift : d.drifts) {
    std::string parts;
    for (const auto& [part, estimate] : drift.parts)
      parts += fmt::format("{}{}: {} ± {}", parts.empty() ? "" : "; ", html_escape(part),
                           html_number(estimate[0], 3), html_number(estimate[1], 2));
    const std::string p = html_number(drift.p, 2);
    rows.push_back({{html_escape(drift.parameter), html_escape(drift.by), parts,
                     drift.p < 0.05 ? "<b>" + p + "</b>" : p},
                    ""});
  }
  if (rows.empty()) return "";
  return "<h3>Drift of parameters</h3>\n" +
         html_table("Each estimated from parts of the readings alone. A parameter that drifts is "
                    "not the cause, or not its law; bold: p below 0.05.",
                    {{"parameter", "", false},
                     {"apart by", "", false},
                     {"estimates", "", false},
                     {"p that they are equal", ""}},
                    rows);
}

} // namespace

std::string blocks_html(const Diagnosis& d) {
  std::string html = still_readings(d);
  for (const ReadingKind kind :
       {ReadingKind::frequency, ReadingKind::damping, ReadingKind::amplitude, ReadingKind::cross,
        ReadingKind::component})
    html += heat_map(d, kind);
  if (html.empty()) return "";
  return "<p class=\"note\">Standard scores of the readings against admissible specimens, nominal "
         "case. Above zero the test shows more than the model. ▲ ▼ and bold: significant at 5 % "
         "over all blocks (Holm). The ground deepens up to 6.</p>\n"
         "<div style=\"display:flex;flex-wrap:wrap;gap:0 3.5rem\">\n" +
         html + "</div>\n";
}

std::string components_html(const Diagnosis& d) {
  const std::vector<LocatedGap> list = located_components(d);
  double low = 0, high = 0;
  for (const LocatedGap& b : list) {
    low = std::min(low, b.z);
    high = std::max(high, b.z);
  }
  std::vector<HtmlRow> rows;
  rows.reserve(list.size());
  for (const LocatedGap& b : list)
    rows.push_back(
        {{html_escape(name_of(b)), html_signed(b.z, 1),
          bar_svg({.from = 0, .to = b.z, .low = low, .high = high, .mark = 0, .width = 16})},
         b.significant ? "nominal" : ""});
  if (rows.empty()) return "";
  return "<h3>Components</h3>\n" +
         html_table(
             "Root of twice the ln BF of the best hypothesis at that place; shaded: ln BF above 3. "
             "Residual energy: of a measured shape over many channels, against admissible "
             "specimens.",
             {{"component", "", false}, {"z", ""}, {"", "", false}}, rows);
}

std::string trends_html(const Diagnosis& d) {
  double reach = 0;
  for (const LevelTrend& t : d.trends)
    reach = std::max(reach, std::abs(t.slope) + 2 * std::max(0., t.sigma));
  std::vector<HtmlRow> rows;
  for (const LevelTrend& t : d.trends) {
    const std::string slope = html_signed(t.slope, 3);
    const bool clear = std::abs(t.slope) > 2 * t.sigma;
    rows.push_back(
        {{html_escape(t.quantity), clear ? "<b>" + slope + "</b>" : slope, html_number(t.sigma, 2),
          html_signed(t.best, 3), html_signed(100 * (std::exp2(t.slope) - 1), 1),
          bar_svg({.from = t.slope - 2 * t.sigma,
                   .to = t.slope + 2 * t.sigma,
                   .low = -reach,
                   .high = reach,
                   .mark = 0})},
         ""});
  }
  std::string html;
  if (!rows.empty())
    html = "<h3>Over the level</h3>\n" +
           html_table("Slope of the test: d ln / d ln level. Bar: ± 2 sigma about it, upright line "
                      "at zero; bold: beyond 2 sigma.",
                      {{"", "", false},
                       {"slope", ""},
                       {"sigma", ""},
                       {"with the best hypothesis", ""},
                       {"at twice the level", "%"},
                       {"", "", false}},
                      rows);
  return html + drifts_table(d);
}

} // namespace plica
