// What Gmsh has meshed in its open model.
#pragma once

#include "mesh/shell_surface.hpp"

#include <gmsh.h>

namespace plica {

gmsh::vectorpair faces_of_model();

// Meshes them. Throws std::runtime_error with the first error that Gmsh reports.
void mesh_faces();

// Quads and triangles of all faces, their nodes numbered from 0.
SurfaceFaces collected();

// Nodes and faces in the order of their places: that of Gmsh depends on addresses in memory.
SurfaceFaces in_order(const SurfaceFaces& surface);

double area_of(const SurfaceFaces& surface);
std::string area_text(double m2);

} // namespace plica
