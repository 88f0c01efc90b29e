// Curves in the (y, r) plane and their meshing. Gmsh keeps one global session, so calls in two
// threads wait for each other.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

enum class CurveKind { line, arc, spline };

struct MeridianCurve {
  CurveKind kind = CurveKind::line;
  Eigen::Vector2d start, end;          // (y, r)
  Eigen::Vector2d centre{0, 0};        // arc
  std::vector<Eigen::Vector2d> points; // spline: all points, start and end included
  int elements = 1;
  int convolution = 0; // from 1; 0 = cuff
  bool ends_at_crown = false;
  bool starts_at_root = false; // first curve of a convolution
};

struct CurveNodes {
  std::vector<Eigen::Vector2d> positions; // (y, r), from start to end
  std::vector<Eigen::Vector2d> tangents;  // of a spline; empty otherwise
};

// Meshes each curve with its number of elements (transfinite, equal steps).
// Throws std::runtime_error with Gmsh's own message when Gmsh fails.
std::vector<CurveNodes> mesh_curves(const std::vector<MeridianCurve>& curves);

} // namespace plica
