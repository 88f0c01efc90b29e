#include "mesh/shell_surface.hpp"

#include "words/short_text.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Vector3d;
using Edge = std::pair<int, int>; // smaller node first
using Face = std::array<int, 4>;  // of a triangle the last is -1

std::size_t corners(const Face& face) {
  return face[3] < 0 ? 3 : 4;
}

void turn_over(Face& face) {
  std::reverse(face.begin(), face.begin() + std::ptrdiff_t(corners(face)));
}

Edge edge_of(const Face& face, std::size_t side) {
  const int a = face[side], b = face[(side + 1) % corners(face)];
  return {std::min(a, b), std::max(a, b)};
}

std::map<Edge, std::vector<int>> faces_at_edges(const std::vector<Face>& faces) {
  std::map<Edge, std::vector<int>> at;
  for (std::size_t q = 0; q < faces.size(); ++q)
    for (std::size_t side = 0; side < corners(faces[q]); ++side)
      at[edge_of(faces[q], side)].push_back(int(q));
  return at;
}

bool runs_along(const Face& face, const Edge& edge) {
  const std::size_t n = corners(face);
  for (std::size_t i = 0; i < n; ++i)
    if (face[i] == edge.first && face[(i + 1) % n] == edge.second) return true;
  return false;
}

// Twice the area long.
Vector3d normal_of(const std::vector<Vector3d>& x, const Face& f) {
  const Vector3d &a = x[std::size_t(f[0])], &c = x[std::size_t(f[2])];
  const Vector3d &from = x[std::size_t(f[1])], &to = f[3] < 0 ? a : x[std::size_t(f[3])];
  return (c - a).cross(to - from);
}

std::string place(const Vector3d& x) {
  return short_text(x) + " m";
}

class Shells {
public:
  explicit Shells(const SurfaceFaces& surface)
      : surface_(surface), faces_(surface.faces), edges_(faces_at_edges(faces_)) {}

  Mesh mesh(double thickness, WallSide side) {
    orient();
    find_normals();
    Mesh mesh;
    mesh.nodes = surface_.nodes;
    const auto fill = [&](std::size_t q, auto& shell) {
      for (std::size_t c = 0; c < corners(faces_[q]); ++c) {
        shell.nodes[c] = faces_[q][c];
        shell.directors.col(Eigen::Index(c)) = normals_[q][c];
      }
      shell.thickness.setConstant(thickness);
    };
    for (std::size_t q = 0; q < faces_.size(); ++q) {
      if (corners(faces_[q]) == 4)
        fill(q, mesh.quads.emplace_back());
      else
        fill(q, mesh.triangles.emplace_back());
    }
    if (side != WallSide::middle)
      move_to_middle(mesh, side == WallSide::outer ? thickness : -thickness);
    name_sets(mesh);
    return mesh;
  }

private:
  // Neighbours alike, part by part; then each part outwards.
  void orient() {
    std::vector<char> done(faces_.size(), 0);
    for (std::size_t seed = 0; seed < faces_.size(); ++seed) {
      if (done[seed]) continue;
      std::vector<int> part{int(seed)};
      done[seed] = 1;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const int q = part[i];
        for (std::size_t side = 0; side < corners(faces_[std::size_t(q)]); ++side) {
          const Edge edge = edge_of(faces_[std::size_t(q)], side);
          const std::vector<int>& meeting = edges_.at(edge);
          if (meeting.size() != 2) continue; // free, or a branch
          const int other = meeting[0] == q ? meeting[1] : meeting[0];
          if (other == q) continue;
          Face& next = faces_[std::size_t(other)];
          const bool alike = runs_along(faces_[std::size_t(q)], edge) != runs_along(next, edge);
          if (done[std::size_t(other)]) {
            if (!alike)
              throw std::runtime_error("the surface has no two sides near " +
                                       place(surface_.nodes[std::size_t(edge.first)]));
            continue;
          }
          if (!alike) turned_.push_back(other), turn_over(next);
          done[std::size_t(other)] = 1;
          part.push_back(other);
        }
      }
      outwards(part);
    }
  }

  void outwards(const std::vector<int>& part) {
    Vector3d middle = Vector3d::Zero();
    double area = 0;
    const auto centre = [&](int q) {
      const Face& face = faces_[std::size_t(q)];
      Vector3d sum = Vector3d::Zero();
      for (std::size_t c = 0; c < corners(face); ++c) sum += surface_.nodes[std::size_t(face[c])];
      return Vector3d(sum / double(corners(face)));
    };
    for (int q : part) {
      const double own = normal_of(surface_.nodes, faces_[std::size_t(q)]).norm();
      middle += own * centre(q);
      area += own;
    }
    middle /= std::max(area, 1e-300);
    double flux = 0;
    for (int q : part)
      flux += (centre(q) - middle).dot(normal_of(surface_.nodes, faces_[std::size_t(q)]));
    if (flux < 0)
      for (int q : part) {
        turn_over(faces_[std::size_t(q)]);
        turned_.push_back(q);
      }
  }

  void find_normals() {
    std::vector<Vector3d> flat;
    for (const Face& face : faces_) {
      const Vector3d n = normal_of(surface_.nodes, face);
      if (!(n.norm() > 0))
        throw std::runtime_error("an element without an area at " +
                                 place(surface_.nodes[std::size_t(face[0])]));
      flat.push_back(n);
    }
    normals_.resize(faces_.size());
    if (!surface_.normals.empty()) {
      normals_ = surface_.normals;
      for (int q : turned_)
        std::reverse(normals_[std::size_t(q)].begin(),
                     normals_[std::size_t(q)].begin() +
                         std::ptrdiff_t(corners(faces_[std::size_t(q)])));
      for (std::size_t q = 0; q < faces_.size(); ++q)
        for (Vector3d& n : normals_[q])
          if (n.dot(flat[q]) < 0) n = -n;
      return;
    }
    std::vector<std::vector<int>> at(surface_.nodes.size());
    for (std::size_t q = 0; q < faces_.size(); ++q)
      for (std::size_t c = 0; c < corners(faces_[q]); ++c)
        at[std::size_t(faces_[q][c])].push_back(int(q));
    const double least = std::cos(surface_.crease);
    for (std::size_t q = 0; q < faces_.size(); ++q)
      for (std::size_t c = 0; c < corners(faces_[q]); ++c) {
        Vector3d sum = Vector3d::Zero();
        for (int other : at[std::size_t(faces_[q][c])])
          if (flat[q].normalized().dot(flat[std::size_t(other)].normalized()) >= least)
            sum += flat[std::size_t(other)];
        normals_[q][c] = sum.normalized();
      }
  }

  // Nodes half a thickness inwards, along the mean of the normals that meet there; where they
  // differ, so far that each face moves by its half.
  static void move_to_middle(Mesh& mesh, double thickness) {
    std::vector<std::vector<Vector3d>> normals(mesh.nodes.size());
    const auto add = [&](const auto& shells) {
      for (const auto& shell : shells)
        for (std::size_t c = 0; c < shell.nodes.size(); ++c)
          normals[std::size_t(shell.nodes[c])].push_back(shell.directors.col(Eigen::Index(c)));
    };
    add(mesh.quads);
    add(mesh.triangles);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      if (normals[i].empty()) continue;
      Vector3d mean = Vector3d::Zero();
      for (const Vector3d& n : normals[i]) mean += n;
      mean.normalize();
      double along = 0;
      for (const Vector3d& n : normals[i]) along += mean.dot(n) / double(normals[i].size());
      mesh.nodes[i] -= thickness / 2 / std::max(along, 0.3) * mean;
    }
  }

  void name_sets(Mesh& mesh) const {
    std::vector<int>& all = mesh.sets["all"];
    all.resize(mesh.nodes.size());
    std::iota(all.begin(), all.end(), 0);
    std::map<int, std::vector<int>> along; // free edges at a node
    for (const auto& [edge, faces] : edges_)
      if (faces.size() == 1) {
        along[edge.first].push_back(edge.second);
        along[edge.second].push_back(edge.first);
      }
    struct Loop {
      Vector3d middle;
      double reach; // mean distance from the middle
      std::vector<int> nodes;
    };
    std::vector<Loop> loops;
    std::map<int, bool> seen;
    for (const auto& [start, next] : along) {
      if (seen[start]) continue;
      std::vector<int> loop{start};
      seen[start] = true;
      for (std::size_t i = 0; i < loop.size(); ++i)
        for (int other : along.at(loop[i]))
          if (!seen[other]) {
            seen[other] = true;
            loop.push_back(other);
          }
      Vector3d middle = Vector3d::Zero();
      for (int node : loop) middle += mesh.nodes[std::size_t(node)] / double(loop.size());
      double reach = 0;
      for (int node : loop)
        reach += (mesh.nodes[std::size_t(node)] - middle).norm() / double(loop.size());
      loops.push_back({middle, reach, std::move(loop)});
    }
    std::sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
      constexpr double same = 1e-6;
      for (int axis : {1, 0, 2})
        if (std::abs(a.middle[axis] - b.middle[axis]) > same)
          return a.middle[axis] < b.middle[axis];
      return a.reach < b.reach;
    });
    for (std::size_t k = 0; k < loops.size(); ++k)
      mesh.sets["edge[" + std::to_string(k + 1) + "]"] = loops[k].nodes;
  }

  const SurfaceFaces& surface_;
  std::vector<Face> faces_;
  std::map<Edge, std::vector<int>> edges_;
  std::vector<std::array<Vector3d, 4>> normals_;
  std::vector<int> turned_;
};

} // namespace

Mesh shell_mesh(const SurfaceFaces& surface, double thickness, WallSide side) {
  return Shells(surface).mesh(thickness, side);
}

} // namespace plica
