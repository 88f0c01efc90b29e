// The shell of revolution of a bellows: meridian, density, wall.
#pragma once

#include "mesh/meridian.hpp"
#include "model/case.hpp"
#include "solve/model.hpp"

namespace plica {

// The accuracy that its density follows; 0 where counts are given.
double mesh_accuracy(const Bellows& bellows);

// The same mesh with every density given as counts, cuffs included.
Bellows with_counts(Bellows bellows);

Meridian bellows_meridian(const Bellows& bellows);
Mesh bellows_mesh(const Bellows& bellows, const Meridian& meridian);

} // namespace plica
