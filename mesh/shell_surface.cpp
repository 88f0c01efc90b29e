#include "mesh/shell_surface.hpp"

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

Edge edge_of(const std::array<int, 4>& quad, int side) {
  const int a = quad[std::size_t(side)], b = quad[std::size_t((side + 1) % 4)];
  return {std::min(a, b), std::max(a, b)};
}

std::map<Edge, std::vector<int>> quads_at_edges(const std::vector<std::array<int, 4>>& quads) {
  std::map<Edge, std::vector<int>> at;
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (int side = 0; side < 4; ++side) at[edge_of(quads[q], side)].push_back(int(q));
  return at;
}

bool runs_along(const std::array<int, 4>& quad, const Edge& edge) {
  for (std::size_t i = 0; i < 4; ++i)
    if (quad[i] == edge.first && quad[(i + 1) % 4] == edge.second) return true;
  return false;
}

Vector3d normal_of(const std::vector<Vector3d>& x, const std::array<int, 4>& q) {
  return (x[std::size_t(q[2])] - x[std::size_t(q[0])])
      .cross(x[std::size_t(q[3])] - x[std::size_t(q[1])]);
}

std::string place(const Vector3d& x) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "(%.4g, %.4g, %.4g) m", x.x(), x.y(), x.z());
  return text.data();
}

class Shells {
public:
  explicit Shells(const SurfaceQuads& surface)
      : surface_(surface), quads_(surface.quads), edges_(quads_at_edges(quads_)) {}

  Mesh mesh(double thickness, WallSide side) {
    orient();
    find_normals();
    Mesh mesh;
    mesh.nodes = surface_.nodes;
    for (std::size_t q = 0; q < quads_.size(); ++q) {
      ShellQuad shell;
      shell.nodes = quads_[q];
      for (int c = 0; c < 4; ++c) shell.directors.col(c) = normals_[q][std::size_t(c)];
      shell.thickness.setConstant(thickness);
      mesh.quads.push_back(shell);
    }
    if (side != WallSide::middle)
      move_to_middle(mesh, side == WallSide::outer ? thickness : -thickness);
    name_sets(mesh);
    return mesh;
  }

private:
  // Neighbours alike, part by part; then each part outwards.
  void orient() {
    std::vector<char> done(quads_.size(), 0);
    for (std::size_t seed = 0; seed < quads_.size(); ++seed) {
      if (done[seed]) continue;
      std::vector<int> part{int(seed)};
      done[seed] = 1;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const int q = part[i];
        for (int side = 0; side < 4; ++side) {
          const Edge edge = edge_of(quads_[std::size_t(q)], side);
          const std::vector<int>& meeting = edges_.at(edge);
          if (meeting.size() != 2) continue; // free, or a branch
          const int other = meeting[0] == q ? meeting[1] : meeting[0];
          if (other == q) continue;
          std::array<int, 4>& next = quads_[std::size_t(other)];
          const bool alike = runs_along(quads_[std::size_t(q)], edge) != runs_along(next, edge);
          if (done[std::size_t(other)]) {
            if (!alike)
              throw std::runtime_error("the surface has no two sides near " +
                                       place(surface_.nodes[std::size_t(edge.first)]));
            continue;
          }
          if (!alike) turned_.push_back(other), std::reverse(next.begin(), next.end());
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
      Vector3d sum = Vector3d::Zero();
      for (int node : quads_[std::size_t(q)]) sum += surface_.nodes[std::size_t(node)] / 4;
      return sum;
    };
    for (int q : part) {
      const double own = normal_of(surface_.nodes, quads_[std::size_t(q)]).norm();
      middle += own * centre(q);
      area += own;
    }
    middle /= std::max(area, 1e-300);
    double flux = 0;
    for (int q : part)
      flux += (centre(q) - middle).dot(normal_of(surface_.nodes, quads_[std::size_t(q)]));
    if (flux < 0)
      for (int q : part) {
        auto& quad = quads_[std::size_t(q)];
        std::reverse(quad.begin(), quad.end());
        turned_.push_back(q);
      }
  }

  void find_normals() {
    std::vector<Vector3d> flat;
    for (const auto& quad : quads_) {
      const Vector3d n = normal_of(surface_.nodes, quad);
      if (!(n.norm() > 0))
        throw std::runtime_error("an element without an area at " +
                                 place(surface_.nodes[std::size_t(quad[0])]));
      flat.push_back(n);
    }
    normals_.resize(quads_.size());
    if (!surface_.normals.empty()) {
      normals_ = surface_.normals;
      for (int q : turned_)
        std::reverse(normals_[std::size_t(q)].begin(), normals_[std::size_t(q)].end());
      for (std::size_t q = 0; q < quads_.size(); ++q)
        for (Vector3d& n : normals_[q])
          if (n.dot(flat[q]) < 0) n = -n;
      return;
    }
    std::vector<std::vector<int>> at(surface_.nodes.size());
    for (std::size_t q = 0; q < quads_.size(); ++q)
      for (int node : quads_[q]) at[std::size_t(node)].push_back(int(q));
    const double least = std::cos(surface_.crease);
    for (std::size_t q = 0; q < quads_.size(); ++q)
      for (std::size_t c = 0; c < 4; ++c) {
        Vector3d sum = Vector3d::Zero();
        for (int other : at[std::size_t(quads_[q][c])])
          if (flat[q].normalized().dot(flat[std::size_t(other)].normalized()) >= least)
            sum += flat[std::size_t(other)];
        normals_[q][c] = sum.normalized();
      }
  }

  // Nodes half a thickness inwards, along the mean of the normals that meet there; where they
  // differ, so far that each face moves by its half.
  static void move_to_middle(Mesh& mesh, double thickness) {
    std::vector<std::vector<Vector3d>> normals(mesh.nodes.size());
    for (const ShellQuad& q : mesh.quads)
      for (int c = 0; c < 4; ++c)
        normals[std::size_t(q.nodes[std::size_t(c)])].push_back(q.directors.col(c));
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
    for (const auto& [edge, quads] : edges_)
      if (quads.size() == 1) {
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

  const SurfaceQuads& surface_;
  std::vector<std::array<int, 4>> quads_;
  std::map<Edge, std::vector<int>> edges_;
  std::vector<std::array<Vector3d, 4>> normals_;
  std::vector<int> turned_;
};

} // namespace

Mesh shell_mesh(const SurfaceQuads& surface, double thickness, WallSide side) {
  return Shells(surface).mesh(thickness, side);
}

} // namespace plica
