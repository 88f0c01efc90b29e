#include "io/tables/life_json.hpp"

#include "io/files/json_text.hpp"
#include "io/tables/life_csv.hpp"
#include "io/tables/life_words.hpp"

namespace plica {
namespace {

Json place_json(const Results& results, int place, bool outer, int node,
                const std::array<double, 3>& at) {
  const StressPlace& p = results.places[std::size_t(place)];
  return {{"name", place_words(p, outer)},
          {"part", p.part},
          {"place", p.name},
          {"face", outer ? "above" : "below"},
          {"node", node},
          {"at", {json_number(at[0]), json_number(at[1]), json_number(at[2])}}};
}

Json range_of(const std::optional<std::array<double, 2>>& between) {
  if (!between) return nullptr;
  return {json_number((*between)[0]), json_number((*between)[1])};
}

Json row_json(const Results& results, const PlaceStress& r) {
  Json row = place_json(results, r.place, r.outer, r.node, r.at);
  row["ply"] = r.ply > 0 ? Json(r.ply) : Json(nullptr);
  row["von_mises_signed"] = json_number(r.von_mises);
  row["principal"] = {json_number(r.principal[0]), json_number(r.principal[1])};
  row["meridional"] = json_number(r.meridional);
  row["hoop"] = json_number(r.hoop);
  row["meridional_membrane"] = json_number(r.meridional_membrane);
  row["meridional_bending"] = json_number(r.meridional_bending);
  row["hoop_membrane"] = json_number(r.hoop_membrane);
  row["hoop_bending"] = json_number(r.hoop_bending);
  return row;
}

Json life_of(const CurveLife& life) {
  return {{"cycles", json_number(life.cycles)}, // null: unlimited
          {"bound", life.bound == Bound::exact      ? "exact"
                    : life.bound == Bound::at_least ? "at least"
                                                    : "at most"}};
}

Json random_json(const DutyResult& d) {
  const RandomStress& r = *d.random;
  Json damages = Json::object();
  for (const auto& [method, damage] : r.damages) damages[method] = json_number(damage);
  return {{"rms", json_number(r.rms)},
          {"three_sigma", json_number(3 * r.rms)},
          {"expected_peak", json_number(r.expected_peak)},
          {"up_crossings", json_number(r.up_crossings)},
          {"damages", damages},
          {"file", life_density_file(d.name)}};
}

Json duty_json(const DutyResult& d) {
  Json json{{"kind", word_of(d.kind)},
            {"name", d.name},
            {"what", d.what},
            {"count", json_number(d.count)},
            {"unit", d.unit},
            {"spot", d.spot},
            {"range", json_number(d.range)},
            {"mean", json_number(d.mean)},
            {"damage", json_number(d.damage)},
            {"at_most", d.at_most},
            {"at_least", d.at_least},
            {"life", d.life ? life_of(*d.life) : Json(nullptr)},
            {"between", Json(nullptr)},
            {"damage_between", range_of(d.damage_between)}};
  if (d.between) json["between"] = {life_of((*d.between)[0]), life_of((*d.between)[1])};
  if (d.cycles > 0) json["cycles"] = json_number(d.cycles);
  if (d.random) json["random"] = random_json(d);
  return json;
}

} // namespace

Json stress_places_json(const Results& results) {
  Json list = Json::array();
  const auto& errors = results.error_bars.places;
  for (const StressTable& t : results.stress_tables) {
    Json rows = Json::array();
    const std::size_t table = list.size();
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      rows.push_back(row_json(results, t.rows[i]));
      if (table < errors.size()) {
        const MeshError& e = errors[table][i]; // of |von Mises|, Pa
        rows.back()["mesh_error"] = {{"along", json_number(e.along)},
                                     {"around", json_number(e.around)},
                                     {"cutoff", json_number(e.cutoff)}};
      }
    }
    list.push_back({{"kind", word_of(t.kind)}, {"name", t.name}, {"places", std::move(rows)}});
  }
  return list;
}

Json life_json(const Results& results) {
  if (!results.life) return nullptr;
  const LifeResult& life = *results.life;
  Json duties = Json::array(), spots = Json::array();
  for (const DutyResult& d : life.duties) duties.push_back(duty_json(d));
  for (const LifeSpot& s : life.spots) {
    Json spot = place_json(results, s.place, s.outer, s.node, s.at);
    spot["damage"] = json_number(s.damage);
    spot["at_most"] = s.at_most;
    spot["at_least"] = s.at_least;
    spot["direction"] = json_number(s.direction);
    spot["by_duty"] = Json::array();
    spot["ranges"] = Json::array();
    for (const double d : s.by_duty) spot["by_duty"].push_back(json_number(d));
    for (const double r : s.ranges) spot["ranges"].push_back(json_number(r));
    spots.push_back(std::move(spot));
  }
  return {{"curve", life.curve},
          {"kind", life.deviation ? "mean"
                   : life.design  ? "design"
                                  : "as given"},
          {"deviation", json_number(life.deviation)},
          {"measure", life.measure},
          {"damage_between", range_of(life.damage_between)},
          {"duties", std::move(duties)},
          {"spots", std::move(spots)}};
}

} // namespace plica
