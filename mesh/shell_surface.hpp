// From quads and triangles on a surface to a mesh of shells: oriented alike, in the middle of the
// wall, with the sets that joints refer to.
#pragma once

#include "mesh/mesh.hpp"

namespace plica {

// Where a surface lies in its wall: in the middle, or on the side that faces outwards or inwards.
enum class WallSide { middle, outer, inner };

struct SurfaceFaces {
  std::vector<Eigen::Vector3d> nodes;    // m
  std::vector<std::array<int, 4>> faces; // of a triangle the last is -1
  // Unit normals of the surface at the corners, of either sign; empty = from the faces, averaged
  // over those that meet at less than `crease`.
  std::vector<std::array<Eigen::Vector3d, 4>> normals;
  double crease = 0.7; // rad
};

// Directors point outwards: away from the middle of the part on the whole. Sets: `all`, and
// edge[1], edge[2] ... for the loops of free edges, by the y of their middle, then x, then z, then
// the smaller first. Throws std::runtime_error where a surface has no two sides (Moebius) or a face
// no area.
Mesh shell_mesh(const SurfaceFaces& surface, double thickness, WallSide side);

} // namespace plica
