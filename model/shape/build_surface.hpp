// Parts whose shape is in a file: CAD faces, or triangles.
#pragma once

#include "model/description/case.hpp"

namespace plica {

// Meshed, put where the case says, with its sets: `all`, edge[1] ..., and its places. The same file
// meshed in the same way is meshed once. Throws std::runtime_error with what is wrong with the
// file.
Mesh surface_mesh(const SurfacePart& part);

// About x, then y, then z.
Eigen::Matrix3d turn_of(const Triple& rotate);

// Adds the sets of nodes near points; std::runtime_error for one without a node.
void add_places(Mesh& mesh, const std::vector<SurfacePlace>& places);

} // namespace plica
