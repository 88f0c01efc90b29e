// Effects of a diagnosis in words, their numbers in units a person uses.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "io/tables/text.hpp"

namespace plica {

// "added_mass at beam.point[3] (all round)"; of a hypothesis joined by "and", "none" = nominal.
std::string effect_label(const NamedEffect& effect);
std::string hypothesis_label(const TriedHypothesis& hypothesis);

// As shown_unit(), and small lengths and masses in mm, µm, g, angles in degrees.
ShownUnit handy_unit(double value, const std::string& unit);

// A parameter in such a unit, one for all three numbers. Of a size over so many powers of ten only
// the lower end is known: a spring that holds rigidly.
struct ShownEstimate {
  double value = 0;
  std::array<double, 2> interval{}; // 90 %
  std::string unit;
  bool from_below = false;
};
ShownEstimate shown_estimate(const EstimatedParameter& parameter);

// "20.1 (18.2 to 23.4) g", "at least 31 MN/m"; numbers as `number` writes them. What was stated
// has no interval.
std::string estimate_words(const EstimatedParameter& parameter,
                           std::string (*number)(double value, int digits) = significant);
// Of its parameters: "bond 0.398 (0.342 to 0.487), ..."; empty without any. Beyond `most` of them
// dots.
std::string values_words(const NamedEffect& effect,
                         std::string (*number)(double value, int digits) = significant,
                         std::size_t most = 100);

// "20 g that nobody weighed" (Effect::plain), without its place.
std::string plain_words(const NamedEffect& effect);
// "20 g that nobody weighed, at sensor.mid"; what acts everywhere has no place.
std::string plain_at_place(const NamedEffect& effect);

} // namespace plica
