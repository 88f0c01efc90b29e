// Does the profile of a convolution exist, and does it stay clear of itself?
//
// With the arcs Rr, Rc, their angle phi and the pitch q of mesh/generation/meridian.hpp: phi = 90
// deg gives parallel walls, less inclined ones (U); above, the walls lean over (omega) and the
// necks
//   q - 2 Rr   inside one convolution, at the root side,
//   q - 2 Rc   between neighbouring convolutions, at the crown side
// must stay wider than the wall. Lengths in m, angles in rad.
#pragma once

#include "model/description/case.hpp"

#include <array>
#include <string>
#include <vector>

namespace plica {

// Arc radii of a section with their default, pitch/4.
double root_arc_radius(const MeridianSection& section);
double crown_arc_radius(const MeridianSection& section);

// Axial length of a section, all its convolutions.
double axial_length(const MeridianSection& section);
double axial_length(const Bellows& bellows);

// Largest and smallest mid-surface radius.
std::array<double, 2> radius_range(const Bellows& bellows);

// Convolutions of the whole bellows.
int convolutions(const Bellows& bellows);

// Thickness of all plies.
double total_thickness(const Wall& wall);

// Radius at the right end of a section that starts at `radius`.
double end_radius(const MeridianSection& section, double radius);

struct ProfileProblem {
  std::string key; // below the section, empty = the section
  std::string wrong, allowed;
};

// One section that starts at `radius`, with a wall of that thickness. Values must be finite.
std::vector<ProfileProblem> check_section(const MeridianSection& section, double radius,
                                          double wall_thickness);

} // namespace plica
