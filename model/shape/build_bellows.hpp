// The shell of revolution of a bellows: meridian, density, wall.
#pragma once

#include "mesh/generation/meridian.hpp"
#include "model/description/case.hpp"
#include "solve/model.hpp"

namespace plica {

// Elements for a density: counts as given, or from the accuracy. The rule is measured (docs/
// elements.md): with the incompatible membrane the error of the axial stiffness is about 7 / N^2
// for N elements around (60 / N^2 with the others) and 0.7 % for 4 elements per quarter arc and 5
// per wall, falling with the square; half the accuracy goes to each direction. Arcs and walls
// longer than the bending length sqrt(R t) get more, in proportion.
struct ElementCounts {
  int around = 0, arc = 0, wall = 0;
};
ElementCounts element_counts(const Bellows& bellows);

// The accuracy that its density follows; 0 where counts are given.
double mesh_accuracy(const Bellows& bellows);

// The same mesh with every density given as counts, cuffs included.
Bellows with_counts(Bellows bellows);

Meridian bellows_meridian(const Bellows& bellows);
Mesh bellows_mesh(const Bellows& bellows, const Meridian& meridian);

} // namespace plica
