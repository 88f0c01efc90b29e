// Drawing of the meridian of the first shell of revolution as inline SVG, both axes to the same
// scale, with dimensions in mm (mid-surface): the half section above its axis, and the first
// convolutions enlarged when there are any.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string profile_drawing(const Results& results); // empty without a meridian

} // namespace plica
