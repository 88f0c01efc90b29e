#include "words/short_text.hpp"

#include <array>
#include <charconv>
#include <cstdio>

namespace plica {

std::string short_text(double x, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return text.data();
}

std::string short_text(const Eigen::Vector3d& x, int digits) {
  return "[" + short_text(x.x(), digits) + ", " + short_text(x.y(), digits) + ", " +
         short_text(x.z(), digits) + "]";
}

std::string all_digits(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

} // namespace plica
