// Numbers in sentences: two significant digits, 1.3e-07.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace plica {

inline std::string short_text(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", x);
  return text.data();
}

} // namespace plica
