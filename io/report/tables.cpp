#include "io/report/tables.hpp"

#include "io/report/markup.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

constexpr const char* thin_space = "\u202f";

std::string shown(double value, const std::string& unit, int digits) {
  const auto [factor, shown_in] = shown_unit(value, unit);
  return html_number(value * factor, digits) + "\u00a0" + shown_in;
}

std::string size_of(int value) {
  return grouped(value, thin_space);
}

} // namespace

std::string statics_html(const Results& results) {
  if (!results.statics) return "";
  std::vector<HtmlColumn> columns{{"", "", false}};
  HtmlRow values{{"stiffness"}, ""}, missing{{"mesh error, %"}, ""};
  const std::vector<MeshError>& errors = results.error_bars.statics;
  for (std::size_t i = 0; i < stiffness_names.size(); ++i) {
    const double value = results.statics->all()[i];
    const auto [factor, shown_in] = shown_unit(value, stiffness_unit(i));
    columns.push_back({stiffness_names[i], shown_in});
    values.cells.push_back(html_number(value * factor, 5));
    if (!errors.empty()) missing.cells.push_back(mesh_error_percent(value, errors[i]));
  }
  std::vector<HtmlRow> rows{values};
  std::string note = "Between the two end caps, one held. Transverse: the end kept parallel. "
                     "Bending: moment over rotation of a free end, about x and z.";
  if (!errors.empty()) {
    rows.push_back(missing);
    note += " Mesh error: what the stiffness is estimated to change by on a converged mesh.";
  }
  return html_table(note, columns, rows);
}

namespace {

std::string in_one_line(const std::string& text) {
  return "<span class=\"line\">" + text + "</span>";
}

HtmlRow mass_row(const std::string& head, const std::array<double, 6>& masses,
                 const std::array<int, 6>& decimals) {
  HtmlRow row{{"", in_one_line(head), "", ""}, "total"};
  for (std::size_t i = 0; i < 6; ++i) {
    row.cells.push_back(html_fixed(masses[i], decimals[i]));
  }
  row.cells.push_back("");
  return row;
}

// What rounds to nothing is a faint zero, so that the masses that count stand out.
std::string mass_cell(double mass, int decimals) {
  const bool is_nothing = std::isfinite(mass) && std::abs(mass) < 0.5 * std::pow(10, -decimals);
  return is_nothing ? "<span class=\"faint\">0</span>" : html_fixed(mass, decimals);
}

} // namespace

std::string modes_html(const Results& results) {
  if (results.modes.empty()) return "";
  std::array<int, 6> decimals{};
  for (std::size_t i = 0; i < 6; ++i) decimals[i] = decimals_for(results.free_mass[i], 4);
  std::vector<HtmlColumn> columns{
      {"mode", ""},           {"shape", "", false},   {"frequency", "Hz"}, {"damping", "%"},
      {"mass x", "kg"},       {"mass y", "kg"},       {"mass z", "kg"},    {"inertia x", "kg m²"},
      {"inertia y", "kg m²"}, {"inertia z", "kg m²"}, {"residual", ""}};
  const std::vector<MeshError>& errors = results.error_bars.modes;
  if (!errors.empty()) columns.push_back({"mesh error", "%"});
  std::vector<HtmlRow> rows;
  for (const ModeResult& mode : results.modes) {
    HtmlRow row{{std::to_string(rows.size() + 1), in_one_line(html_escape(mode_label(mode))),
                 html_fixed(mode.frequency, 2), html_number(100 * mode.damping, 3)},
                ""};
    for (std::size_t i = 0; i < 6; ++i) {
      row.cells.push_back(mass_cell(mode.effective_mass[i], decimals[i]));
    }
    row.cells.push_back(html_number(mode.residual, 2));
    if (!errors.empty()) row.cells.push_back(mesh_error_percent(mode, errors[rows.size()]));
    rows.push_back(std::move(row));
  }
  rows.push_back(mass_row("sum of the modes", results.effective_mass_sum, decimals));
  rows.push_back(mass_row("free mass", results.free_mass, decimals));
  return html_table("Effective mass and inertia per direction (along the pipe: y); inertia about "
                    "the centre of mass of the free part. Mesh error: what the frequency is "
                    "estimated to change by on a converged mesh.",
                    columns, rows);
}

std::string variants_html(const Results& results) {
  if (results.variants.empty()) return "";
  const std::map<std::string, double> nominal = headline(results);
  std::vector<HtmlColumn> columns{{"variant", "", false}, {"what is set", "", false}};
  std::vector<double> factors;
  const std::vector<HeadlineQuantity> quantities = headline_quantities(results);
  for (const HeadlineQuantity& quantity : quantities) {
    const auto value = nominal.find(quantity.key);
    const ShownUnit unit = shown_unit(value == nominal.end() ? 0 : value->second, quantity.unit);
    columns.push_back({html_escape(quantity.name), unit.unit});
    factors.push_back(unit.factor);
  }
  const auto row_of = [&](const std::string& name, const std::string& set,
                          const std::map<std::string, double>& values, bool is_nominal) {
    HtmlRow row{{name, set}, is_nominal ? "nominal" : ""};
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const auto value = values.find(quantities[i].key);
      std::string cell = value == values.end() ? "–" : html_number(value->second * factors[i], 4);
      const auto base = nominal.find(quantities[i].key);
      if (!is_nominal && value != values.end() && base != nominal.end() && base->second != 0) {
        cell += fmt::format(" <span class=\"change\">{} %</span>",
                            html_signed(100 * (value->second / base->second - 1), 1));
      }
      row.cells.push_back(cell);
    }
    return row;
  };
  std::vector<HtmlRow> rows{row_of("nominal", "as drawn", nominal, true)};
  for (const VariantResult& variant : results.variants) {
    std::string set;
    for (const auto& [path, value] : variant.set) {
      set += fmt::format("<div><code>{}</code>: {}</div>", html_escape(path), html_escape(value));
    }
    rows.push_back(row_of(html_escape(variant.name), set, variant.headline, false));
  }
  return html_table("The same case with assumed quantities changed; small: change against nominal.",
                    columns, rows);
}

std::string variants_comparison_html(const Results& results) {
  if (results.variants.empty() || results.comparison.empty()) return "";
  std::vector<HtmlColumn> columns{
      {"quantity", "", false}, {"unit", "", false}, {"measured", ""}, {"nominal", ""}};
  for (const VariantResult& variant : results.variants)
    columns.push_back({html_escape(variant.name), ""});
  std::vector<HtmlRow> rows;
  for (const MeasuredComparison& row : results.comparison) {
    const auto [factor, unit] = shown_unit(row.measured, row.unit);
    const int decimals = decimals_of(row, factor);
    HtmlRow cells{{html_escape(row.quantity), html_escape(unit),
                   html_fixed(row.measured * factor, decimals),
                   "<strong>" + html_fixed(row.computed * factor, decimals) + "</strong>"},
                  ""};
    for (const VariantResult& variant : results.variants) {
      std::string cell = "–";
      for (const MeasuredComparison& other : variant.comparison)
        if (other.quantity == row.quantity && other.measured == row.measured)
          cell = html_fixed(other.computed * factor, decimals);
      cells.cells.push_back(cell);
    }
    rows.push_back(std::move(cells));
  }
  return html_table("What was measured, as each variant computes it.", columns, rows);
}

std::string model_html(const Results& results) {
  const ModelSize& model = results.model;
  const MeshQuality& quality = results.quality;
  std::string html = html_table(
      "", {{"", "", false}, {"", "", false}},
      {{{"nodes", size_of(model.nodes)}, ""},
       {{"elements", size_of(model.elements)}, ""},
       {{"mesh", results.mesh_choice.empty() ? "as the case says" : results.mesh_choice}, ""},
       {{"unknowns before the mount holds any", size_of(model.dofs)}, ""},
       {{"mass", shown(model.mass, "kg", 5)}, ""},
       {{"largest warp of a quad (corner off its plane / edge)", html_number(quality.max_warp, 2)},
        ""},
       {{"aspect ratio, mean", html_number(quality.mean_aspect, 3)}, ""},
       {{"aspect ratio, largest", html_number(quality.max_aspect, 3)}, ""},
       {{"smallest corner Jacobian / largest of its quad", html_number(quality.min_jacobian, 2)},
        ""},
       {{"solved by", html_escape(results.route)}, ""}});
  if (results.sensors.empty()) return html;
  std::vector<HtmlRow> rows;
  for (const SensorResult& sensor : results.sensors) {
    rows.push_back({{html_escape(sensor.name), std::to_string(sensor.node),
                     html_number(1e3 * sensor.distance, 2)},
                    ""});
  }
  return html + html_table("Sensors sit on the nearest node, or between the nodes of a shell.",
                           {{"sensor", "", false}, {"node", ""}, {"distance to it", "mm"}}, rows);
}

std::string timing_html(const Results& results) {
  std::vector<std::pair<std::string, double>> stages(results.timing.begin(), results.timing.end());
  std::stable_sort(stages.begin(), stages.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<HtmlRow> rows;
  rows.reserve(stages.size());
  for (const auto& [stage, seconds] : stages) {
    rows.push_back({{html_escape(stage), html_fixed(seconds, 2)}, ""});
  }
  std::string html;
  if (!rows.empty()) html = html_table("", {{"stage", "", false}, {"time", "s"}}, rows);
  if (results.peak_memory > 0) {
    html += fmt::format("<p>Peak memory {} MB.</p>\n", html_number(results.peak_memory / 1e6, 3));
  }
  return html;
}

} // namespace plica
