// Meshing of curves, and files of Gmsh. Gmsh keeps one global session, so calls in two threads wait
// for each other.
#pragma once

#include "mesh/meridian.hpp"
#include "mesh/mesh.hpp"

#include <filesystem>

namespace plica {

struct CurveNodes {
  std::vector<Eigen::Vector2d> positions; // (y, r), from start to end
  std::vector<Eigen::Vector2d> tangents;  // of a spline; empty otherwise
};

// Meshes each curve with its number of elements (transfinite, equal steps).
// Throws std::runtime_error with Gmsh's own message when Gmsh fails.
std::vector<CurveNodes> mesh_curves(const std::vector<MeridianCurve>& curves);

// Writes nodes, quads, lines and node sets (as physical groups of points) as MSH 4.1.
void write_msh(const Mesh& mesh, const std::vector<std::array<int, 2>>& lines,
               const std::filesystem::path& file);

} // namespace plica
