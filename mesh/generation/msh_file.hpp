// Meshes as files of Gmsh.
#pragma once

#include "mesh/mesh.hpp"

#include <filesystem>

namespace plica {

// Writes nodes, quads, triangles, lines and node sets (as physical groups of points) as MSH 4.1.
// Throws std::runtime_error with Gmsh's own message when Gmsh fails.
void write_msh(const Mesh& mesh, const std::vector<std::array<int, 2>>& lines,
               const std::filesystem::path& file);

} // namespace plica
