// What may change in a structure of lines, and its places by name.
#pragma once

#include "structures.hpp"

namespace sealed {

// Number in "beam.stretch[3]", 0 = not of this form.
int number_in(const std::string& place, const std::string& before);

// Where the part itself (0: its coordinate is a value), "part.point[k]" or the middle of
// "part.stretch[k]" is, m; NaN: nowhere.
double place_along(const std::string& place, const std::string& part, double length, int stretches);

Change mass_at(const std::string& part, double s, double most); // m along the part; kg
Change damage_of(const std::string& place);
Change ratio_of(const std::string& effect, const std::string& place, double sign);
Change soft_clamp(const std::string& place, double stiffest, double softest); // N m/rad

} // namespace sealed
