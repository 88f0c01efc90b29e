// Quads on the faces of a CAD file, and on a triangulated surface, by Gmsh and OpenCASCADE.
//
// Faces of four sides are mapped: opposite sides have as many elements, enough for the size and for
// the turn of every side, so that a bellows is meshed finely along its profile and coarsely around.
// Faces that close on themselves (a cylinder has a seam) are first cut in two by a plane through
// the middle of the part. All other faces are filled by quads of about the size.
#pragma once

#include "mesh/shell_surface.hpp"

#include <filesystem>

namespace plica {

struct CadMeshing {
  double unit = 1;     // of a BREP file, which has none of its own, m
  double size = 0;     // largest edge, m
  double turn = 0.393; // rad that an element may turn along a curve
};

// STEP, IGES, BREP by the suffix, in any case.
bool is_cad_file(const std::filesystem::path& file);
bool has_unit(const std::filesystem::path& cad_file); // STEP and IGES

// Of such a file; lengths in the unit of the file, given back in m. Throws std::runtime_error
// with what Gmsh says where the file cannot be read, holds no face, or solids: a shell is wanted.
SurfaceFaces mesh_cad(const std::filesystem::path& file, const CadMeshing& meshing);

// Triangles in m, welded (weld()); edges sharper than 40 degrees stay. The surface must be one that
// Gmsh can parametrise. Throws std::runtime_error with what Gmsh says.
SurfaceFaces remesh(const std::vector<Eigen::Vector3d>& nodes,
                    const std::vector<std::array<int, 3>>& triangles, double size);

} // namespace plica
