// Keys of the numbers of a run: in its headline, among its error bars, in goals and limits of a
// fit. "mass", "k_axial", "f_transverse"; of a duty of a life "life_road", its stress range, and
// "damage_road"; "damage", that of all duties at the worst place.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace plica {

enum class NumberKind { mass, stiffness, frequency, stress_range, damage, other };

namespace number_key {

inline constexpr const char *mass = "mass", *damage = "damage";
inline constexpr std::array heads{std::pair{NumberKind::stiffness, std::string_view("k_")},
                                  std::pair{NumberKind::frequency, std::string_view("f_")},
                                  std::pair{NumberKind::stress_range, std::string_view("life_")},
                                  std::pair{NumberKind::damage, std::string_view("damage_")}};

constexpr NumberKind kind_of(std::string_view key) {
  if (key == mass) return NumberKind::mass;
  if (key == damage) return NumberKind::damage;
  for (const auto& [kind, head] : heads)
    if (key.starts_with(head)) return kind;
  return NumberKind::other;
}

// Behind the head of its kind: "axial", "road"; of "mass" and "damage" nothing.
constexpr std::string_view rest_of(std::string_view key) {
  for (const auto& [kind, head] : heads)
    if (key.starts_with(head)) return key.substr(head.size());
  return {};
}

// `of`: a direction, the shape of a mode, the name of a duty. `kind` has a head.
inline std::string of(NumberKind kind, const std::string& of) {
  for (const auto& [own, head] : heads)
    if (own == kind) return std::string(head) + of;
  return of;
}

} // namespace number_key
} // namespace plica
