#include "words/short_text.hpp"

#include <array>
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

} // namespace plica
