// Meshes of quads as meshes of triangles, for the tests of MITC3+.
#pragma once

#include "mesh/mesh.hpp"

namespace plica::test {

// Every quad in two, along one diagonal; corners keep their directors and thickness.
inline Mesh triangulated(Mesh mesh) {
  for (const ShellQuad& q : mesh.quads)
    for (const std::array<int, 3>& corners : {std::array{0, 1, 2}, {0, 2, 3}}) {
      ShellTriangle half;
      half.section = q.section;
      for (int i = 0; i < 3; ++i) {
        half.nodes[i] = q.nodes[corners[i]];
        half.directors.col(i) = q.directors.col(corners[i]);
        half.thickness[i] = q.thickness[corners[i]];
      }
      mesh.triangles.push_back(half);
    }
  mesh.quads.clear();
  return mesh;
}

} // namespace plica::test
