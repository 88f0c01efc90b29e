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

} // namespace plica
