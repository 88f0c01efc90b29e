// Profiles that decks draw by their sizes: walls at right angles, and the hexagon.
//
// y to the right, z up, in a drawing whose origin each shape says. Area, second moments and the
// centroid are those of the rectangles exactly; shear centre, shear stiffness and the torsion of
// cells those of the middle lines (io/decks/deck_thin_walls).
#pragma once

#include "io/decks/deck_sections.hpp"
#include "io/decks/deck_thin_walls.hpp"

namespace plica {

struct Profile {
  std::vector<ProfileRectangle> rectangles;
  std::vector<ThinWall> walls;
};

// std::invalid_argument for a rectangle without size, as where a flange is higher than the whole.
TurnedSection profile_section(const BeamMaterial& material, const Profile& profile);

struct Flange {
  double width = 0, thickness = 0;
};

// From the middle of its lower edge; a flange of no width is left away: an upright or hanging T.
Profile i_profile(double height, double web, const Flange& lower, const Flange& upper);

// From its corner, to the right and up. `foot` and `leg`: thickness of the lying and the standing
// one.
Profile l_profile(double width, double height, double foot, double leg);

// From the middle of its outer sizes.
struct BoxWalls {
  double right = 0, top = 0, left = 0, bottom = 0;
};
Profile box_profile(double width, double height, const BoxWalls& walls);

// Solid, of six sides: `width` between the tips at the height of the middle, `height` between two
// level sides, which are `tip` shorter at either end. Torsion by Ritz with 24 functions on a
// quarter (of a regular one within 1e-4), shear as of a rectangle after Cowper.
TurnedSection hexagon_section(const BeamMaterial& material, double tip, double width,
                              double height);

} // namespace plica
