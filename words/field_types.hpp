// Vocabulary of the field descriptions (case_fields.hpp, measured_fields.hpp).
//
// A description is a function template `fields(V& v, T& object)` that names every key of T once, in
// the order a user would write them. A visitor V (reader, schema writer, path access) offers
//   quantity    a number with a unit; also into std::optional<double>
//   quantities  a list of them, into std::vector<double> or std::array<double, N>
//   points      a list of lists, into a vector or array of std::array<double, N>
//   whole       an integer, or std::array<int, N>
//   flag, text, texts
//   one_or_more one text, or a list of them; required. One map, or a list, into std::vector<T>
//   choice      one word out of several; `tag`: the same, and it decides which keys follow
//   choices     a list of words, into std::vector<int>
//   choices_or  the same, or in place of the words one map or several, into std::vector<T>
//   object      a nested struct; also into std::optional<T>
//   list        std::vector<T> written as a list of maps
//   named       std::vector<T> or std::map<std::string, T> written as a map by name
//   one_of      a std::variant, chosen by a word under "type"
//   word        the whole struct may be written as one word instead of a map
//   replacements  a map of paths to new values, kept as text
#pragma once

#include "words/directions.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace plica {

enum class Dimension {
  number,
  ratio,
  length,
  angle,
  mass,
  inertia,
  density,
  pressure,
  force,
  moment,
  force_or_moment,
  stiffness,
  rotational_stiffness,
  section_stiffness, // EI, GJ
  mass_per_length,
  inertia_per_length,
  damping,            // N s/m
  rotational_damping, // Nm s/rad
  time,
  frequency,
  rotational_speed, // revolutions per second
  acceleration,
  acceleration_density,
  force_density,
  temperature // degC
};

constexpr double unbounded = std::numeric_limits<double>::infinity();

// A number in SI units, its bounds; for lists every item has the same, and min_items is required.
struct Quantity {
  Dimension unit = Dimension::number;
  bool required = false;
  double min = -unbounded, max = unbounded;
  bool exclusive_min = false, exclusive_max = false;
  std::optional<Dimension> tail = {}; // unit of the numbers of a row from tail_from on
  int tail_from = 3;
  int min_items = 1, max_items = 2000;
  bool is_unit = false; // "mm" alone is 1 mm
};

struct Whole {
  bool required = false;
  int min = 0, max = 1000000;
  bool even = false;
};

struct Text {
  bool required = false;
  bool name = false; // a name: a letter, then letters, digits, _ and -
};

struct Need {
  bool required = false;
  int min_items = 0; // of a list or map by name
};

constexpr Need required_key{.required = true, .min_items = 1};
constexpr Need optional_key{};

template <class E> struct Named {
  E value;
  const char* name;
};

// Of values that count from 0 in the order of their words.
template <class E, std::size_t N>
std::vector<Named<E>> named_in_order(const std::array<const char*, N>& words) {
  std::vector<Named<E>> named;
  for (std::size_t i = 0; i < N; ++i) named.push_back({static_cast<E>(i), words[i]});
  return named;
}

inline const std::vector<Named<int>> directions = named_in_order<int>(direction_names);
inline const std::vector<Named<int>> signed_axes{{1, "x"},   {2, "y"},   {3, "z"},
                                                 {-1, "-x"}, {-2, "-y"}, {-3, "-z"}};

} // namespace plica
