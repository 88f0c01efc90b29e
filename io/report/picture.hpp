// Pictures of the part and its modes as inline SVG: shaded quads in oblique projection, far ones
// first (painter's algorithm).
//
// y (along the pipe) points right, z up, x towards the reader, down to the left. A part that is
// flat across another axis is seen along that axis instead; the triad says which is which.
#pragma once

#include "io/report/fields.hpp"

#include <string>

namespace plica {

// The undeformed part with its sensors, named in letters of this size, where the drawing is about
// 2,100 wide; empty without elements.
inline constexpr double beside_text = 34, in_a_column = 95;
std::string part_picture(const Results& results, double letters = beside_text);

// The part coloured by a field on the face of its hot spot, which is marked, with the scale.
std::string field_picture(const Results& results, const ShownField& field);

// One mode, as mode_pictures() has them; empty where it has no shape.
std::string mode_picture(const Results& results, std::size_t mode);

// Up to `most` first modes, exaggerated so that the largest translation is 5 % of the size of the
// part, coloured by it; dashed: the outline at rest. With captions and one legend.
std::string mode_pictures(const Results& results, int most = 6);

} // namespace plica
