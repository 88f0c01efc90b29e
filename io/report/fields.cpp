#include "io/report/fields.hpp"

#include "io/tables/life_words.hpp"
#include "io/tables/text.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::VectorXd;

constexpr double decades = 6; // of the damage that is shown

std::optional<ShownField> damage_field(const Results& results) {
  if (!results.life || results.life->spots.empty()) return std::nullopt;
  const LifeResult& life = *results.life;
  const LifeSpot& spot = life.spots[0];
  double largest = 0;
  for (const VectorXd* face : {&life.inner, &life.outer})
    for (const double d : *face)
      if (std::isfinite(d)) largest = std::max(largest, d);
  if (!(largest > 0)) return std::nullopt;
  const auto shares = [&](const VectorXd& face) {
    return VectorXd(face.unaryExpr([&](double d) {
      if (std::isnan(d)) return 0.;
      return std::clamp(1 + std::log10(std::max(d, 1e-300) / largest) / decades, 0., 1.);
    }));
  };
  // Where cycles lie below the curve, the map has those on it alone.
  const bool all_of_it = std::abs(largest / spot.damage - 1) < 1e-3;
  return ShownField{.name = all_of_it ? "damage of all duties" : "damage of cycles on the curve",
                    .unit = "",
                    .below = shares(life.inner),
                    .above = shares(life.outer),
                    .scale = {significant(largest * std::pow(10, -decades), 2) + " and less",
                              all_of_it
                                  ? bounded(significant(largest, 2), spot.at_most, spot.at_least)
                                  : significant(largest, 2)},
                    .spot = place_words(results.places[std::size_t(spot.place)], spot.outer),
                    .at = spot.at,
                    .spot_above = spot.outer};
}

std::optional<ShownField> stress_field(const Results& results, std::size_t i) {
  const StressResult& s = results.stresses[i];
  if (!(s.largest > 0)) return std::nullopt;
  ShownField f{.name = s.name,
               .unit = "MPa",
               .below = s.below / s.largest,
               .above = s.above / s.largest,
               .scale = {"0", significant(1e-6 * s.largest, 3)},
               .spot = "",
               .at = s.at,
               .spot_above = s.face == "above"};
  const PlaceStress* top =
      i < results.stress_tables.size() ? hottest(results.stress_tables[i]) : nullptr;
  if (!top) return f;
  f.spot = place_words(results.places[std::size_t(top->place)], top->outer);
  f.at = top->at;
  f.spot_above = top->outer;
  return f;
}

} // namespace

std::vector<ShownField> shown_fields(const Results& results, std::size_t most) {
  std::vector<ShownField> fields;
  if (std::optional<ShownField> damage = damage_field(results))
    fields.push_back(std::move(*damage));
  for (std::size_t i = 0; i < results.stresses.size() && fields.size() < most; ++i)
    if (std::optional<ShownField> stress = stress_field(results, i))
      fields.push_back(std::move(*stress));
  return fields;
}

} // namespace plica
