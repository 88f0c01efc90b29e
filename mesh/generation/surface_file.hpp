// Surfaces in the formats of pictures, CAD exchange and printing, wrapped once: the only source
// file that includes assimp is surface_file.cpp.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace plica {

struct Surface {
  std::vector<Eigen::Vector3d> nodes; // m, part frame (z up)
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 2>> lines;
};

struct SurfaceShape {
  std::string name;
  Eigen::MatrixXd displacement; // a row per node: x y z, m, as far as it is to be drawn
};

// glTF 2.0 as one binary file: shapes are morph targets, triangles the mesh 0, lines the next one.
// glTF has y up: the root node turns the part frame.
std::string glb_of(const Surface& surface, const std::vector<SurfaceShape>& shapes);

// By the suffix: .glb with shapes; .obj, .ply, .stl without. Throws std::invalid_argument on
// another suffix, std::runtime_error with assimp's message where it fails or the file cannot be
// written.
void write_surface(const Surface& surface, const std::vector<SurfaceShape>& shapes,
                   const std::filesystem::path& file);

std::string lower_suffix(const std::filesystem::path& file); // ".stl", of X.STL too

// STL, OBJ, PLY, glTF by the suffix, in any case.
bool is_surface_file(const std::filesystem::path& file);

// Triangles of such a file, its numbers times `unit` (m), glTF turned to z up; vertices within
// `weld` (m) of each other are one, triangles that this leaves without an area are gone. Throws
// std::runtime_error: not readable, cut short, no triangle, a number that is not finite.
Surface read_surface(const std::filesystem::path& file, double unit, double weld);

// The surface moved by a shape.
Surface deformed(const Surface& surface, const SurfaceShape& shape);

} // namespace plica
