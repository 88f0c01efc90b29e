// What axes, the six directions of a motion and the six degrees of freedom of a node are called, in
// what users write and in what they read.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

namespace plica {

inline constexpr std::array axis_names{"x", "y", "z"};
inline constexpr std::array direction_names{"x", "y", "z", "rx", "ry", "rz"}; // along, about
inline constexpr std::array dof_names{"ux", "uy", "uz", "rx", "ry", "rz"};

// The degree of freedom of an end that a static test moves: axial (the pipe lies along y), across
// in x and z, bending about x and z, torsion.
inline constexpr std::array dof_of_static_test{1, 0, 2, 3, 5, 4};

constexpr const char* axis_word(int axis) { // 0..2
  return axis_names.at(static_cast<std::size_t>(axis));
}

// Of an axis that may be reversed: 1..3, "x"; -1..-3, "-x".
inline std::string signed_axis_word(int axis) {
  return (axis < 0 ? "-" : "") + std::string(axis_word(std::abs(axis) - 1));
}

constexpr const char* dof_name(int dof) { // 0..5
  return dof_names.at(static_cast<std::size_t>(dof));
}

// Place of a word among these; -1 = none.
template <std::size_t N>
constexpr int place_among(const std::array<const char*, N>& words, std::string_view word) {
  const auto found = std::find(words.begin(), words.end(), word);
  return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

// Whether a channel is a translation, "mid.y": not "mid" or "mid.ry".
constexpr bool is_translation(std::string_view channel) {
  const std::size_t dot = channel.rfind('.');
  return dot != std::string_view::npos && dot > 0 &&
         place_among(axis_names, channel.substr(dot + 1)) >= 0;
}

// Axis of a channel "mid.y" by its last letter, 0..2; -1: it is the name of none.
constexpr int axis_of_channel(std::string_view channel) {
  return channel.empty() ? -1 : place_among(axis_names, channel.substr(channel.size() - 1));
}

// What a channel is of: "mid" of "mid.y".
constexpr std::string_view sensor_of_channel(std::string_view channel) {
  return channel.substr(0, channel.rfind('.'));
}

// A sensor's own axis: 1..3 = x y z of the part, negative where it is reversed.
constexpr int axis_of_signed(int own) { // 0..2
  return (own < 0 ? -own : own) - 1;
}
constexpr double sign_of(int own) {
  return own < 0 ? -1 : 1;
}

} // namespace plica
