#include "io/report/colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plica {
namespace {

using Rgb = std::array<double, 3>;

constexpr std::array<Rgb, 9> viridis_colours{{{68, 1, 84},
                                              {71, 45, 123},
                                              {59, 82, 139},
                                              {44, 114, 142},
                                              {33, 145, 140},
                                              {40, 174, 128},
                                              {94, 201, 98},
                                              {173, 220, 48},
                                              {253, 231, 37}}};

std::string hex(const Rgb& colour, double shade) {
  std::array<int, 3> levels{};
  for (std::size_t i = 0; i < 3; ++i) {
    levels[i] = static_cast<int>(std::lround(std::clamp(colour[i] * shade, 0.0, 255.0)));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", levels[0], levels[1], levels[2]);
}

} // namespace

std::string viridis(double value, double shade) {
  const double place = 8 * std::clamp(std::isfinite(value) ? value : 0, 0.0, 1.0);
  const auto below = std::min<std::size_t>(7, static_cast<std::size_t>(place));
  const double part = place - static_cast<double>(below);
  Rgb colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] = (1 - part) * viridis_colours[below][i] + part * viridis_colours[below + 1][i];
  }
  return hex(colour, shade);
}

std::string steel(double shade) {
  return hex({198, 208, 217}, shade);
}

} // namespace plica
