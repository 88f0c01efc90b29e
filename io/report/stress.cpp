#include "io/report/stress.hpp"

#include "io/report/markup.hpp"
#include "io/report/picture.hpp"
#include "io/report/plot.hpp"
#include "io/tables/life_words.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace plica {
namespace {

std::string with_dash(const std::string& percent) {
  return percent == "-" ? "–" : html_escape(percent);
}

std::string in_MPa(double stress) {
  return html_number(1e-6 * stress, 3);
}

// What is nothing beside the stress it is a part of is nothing.
std::string part_of(double part, double whole) {
  return in_MPa(std::abs(part) < 1e-9 * std::abs(whole) ? 0 : part);
}

std::string largest_table(const Results& results) {
  bool beams = false;
  for (const StressResult& s : results.stresses) beams = beams || s.largest_beam > 0;
  std::vector<HtmlColumn> columns{{"stress of", "", false},
                                  {"von Mises", "MPa"},
                                  {"where", "", false},
                                  {"along the meridian: membrane", "MPa"},
                                  {"bending", "MPa"},
                                  {"around: membrane", "MPa"},
                                  {"bending", "MPa"},
                                  {"at x", "mm"},
                                  {"y", "mm"},
                                  {"z", "mm"}};
  if (beams) columns.push_back({"beams, axial", "MPa"});
  const std::vector<MeshError>& errors = results.error_bars.stresses;
  if (!errors.empty()) columns.push_back({"mesh error", "%"});
  std::vector<HtmlRow> rows;
  for (std::size_t i = 0; i < results.stresses.size(); ++i) {
    const StressResult& s = results.stresses[i];
    const PlaceStress* top =
        i < results.stress_tables.size() ? hottest(results.stress_tables[i]) : nullptr;
    HtmlRow row{{html_escape(s.name), html_number(s.largest / 1e6, 4),
                 top ? html_escape(place_words(results.places[std::size_t(top->place)], top->outer,
                                               top->ply))
                     : s.face},
                ""};
    for (const double x :
         {top ? top->meridional_membrane : std::nan(""),
          top ? top->meridional_bending : std::nan(""), top ? top->hoop_membrane : std::nan(""),
          top ? top->hoop_bending : std::nan("")})
      row.cells.push_back(part_of(x, s.largest));
    for (const double x : s.at) row.cells.push_back(html_fixed(1e3 * x, 1));
    if (beams) row.cells.push_back(html_number(s.largest_beam / 1e6, 4));
    if (!errors.empty()) {
      const double share = errors[i].total() / std::max(s.largest, s.largest_beam);
      row.cells.push_back(std::isfinite(share) ? html_signed(100 * share, 1) : "–");
    }
    rows.push_back(std::move(row));
  }
  return html_table(
      "Largest over the part. Shells on both faces (above: the side the normal points "
      "to, outside of a pipe); harmonic: largest over a cycle. Membrane is the mean of both faces, "
      "bending half of outer less inner. Mesh error: what the largest of the "
      "row is estimated to change by on a converged mesh. Fields in "
      "<code>stress.vtu</code>, every place and ply in <code>stress_places.csv</code>.",
      columns, rows);
}

bool is_shown_by_place(const StressTable& t) {
  return t.kind != StressKind::mode && !t.rows.empty();
}

// Meridional stress along the wall of what is no mode, folded from the fourth on.
std::string meridians(const Results& results) {
  std::string html;
  int count = 0;
  for (const StressTable& t : results.stress_tables) {
    if (!t.meridian || !is_shown_by_place(t)) continue;
    const MeridianStress& m = *t.meridian;
    const Eigen::VectorXd along = 1e3 * m.along;
    const std::vector<PlotCurve> curves{
        {.x = along, .y = 1e-6 * m.outer, .name = "outer face"},
        {.x = along, .y = 1e-6 * m.inner, .name = "inner face"},
        {.x = along,
         .y = 1e-6 * m.membrane,
         .name = t.kind == StressKind::rms || t.kind == StressKind::harmonic ? "mean of both"
                                                                             : "membrane",
         .faint = true}};
    const std::string what = t.kind == StressKind::harmonic ? ", amplitude" : "";
    const std::string plot =
        plot_figure({.label = "meridional stress, " + t.name,
                     .abscissa = "length of the meridian of " + m.part + " from its left end, mm",
                     .ordinate = "meridional stress" + what + ", MPa",
                     .linear = true},
                    curves) +
        plot_legend(curves);
    const std::string head = html_escape(t.name);
    html += ++count <= 3 ? "<h3>" + head + "</h3>\n" + plot
                         : "<details><summary>" + head + "</summary>\n" + plot + "</details>\n";
  }
  return html;
}

// Every place of one load case, folded.
std::string places_table(const Results& results, std::size_t table) {
  const StressTable& t = results.stress_tables[table];
  const bool errors = table < results.error_bars.places.size();
  std::vector<HtmlColumn> columns{
      {"place", "", false}, {"von Mises", ""}, {"principal 1", ""}, {"2", ""},
      {"meridional", ""},   {"membrane", ""},  {"bending", ""},     {"hoop", ""},
      {"membrane", ""},     {"bending", ""}};
  if (errors) columns.insert(columns.begin() + 2, {"mesh error", "%"});
  std::vector<HtmlRow> rows;
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const PlaceStress& r = t.rows[i];
    HtmlRow row{{html_escape(place_words(results.places[std::size_t(r.place)], r.outer, r.ply))},
                ""};
    for (const double x :
         {r.von_mises, r.principal[0], r.principal[1], r.meridional, r.meridional_membrane,
          r.meridional_bending, r.hoop, r.hoop_membrane, r.hoop_bending})
      row.cells.push_back(part_of(x, r.von_mises));
    if (errors)
      row.cells.insert(row.cells.begin() + 2, with_dash(place_mesh_error(results, table, i)));
    rows.push_back(std::move(row));
  }
  return "<details><summary>By place: " + html_escape(t.name) + "</summary>\n" +
         html_table("MPa, at the point of each place and face with the largest von Mises stress, "
                    "which has the sign of the principal stress of larger magnitude. Mesh error: "
                    "what its magnitude is estimated to change by on a converged mesh.",
                    columns, rows) +
         "</details>\n";
}

std::string duties_table(const Results& results) {
  const LifeResult& life = *results.life;
  std::vector<HtmlRow> rows;
  for (const DutyResult& d : life.duties) {
    const LifeSpot& spot = life.spots[std::size_t(d.spot)];
    rows.push_back(
        {{html_escape(word_of(d.kind) + (" " + d.name)), html_escape(d.what),
          html_escape(place_words(results.places[std::size_t(spot.place)], spot.outer)),
          html_number(d.count, 4) + " " + d.unit, in_MPa(d.range),
          with_dash(duty_mesh_error(results, d)), d.life ? html_escape(life_words(*d.life)) : "–",
          d.between || d.damage_between ? html_escape(between_words(d)) : "–",
          bounded(html_number(d.damage, 3), d.at_most, d.at_least)},
         ""});
  }
  return html_table(html_escape(life.curve) + ". " + html_escape(life_kind(life)) + " " +
                        html_escape(repeats_words(life)),
                    {{"duty", "", false},
                     {"", "", false},
                     {"hot spot", "", false},
                     {"count", ""},
                     {"largest range", "MPa"},
                     {"mesh error", "%"},
                     {"life", "cycles"},
                     {"5 to 95 %", "", false},
                     {"damage", ""}},
                    rows);
}

std::string spots_table(const Results& results) {
  constexpr std::size_t most = 20;
  const LifeResult& life = *results.life;
  std::vector<HtmlColumn> columns{
      {"hot spot", "", false}, {"at x", "mm"}, {"y", "mm"}, {"z", "mm"}, {"damage", ""}};
  for (const DutyResult& d : life.duties) columns.push_back({"by " + html_escape(d.name), ""});
  std::vector<HtmlRow> rows;
  for (const LifeSpot& s : life.spots) {
    if (rows.size() == most) break;
    HtmlRow row{{html_escape(place_words(results.places[std::size_t(s.place)], s.outer))}, ""};
    for (const double x : s.at) row.cells.push_back(html_fixed(1e3 * x, 1));
    row.cells.push_back(bounded(html_number(s.damage, 3), s.at_most, s.at_least));
    for (const double d : s.by_duty) row.cells.push_back(html_number(d, 3));
    rows.push_back(std::move(row));
  }
  return "<h3>Hot spots</h3>\n" +
         html_table("The worst point of each place and face, most damage first, of cycles on the "
                    "curve before those below it; all of them in "
                    "<code>life.csv</code>.",
                    columns, rows);
}

std::string densities(const Results& results) {
  std::string html;
  for (const DutyResult& d : results.life->duties) {
    if (!d.random) continue;
    const RandomStress& r = *d.random;
    const std::vector<PlotCurve> curves{{.x = r.hertz, .y = 1e-12 * r.density, .name = "stress"}};
    std::string methods;
    for (const auto& [method, damage] : r.damages)
      methods += (methods.empty() ? "" : ", ") + method + " " + html_number(damage, 3);
    html += "<h3>Random stress, " + html_escape(d.name) + "</h3>\n" +
            plot_figure({.label = "density of the stress, " + d.name,
                         .ordinate = "density at the hot spot, MPa²/Hz"},
                        curves) +
            fmt::format("<p>RMS {} MPa, 3 sigma {} MPa, expected peak {} MPa, {} zero crossings "
                        "a second. Damage by the methods: {}.</p>\n",
                        html_number(1e-6 * r.rms, 3), html_number(3e-6 * r.rms, 3),
                        html_number(1e-6 * r.expected_peak, 3), html_number(r.up_crossings, 4),
                        methods);
  }
  return html;
}

// On both faces of the wall through the first hot spot.
std::string damage_along(const Results& results, const std::string& what) {
  const auto& m = results.life->meridian;
  if (!m) return "";
  const auto above_zero = [](const Eigen::VectorXd& damage) {
    return Eigen::VectorXd(damage.unaryExpr([](double d) { return d > 0 ? d : std::nan(""); }));
  };
  const Eigen::VectorXd along = 1e3 * m->along;
  const std::vector<PlotCurve> curves{
      {.x = along, .y = above_zero(m->outer), .name = "outer face", .colour = 0},
      {.x = along, .y = above_zero(m->inner), .name = "inner face", .colour = 1}};
  if (!(curves[0].y.array() > 0).any() && !(curves[1].y.array() > 0).any()) return "";
  return "<h3>Along the meridian through the hot spot: " + html_escape(what) + "</h3>\n" +
         plot_figure({.label = "damage along the meridian",
                      .abscissa = "length of the meridian of " + m->part + " from its left end, mm",
                      .ordinate = "damage"},
                     curves) +
         plot_legend(curves);
}

} // namespace

std::string stresses_html(const Results& results) {
  if (results.stresses.empty()) return "";
  std::string html = largest_table(results) + meridians(results);
  for (std::size_t i = 0; i < results.stress_tables.size(); ++i)
    if (is_shown_by_place(results.stress_tables[i])) html += places_table(results, i);
  return html;
}

std::string life_html(const Results& results) {
  if (!results.life || results.life->duties.empty()) return "";
  std::string html = duties_table(results);
  if (const auto fields = shown_fields(results, 1); !fields.empty())
    html += field_picture(results, fields[0]) + damage_along(results, fields[0].name);
  return html + spots_table(results) + densities(results);
}

} // namespace plica
