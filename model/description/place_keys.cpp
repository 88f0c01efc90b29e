#include "model/description/place_keys.hpp"

#include <array>
#include <utility>

namespace plica {

std::optional<PathInPlace> path_in_place(const std::string& path) {
  constexpr std::array heads{std::pair{"parts.", PlaceKind::part},
                             std::pair{"caps.", PlaceKind::cap},
                             std::pair{"mount.", PlaceKind::mount}};
  for (const auto& [head, kind] : heads) {
    if (!path.starts_with(head)) continue;
    const std::size_t name = path.find('.') + 1, dot = path.find('.', name);
    if (dot == std::string::npos) return std::nullopt;
    return PathInPlace{kind, path.substr(name, dot - name), path.substr(dot + 1)};
  }
  return std::nullopt;
}

} // namespace plica
