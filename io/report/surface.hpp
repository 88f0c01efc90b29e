// A mesh thinned out for a picture.
//
// Surfaces of revolution: whole rings and columns are left out. Rings where the meridian turns
// (crowns, roots, ends) stay, so that every convolution keeps its height; between them as many
// rings as the budget allows. Other surfaces: nodes of one cell of a coarse grid become one.
#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <vector>

namespace plica {

// Corner nodes of the quads to draw, at most about `budget`, corners as in Mesh; a triangle has its
// last corner twice.
std::vector<std::array<int, 4>> drawn_quads(const Mesh& mesh, int budget);

} // namespace plica
