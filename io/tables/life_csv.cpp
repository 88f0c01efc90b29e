#include "io/tables/life_csv.hpp"

#include "io/tables/csv.hpp"
#include "io/tables/life_words.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace plica {
namespace {

void add_line(std::string& text, const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + csv_cell(cells[i]);
  text += '\n';
}

const char* face_word(const StressPlace& place, bool outer) {
  if (place.name.empty()) return outer ? "above" : "below";
  return outer ? "outer" : "inner";
}

const char* bound_word(bool at_most, bool at_least) {
  return at_most == at_least ? "" : at_most ? "at most" : "at least";
}

} // namespace

std::string stress_places_csv(const Results& results) {
  std::string text;
  add_line(text,
           {"kind", "stress of", "part", "place", "face", "ply", "x [m]", "y [m]", "z [m]",
            "von Mises signed [Pa]", "principal 1 [Pa]", "principal 2 [Pa]", "meridional [Pa]",
            "hoop [Pa]", "meridional membrane [Pa]", "meridional bending [Pa]",
            "hoop membrane [Pa]", "hoop bending [Pa]", "mesh error of von Mises [Pa]"});
  const auto& errors = results.error_bars.places;
  for (std::size_t k = 0; k < results.stress_tables.size(); ++k) {
    const StressTable& t = results.stress_tables[k];
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      const PlaceStress& r = t.rows[i];
      const StressPlace& place = results.places[std::size_t(r.place)];
      std::vector<std::string> cells{word_of(t.kind),
                                     t.name,
                                     place.part,
                                     place.name,
                                     face_word(place, r.outer),
                                     r.ply > 0 ? std::to_string(r.ply) : ""};
      for (const double x : r.at) cells.push_back(csv_number(x));
      for (const double s :
           {r.von_mises, r.principal[0], r.principal[1], r.meridional, r.hoop,
            r.meridional_membrane, r.meridional_bending, r.hoop_membrane, r.hoop_bending})
        cells.push_back(csv_number(s));
      cells.push_back(k < errors.size() ? csv_number(errors[k][i].total()) : "");
      add_line(text, cells);
    }
  }
  return text;
}

std::string stress_meridian_csv(const Results& results) {
  std::string text;
  add_line(text, {"kind", "stress of", "part", "along [m]", "meridional inner [Pa]",
                  "meridional outer [Pa]", "meridional membrane [Pa]"});
  for (const StressTable& t : results.stress_tables)
    for (Eigen::Index i = 0; t.meridian && i < t.meridian->along.size(); ++i)
      add_line(text, {word_of(t.kind), t.name, t.meridian->part, csv_number(t.meridian->along[i]),
                      csv_number(t.meridian->inner[i]), csv_number(t.meridian->outer[i]),
                      csv_number(t.meridian->membrane[i])});
  return text;
}

std::string life_meridian_csv(const Results& results) {
  std::string text;
  add_line(text, {"part", "along [m]", "damage inner", "damage outer"});
  if (const auto& m = results.life->meridian)
    for (Eigen::Index i = 0; i < m->along.size(); ++i)
      add_line(text, {m->part, csv_number(m->along[i]), csv_number(m->inner[i]),
                      csv_number(m->outer[i])});
  return text;
}

std::string life_csv(const Results& results) {
  const LifeResult& life = *results.life;
  std::vector<std::string> head{"part",   "place", "face",
                                "x [m]",  "y [m]", "z [m]",
                                "damage", "bound", "critical direction [deg]"};
  for (const DutyResult& d : life.duties) {
    head.push_back("damage by " + d.name);
    head.push_back("range by " + d.name + " [Pa]");
  }
  std::string text;
  add_line(text, head);
  for (const LifeSpot& s : life.spots) {
    const StressPlace& place = results.places[std::size_t(s.place)];
    std::vector<std::string> cells{place.part, place.name, face_word(place, s.outer)};
    for (const double x : s.at) cells.push_back(csv_number(x));
    cells.push_back(csv_number(s.damage));
    cells.emplace_back(bound_word(s.at_most, s.at_least));
    cells.push_back(csv_number(s.direction * 180 / std::numbers::pi));
    for (std::size_t k = 0; k < s.by_duty.size(); ++k) {
      cells.push_back(csv_number(s.by_duty[k]));
      cells.push_back(csv_number(s.ranges[k]));
    }
    add_line(text, cells);
  }
  return text;
}

std::string life_duties_csv(const Results& results) {
  const LifeResult& life = *results.life;
  std::string text;
  add_line(text, {"kind",
                  "name",
                  "what",
                  "count",
                  "unit",
                  "hot spot",
                  "range [Pa]",
                  "mean [Pa]",
                  "mesh error [%]",
                  "life [cycles]",
                  "life bound",
                  "life 5 % [cycles]",
                  "life 95 % [cycles]",
                  "damage",
                  "damage bound",
                  "RMS [Pa]",
                  "zero crossings [Hz]",
                  "3 sigma [Pa]",
                  "expected peak [Pa]",
                  "factors and source",
                  "damage 5 %",
                  "damage 95 %"});
  const auto bound_of = [](const CurveLife& n) {
    return bound_word(n.bound == Bound::at_most, n.bound == Bound::at_least);
  };
  for (const DutyResult& d : life.duties) {
    const LifeSpot& spot = life.spots[std::size_t(d.spot)];
    std::vector<std::string> cells{word_of(d.kind),
                                   d.name,
                                   d.what,
                                   csv_number(d.count),
                                   d.unit,
                                   place_words(results.places[std::size_t(spot.place)], spot.outer),
                                   csv_number(d.range),
                                   csv_number(d.mean),
                                   duty_mesh_error(results, d),
                                   d.life ? csv_number(d.life->cycles) : "",
                                   d.life ? bound_of(*d.life) : "",
                                   d.between ? csv_number((*d.between)[0].cycles) : "",
                                   d.between ? csv_number((*d.between)[1].cycles) : "",
                                   csv_number(d.damage),
                                   bound_word(d.at_most, d.at_least)};
    for (const double x :
         {d.random ? d.random->rms : std::nan(""), d.random ? d.random->up_crossings : std::nan(""),
          d.random ? 3 * d.random->rms : std::nan(""),
          d.random ? d.random->expected_peak : std::nan("")})
      cells.push_back(csv_number(x));
    cells.push_back(life.curve);
    for (std::size_t i : {0, 1})
      cells.push_back(d.damage_between ? csv_number((*d.damage_between)[i]) : "");
    add_line(text, cells);
  }
  return text;
}

std::string life_density_file(const std::string& duty) {
  return "life_density_" + duty + ".csv";
}

std::string life_density_csv(const DutyResult& duty) {
  std::string text = "frequency [Hz],stress density at the hot spot [Pa2/Hz]\n";
  for (Eigen::Index i = 0; i < duty.random->hertz.size(); ++i)
    text += csv_number(duty.random->hertz[i]) + "," + csv_number(duty.random->density[i]) + "\n";
  return text;
}

} // namespace plica
