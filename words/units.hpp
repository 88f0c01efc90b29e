// Quantities as users write them: "0.25 mm", "193 GPa", "2 %"; a plain number is in SI.
//
// A unit belongs to a dimension, so "g" is a gram in a mass and 9.80665 m/s2 in an acceleration.
// Blanks inside a unit, "*", "^" and a superscript 2 or 3 are taken as written on paper: "kg m2",
// "kg*m^2" and "kg m²" are the same.
#pragma once

#include "words/field_types.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace plica {

struct ParsedQuantity {
  double value = 0;    // SI
  std::string wrong;   // empty = good
  std::string allowed; // with `wrong`
};

// `text` as a quantity of that dimension. NaN, infinities and overflow are wrong.
ParsedQuantity parse_quantity(std::string_view text, Dimension dimension);

// Units of a dimension, SI first; empty for a pure number.
std::vector<std::string> units_of(Dimension dimension);

// "length", "rotational stiffness", ...
std::string name_of(Dimension dimension);

// What may be written: "a length above 0 in m, mm, cm or um (plain number: m)".
std::string describe(const Quantity& quantity, Dimension unit);

// Regular expression for such a string, with or without a tolerance, for the JSON schema; the unit
// alone too, on request.
std::string quantity_pattern(Dimension dimension, bool negative, bool unit_alone = false);

// Shortest text of a number for messages: 6 significant digits, no trailing zeros.
std::string short_number(double value);

// A length in m as "6.58 mm".
std::string millimetres(double length);

} // namespace plica
