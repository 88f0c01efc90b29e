// The truth in the words of the library: the same places, ways and parameters as its files
// (diagnose/effects/) have, which the suite does not link.
#include "sets.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace sealed {
namespace {

using nlohmann::json;

// Where along the beam of cantilever_masses a point lies, m.
double along(const std::string& point) {
  return 0.150 * (point[point.size() - 2] - '1');
}

// What sits at a spot: a point of a beam is a place along it. Where there is but one way, none is
// said.
json at_spot(json own, const json& effect, const char* on_beam) {
  const std::string place = effect["place"];
  if (place.starts_with("beam.point[")) {
    own["place"] = "beam";
    if (*on_beam) own["way"] = on_beam;
    own["value"]["at"] = along(place);
  } else if (place.find(".convolution[") != std::string::npos) {
    own["way"] = "on the mean motion";
  }
  return own;
}

// Eight directions of half a turn, 22.5 degrees each.
std::string nearest_direction(double angle) {
  const long i = std::lround(angle / (std::numbers::pi / 8)) % 8;
  return fmt::format("{:g} degrees", 22.5 * double(i));
}

json in_words_of_the_library(const json& effect, const std::string& structure) {
  const std::string name = effect["name"];
  json own{{"effect", name}, {"place", effect["place"]}, {"value", effect["value"]}};
  if (name == "added_mass") return at_spot(own, effect, "");
  if (name == "extra_support") return at_spot(own, effect, "all round");
  if (name == "fixture_flexibility") { // bench.cpp: a radius of gyration of 60 mm
    const double cube = 0.408 * std::cbrt(double(own["value"]["mass"]) / 7850);
    own["value"]["rocking"] = 2.0;
    own["value"]["spread"] = 0.06 / cube;
  }
  if (name == "rotated_sensor") // about the normal of the wall
    own["way"] = effect["place"] == "sensor.mid" ? "about z" : "about x";
  if (name == "cross_axis_base_motion") // of the axes that the campaign moves
    own["way"] = structure == "short_bellows" ? "x and y alike" : "z to x";
  if (name == "local_damage") {
    own["way"] = nearest_direction(effect["value"]["angle"]);
    own["value"].erase("angle");
  }
  return own;
}

} // namespace

json known_effects(const json& truth) {
  json known = json::array();
  const auto& all = effect_names();
  for (const json& e : truth["effects"])
    if (std::find(all.begin(), all.end(), e["name"]) != all.end() &&
        e["name"] != truth.value("left_out", ""))
      known.push_back(e);
  return known;
}

std::optional<json> supposed(const json& truth) {
  json effects = json::array();
  for (const json& e : known_effects(truth)) {
    if (e["name"] == "joint_friction") return {}; // Bouc and Wen's law is not Iwan's
    effects.push_back(in_words_of_the_library(e, truth["structure"]));
  }
  return json{{"effects", effects}};
}

} // namespace sealed
