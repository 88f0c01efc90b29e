// Sections of beams that decks name by their shape.
#pragma once

#include "elements/beam_section.hpp"

#include <array>

namespace plica {

// A section of stiffness: area, second moments about the local y and z, torsion constant. Rotary
// inertia with the same second moments. Rigid in shear until told otherwise.
BeamProperties general_section(const BeamMaterial& material, double A, double I_y, double I_z,
                               double J);

// The same about axes that are not principal: I_yz = integral of y z. The properties are along the
// principal axes, which lie `turn` further, rad, from y to z. Where the section is drawn: its
// centroid, and the point about which it twists, (y, z), m.
struct TurnedSection {
  BeamProperties properties;
  double turn = 0;
  std::array<double, 2> centroid{}, shear_centre{};
};
TurnedSection principal_section(const BeamMaterial& material, double A, double I_y, double I_z,
                                double I_yz, double J);

// One of the rectangles that a profile consists of: its centre and its sizes along y and z, m.
struct ProfileRectangle {
  double y = 0, z = 0, width = 0, depth = 0;
};

// A profile of thin rectangles about its centroid; open, J = sum of b t^3 / 3, or of `J` when that
// is above zero (closed walls: Bredt, 4 A^2 / sum of s/t). Rigid in shear. Fibres at the corners.
TurnedSection rectangles_section(const BeamMaterial& material,
                                 const std::vector<ProfileRectangle>& rectangles, double J = 0);

} // namespace plica
