// The part and its modes as pictures show them.
#pragma once

#include "mesh/generation/surface_file.hpp"
#include "run/results/results.hpp"

namespace plica {

constexpr double drawn_motion = 0.05; // largest displacement of a mode / size of the part

// Modes that have a shape.
std::size_t shown_modes(const Results& results);

// Every node, quad (as two triangles) and line of the results.
Surface surface_of(const Results& results);
// What the displacements of a mode are multiplied by in pictures.
double drawn_scale(const Results& results, std::size_t mode);
// Of the modes, scaled for pictures; no row that is not finite.
std::vector<SurfaceShape> drawn_shapes(const Results& results);

} // namespace plica
