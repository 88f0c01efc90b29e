#include "io/tables/life_words.hpp"

#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"
#include "run/results/number_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

std::string megapascal(double stress) {
  return significant(1e-6 * stress, 4);
}

// What is nothing beside the stress it is a part of is nothing.
std::string part_of(double part, double whole) {
  return megapascal(std::abs(part) < 1e-9 * std::abs(whole) ? 0 : part);
}

std::string millimetres(const std::array<double, 3>& at) {
  const auto one = [](double x) { return std::round(1e4 * x) / 10 + 0.; }; // no "-0.0"
  return fmt::format("{:.1f}, {:.1f}, {:.1f}", one(at[0]), one(at[1]), one(at[2]));
}

std::string duty_table(const Results& results) {
  const LifeResult& life = *results.life;
  TextRows rows{{"", "", "where", "count", "range MPa", "mesh %", "life", "5 to 95 %", "damage"}};
  for (const DutyResult& d : life.duties) {
    const LifeSpot& spot = life.spots[std::size_t(d.spot)];
    rows.push_back({word_of(d.kind) + (" " + d.name), d.what,
                    place_words(results.places[std::size_t(spot.place)], spot.outer),
                    significant(d.count, 4) + " " + d.unit, megapascal(d.range),
                    duty_mesh_error(results, d), d.life ? life_words(*d.life) : "-",
                    between_words(d), bounded(significant(d.damage, 3), d.at_most, d.at_least)});
  }
  return text_table(rows, "<<<>");
}

std::string random_duties(const Results& results) {
  TextRows rows{{"", "RMS MPa", "3 sigma", "expected peak", "zero crossings Hz"}};
  for (const DutyResult& d : results.life->duties) {
    if (!d.random) continue;
    const RandomStress& r = *d.random;
    if (rows.size() == 1)
      for (const auto& [method, damage] : r.damages) rows[0].push_back(method);
    rows.push_back({d.name, megapascal(r.rms), megapascal(3 * r.rms), megapascal(r.expected_peak),
                    significant(r.up_crossings, 4)});
    for (const auto& [method, damage] : r.damages) rows.back().push_back(significant(damage, 3));
  }
  return rows.size() == 1
             ? ""
             : "\nRandom stress at the hot spot, damage by each method\n" + text_table(rows, "<>");
}

std::string spot_table(const Results& results) {
  constexpr std::size_t most = 8;
  TextRows rows{{"", "at x, y, z mm", "damage"}};
  for (const LifeSpot& s : results.life->spots) {
    if (rows.size() > most) break;
    rows.push_back({place_words(results.places[std::size_t(s.place)], s.outer), millimetres(s.at),
                    bounded(significant(s.damage, 3), s.at_most, s.at_least)});
  }
  return "\nHot spots by damage\n" + text_table(rows, "<<>");
}

} // namespace

std::string place_words(const StressPlace& place, bool outer, int ply) {
  const std::string on = ply > 0 ? fmt::format(", ply {}", ply) : "";
  if (place.name.empty()) return place.part + (outer ? ", face above" : ", face below") + on;
  return place.part + " " + place.name + (outer ? ", outer face" : ", inner face") + on;
}

const PlaceStress* hottest(const StressTable& table) {
  const auto top = std::max_element(table.rows.begin(), table.rows.end(),
                                    [](const PlaceStress& a, const PlaceStress& b) {
                                      return std::abs(a.von_mises) < std::abs(b.von_mises);
                                    });
  return top == table.rows.end() ? nullptr : &*top;
}

std::string bounded(const std::string& number, bool at_most, bool at_least) {
  if (at_most == at_least) return number;
  return (at_most ? "at most " : "at least ") + number;
}

std::string life_words(const CurveLife& life) {
  if (std::isinf(life.cycles)) return "unlimited";
  const std::string number = life.cycles < 1e15 ? grouped(static_cast<long long>(life.cycles), " ")
                                                : significant(life.cycles, 4);
  return bounded(number, life.bound == Bound::at_most, life.bound == Bound::at_least);
}

std::string damage_words(const std::array<double, 2>& between) {
  return significant(between[0], 3) + " to " + significant(between[1], 3);
}

std::string between_words(const DutyResult& d) {
  if (d.between) return life_words((*d.between)[0]) + " to " + life_words((*d.between)[1]);
  if (!d.damage_between) return "-";
  return "damage " + bounded(damage_words(*d.damage_between), d.at_most, d.at_least);
}

std::string life_kind(const LifeResult& life) {
  const std::string tolerances =
      life.with_tolerances ? "the tolerances of the case" : std::string();
  if (!life.deviation)
    return (life.design ? "Design: allowed cycles"
                        : "Cycles as the curve has them: no deviation is given, so no scatter") +
           (tolerances.empty() ? "" : ", intervals (5 to 95 %) from " + tolerances + " alone") +
           ".";
  return fmt::format("Mean curve: half of the parts fail before; intervals (5 to 95 %) from a "
                     "standard deviation of {} in log10 of the cycles{}.",
                     significant(*life.deviation, 3),
                     tolerances.empty() ? "" : " and " + tolerances);
}

std::string repeats_words(const LifeResult& life) {
  if (life.spots.empty() || !(life.spots[0].damage > 0)) return "";
  const LifeSpot& s = life.spots[0];
  const auto& between = life.damage_between;
  const std::string interval =
      !between ? "" : " (5 to 95 %: " + damage_words({1 / (*between)[1], 1 / (*between)[0]}) + ")";
  return fmt::format("All of it comes to damage 1 {} times{}.",
                     bounded(significant(1 / s.damage, 3), s.at_least, s.at_most), interval);
}

std::string duty_mesh_error(const Results& results, const DutyResult& duty) {
  for (const ErrorBar& bar : results.error_bars.bars)
    if (bar.key == number_key::of(NumberKind::stress_range, duty.name))
      return mesh_error_percent(bar.value, bar.mesh);
  return "-";
}

std::string place_mesh_error(const Results& results, std::size_t table, std::size_t row) {
  const auto& errors = results.error_bars.places;
  if (table >= errors.size() || row >= errors[table].size()) return "-";
  return mesh_error_percent(std::abs(results.stress_tables[table].rows[row].von_mises),
                            errors[table][row]);
}

std::string life_summary(const Results& results) {
  if (!results.life || results.life->duties.empty()) return "";
  const LifeResult& life = *results.life;
  return "\nLife, " + life.measure + "\n" + duty_table(results) + random_duties(results) +
         spot_table(results) + "  " + life.curve + "\n  " + life_kind(life) + " " +
         repeats_words(life) + "\n";
}

std::string stress_summary(const Results& results) {
  TextRows rows{{"", "where", "von Mises MPa", "mesh %", "membrane", "bending", "at x, y, z mm"}};
  const std::vector<MeshError>& errors = results.error_bars.stresses;
  for (std::size_t i = 0; i < results.stresses.size(); ++i) {
    const StressResult& s = results.stresses[i];
    const bool beam = s.largest_beam > s.largest;
    const double value = std::max(s.largest, s.largest_beam);
    const auto& at = beam ? s.beam_at : s.at;
    const PlaceStress* top =
        beam || i >= results.stress_tables.size() ? nullptr : hottest(results.stress_tables[i]);
    const bool named = top && std::isfinite(top->meridional);
    rows.push_back({s.name,
                    top ? place_words(results.places[std::size_t(top->place)], top->outer, top->ply)
                        : (beam ? "a beam" : "-"),
                    megapascal(value), errors.empty() ? "-" : mesh_error_percent(value, errors[i]),
                    named ? part_of(top->meridional_membrane, value) : "-",
                    named ? part_of(top->meridional_bending, value) : "-", millimetres(at)});
  }
  return rows.size() == 1 ? ""
                          : "\nLargest stress; membrane and bending along the meridian\n" +
                                text_table(rows, "<<>");
}

} // namespace plica
