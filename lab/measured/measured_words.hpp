// Axes, shapes and directions of a test as measured.yaml and messages have them.
#pragma once

#include "lab/measured/measured.hpp"
#include "words/directions.hpp"

#include <array>

namespace plica {

constexpr const char* word_of(Axis axis) {
  return axis_word(static_cast<int>(axis));
}

constexpr const char* word_of(MeasuredShape shape) {
  constexpr std::array words{"axial", "transverse", "torsion", "shell", "other"};
  return words.at(static_cast<std::size_t>(shape));
}

constexpr const char* word_of(StaticDirection direction) {
  constexpr std::array words{"axial",     "transverse_x", "transverse_z",
                             "bending_x", "bending_z",    "torsion"};
  return words.at(static_cast<std::size_t>(direction));
}

} // namespace plica
