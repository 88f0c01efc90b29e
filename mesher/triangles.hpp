// Triangles of a surface file: what they must not be, and their meshing anew by Gmsh.
#pragma once

#include "mesh/generation/surface_file.hpp"
#include "mesh/shell_surface.hpp"

namespace plica {

// Throws std::runtime_error where two triangles lie on the same three vertices, or two neighbours
// are folded flat on each other: the wall would be counted twice there.
void require_single_wall(const Surface& surface);

// Throws std::runtime_error where just one triangle is missing, or hangs into its hole by one edge
// since a vertex is not where it was; and where a vertex is farther than 1 km from the others.
void require_no_gap(const Surface& surface);

SurfaceFaces as_they_are(const Surface& surface);

// Triangles in m, welded; edges sharper than 40 degrees stay. The surface must be one that Gmsh can
// parametrise. Throws std::runtime_error with what Gmsh says, and where area or extent of the
// elements are not those of the triangles: by more than 3 % of the area, half a size of the extent.
SurfaceFaces remesh(const Surface& surface, double size);

} // namespace plica
