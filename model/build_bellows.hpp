// The shell of revolution of a bellows: meridian, density, wall.
#pragma once

#include "mesh/meridian.hpp"
#include "model/case.hpp"
#include "solve/model.hpp"

namespace plica {

Meridian bellows_meridian(const Bellows& bellows);
Mesh bellows_mesh(const Bellows& bellows, const Meridian& meridian);

} // namespace plica
