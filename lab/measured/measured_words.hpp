// Axes, shapes and directions of a test as measured.yaml and messages have them.
#pragma once

#include "lab/measured/measured.hpp"
#include "words/directions.hpp"
#include "words/mode_kinds.hpp"

#include <array>

namespace plica {

constexpr const char* word_of(Axis axis) {
  return axis_word(static_cast<int>(axis));
}

inline constexpr std::array measured_shape_names{mode_kind::axial, mode_kind::transverse,
                                                 mode_kind::torsion, mode_kind::shell, "other"};
constexpr const char* word_of(MeasuredShape shape) {
  return measured_shape_names.at(static_cast<std::size_t>(shape));
}

inline constexpr std::array static_direction_names{"axial",     "transverse_x", "transverse_z",
                                                   "bending_x", "bending_z",    "torsion"};
constexpr const char* word_of(StaticDirection direction) {
  return static_direction_names.at(static_cast<std::size_t>(direction));
}

// "transverse stiffness x"
constexpr const char* stiffness_name(StaticDirection direction) {
  constexpr std::array names{"axial stiffness",        "transverse stiffness x",
                             "transverse stiffness z", "bending stiffness x",
                             "bending stiffness z",    "torsional stiffness"};
  return names.at(static_cast<std::size_t>(direction));
}
constexpr const char* stiffness_unit(StaticDirection direction) {
  return direction < StaticDirection::bending_x ? "N/m" : "Nm/rad";
}

} // namespace plica
