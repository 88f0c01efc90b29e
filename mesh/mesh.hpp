// Mesh of shells and lines: nodes, elements, named sets, rings.
//
// Coordinates in m in the part frame (y along the pipe). A shell quad carries, for each of its four
// corners, the exact director of its surface and the thickness, so that a kink between two surfaces
// keeps both normals. Corners run counter-clockwise seen from the tip of the directors.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace plica {

struct ShellQuad {
  std::array<int, 4> nodes{};
  Eigen::Matrix<double, 3, 4> directors; // unit vectors, one per corner
  Eigen::Vector4d thickness;             // m, one per corner
  int section = 0;                       // index into the sections of the model
};

struct ShellTriangle {
  std::array<int, 3> nodes{};
  Eigen::Matrix3d directors; // unit vectors in columns, one per corner
  Eigen::Vector3d thickness; // m, one per corner
  int section = 0;
};

// Nodes of one circle of a surface of revolution, in equal steps of the circumferential angle,
// which is measured from x towards z.
struct Ring {
  double y = 0, radius = 0;
  std::vector<int> nodes;
};

struct Mesh {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<ShellQuad> quads;
  std::vector<ShellTriangle> triangles;
  std::vector<Ring> rings;
  std::map<std::string, std::vector<int>> sets; // node sets, e.g. "bellows.left"
};

// Quality of the shells: worst and mean of each number.
struct MeshQuality {
  double max_warp = 0;   // of quads: distance of a corner from the mean plane / mean edge
  double max_aspect = 0; // longest / shortest mean edge of a quad, edge of a triangle
  double mean_aspect = 0;
  double min_jacobian = 0; // smallest / largest corner Jacobian of a quad; below 0: folded
};

MeshQuality mesh_quality(const Mesh& mesh);

// Jacobian ratio up to which a quad is folded (a concave or crossed one), and the mesh with it.
constexpr double folded_ratio = 0.01;

// A quad as two triangles.
std::array<std::array<int, 3>, 2> halves(const std::array<int, 4>& quad);

// Adds nodes, shells, rings and sets of `part` to `mesh`; sets are prefixed with "name.".
// Returns the number of the first node added.
int append(Mesh& mesh, const Mesh& part, const std::string& name, int section);

// Node of the mesh nearest to a point, and its distance in m. Throws std::invalid_argument on an
// empty mesh.
std::pair<int, double> nearest_node(const Mesh& mesh, const Eigen::Vector3d& point);
// Among these nodes, at least one.
int nearest_of(const Mesh& mesh, const std::vector<int>& nodes, const Eigen::Vector3d& point);

} // namespace plica
