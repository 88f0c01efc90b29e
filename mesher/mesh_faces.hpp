// Quads on the faces of a CAD part, by Gmsh.
//
// Faces of four sides are mapped: opposite sides have as many elements, enough for the size and for
// the turn of every side, so that a bellows is meshed finely along its profile and coarsely around.
// Faces that close on themselves (a cylinder has a seam) are first cut in two by a plane through
// the middle of the part. All other faces are filled by quads of about the size.
#pragma once

#include "mesh/generation/surface_mesher.hpp"
#include "mesher/read_cad.hpp"

namespace plica {

// With exact normals. Throws std::runtime_error with what Gmsh says, or where the area of the
// elements is not that of the faces.
SurfaceFaces mesh_cad(const CadFaces& part, const SurfaceMeshing& meshing);

} // namespace plica
