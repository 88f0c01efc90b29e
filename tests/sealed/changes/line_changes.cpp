#include "line_changes.hpp"

#include <limits>

namespace sealed {

int number_in(const std::string& place, const std::string& before) {
  if (!place.starts_with(before + "[")) return 0;
  return std::stoi(place.substr(before.size() + 1));
}

double place_along(const std::string& place, const std::string& part, double length,
                   int stretches) {
  const auto point = [&](int k) { return (k - 1) * length / stretches; };
  if (place == part) return 0;
  if (const int k = number_in(place, part + ".point")) return point(k);
  if (const int k = number_in(place, part + ".stretch")) return (point(k) + point(k + 1)) / 2;
  return std::numeric_limits<double>::quiet_NaN();
}

Change mass_at(const std::string& part, double s, double most) {
  return {.effect = {"added_mass", part, {{"at", s}}},
          .size = "mass",
          .smallest = 1e-4 * most,
          .largest = most};
}

Change damage_of(const std::string& place) {
  return {.effect = {"local_damage", place, {}}, .size = "loss", .smallest = 1e-4, .largest = 0.9};
}

Change ratio_of(const std::string& effect, const std::string& place, double sign) {
  return {.effect = {effect, place, {}},
          .size = "ratio",
          .smallest = 1e-3,
          .largest = 1.5,
          .about_one = true,
          .sign = sign};
}

Change soft_clamp(const std::string& place, double stiffest, double softest) {
  return {.effect = {"boundary_compliance", place, {}},
          .size = "k_rotation",
          .smallest = 1 / stiffest,
          .largest = 1 / softest,
          .inverse = true};
}

} // namespace sealed
