// The shell of revolution of a bellows: meridian, elements, wall.
#pragma once

#include "mesh/generation/meridian.hpp"
#include "model/description/case.hpp"
#include "solve/model.hpp"

namespace plica {

// The same mesh with every density given as counts, cuffs included.
Bellows with_counts(Bellows bellows);

Meridian bellows_meridian(const Bellows& bellows);
Mesh bellows_mesh(const Bellows& bellows, const Meridian& meridian);

} // namespace plica
