// Shell elements on the faces of a CAD file, or on the triangles of a surface file. Files are read
// and meshed by the program plica_mesher (mesher/), in a process of its own with a limit of time
// and of memory (mesh/generation/worker.hpp): their readers crash on, or never end with, some that
// are damaged.
#pragma once

#include "mesh/shell_surface.hpp"

#include <filesystem>

namespace plica {

struct SurfaceMeshing {
  double unit = 1;     // of a file that has none of its own, m
  double size = 0;     // largest edge, m; 0 = the triangles of the file as they are
  double turn = 0.393; // rad that an element may turn along a curve of CAD
  double weld = 1e-6;  // m; vertices of triangles that are one
};

// STEP, IGES, BREP by the suffix, in any case.
bool is_cad_file(const std::filesystem::path& file);
bool has_unit(const std::filesystem::path& cad_file); // STEP and IGES

// In m. Throws std::runtime_error with the file and what is wrong: see docs/geometry.md;
// Interrupted where Ctrl-C or SIGTERM stopped it.
SurfaceFaces mesh_surface_file(const std::filesystem::path& file, const SurfaceMeshing& meshing);

// Where the mesher is: PLICA_MESHER; else in the build or the installation that the running program
// belongs to; else where Plica was to be installed. Throws std::runtime_error naming these places.
std::filesystem::path mesher_program();

// What the mesher writes: faces, or why there are none. Bytes of this machine.
std::string message_of(const SurfaceFaces& faces);
std::string message_of_failure(const std::string& what);
SurfaceFaces faces_of_message(const std::string& message); // throws what failed

} // namespace plica
