#include "model/shape/wall_places.hpp"

#include "model/description/place_keys.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace plica {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double least = 1e-3; // of the shape function of a corner that follows

struct Shapes {
  Eigen::Vector4d N, dr, ds;
};

Shapes quad_shapes(double r, double s) {
  const Eigen::Array4d R = 1 + r * Eigen::Array4d(-1, 1, 1, -1);
  const Eigen::Array4d S = 1 + s * Eigen::Array4d(-1, -1, 1, 1);
  return {.N = R * S / 4,
          .dr = Eigen::Array4d(-1, 1, 1, -1) * S / 4,
          .ds = Eigen::Array4d(-1, -1, 1, 1) * R / 4};
}

// Nearest point of the bilinear patch: Gauss-Newton, held inside.
WallPoint on_shell(const Mesh& mesh, const ShellQuad& quad, const Vector3d& point) {
  Eigen::Matrix<double, 3, 4> X;
  for (int a = 0; a < 4; ++a) X.col(a) = mesh.nodes[std::size_t(quad.nodes[std::size_t(a)])];
  Vector2d at(0, 0);
  for (int i = 0; i < 40; ++i) {
    const Shapes n = quad_shapes(at[0], at[1]);
    Eigen::Matrix<double, 3, 2> J;
    J << X * n.dr, X * n.ds;
    const Vector2d gradient = J.transpose() * (point - X * n.N);
    Vector2d step = (J.transpose() * J).ldlt().solve(gradient);
    for (int k : {0, 1}) // along an edge alone, where it presses against one
      if (std::abs(at[k]) == 1 && at[k] * step[k] > 0) {
        const int other = 1 - k;
        step[k] = 0;
        step[other] = gradient[other] / J.col(other).squaredNorm();
      }
    const Vector2d next = (at + step).cwiseMax(-1).cwiseMin(1);
    const double moved = (next - at).norm();
    at = next;
    if (moved < 1e-14) break;
  }
  const Shapes n = quad_shapes(at[0], at[1]);
  const Vector3d x = X * n.N;
  return {.nodes = {quad.nodes.begin(), quad.nodes.end()},
          .N = {n.N.begin(), n.N.end()},
          .at = x,
          .distance = (point - x).norm(),
          .thickness = n.N.dot(quad.thickness)};
}

// Nearest point of a triangle: inside, or on the nearest of its edges.
WallPoint on_shell(const Mesh& mesh, const ShellTriangle& shell, const Vector3d& point) {
  Eigen::Matrix3d X;
  for (int a = 0; a < 3; ++a) X.col(a) = mesh.nodes[std::size_t(shell.nodes[std::size_t(a)])];
  const Vector3d e1 = X.col(1) - X.col(0), e2 = X.col(2) - X.col(0);
  Eigen::Matrix<double, 3, 2> J;
  J << e1, e2;
  const Vector2d rs = (J.transpose() * J).ldlt().solve(J.transpose() * (point - X.col(0)));
  Vector3d N(1 - rs[0] - rs[1], rs[0], rs[1]);
  if (N.minCoeff() < 0) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const Vector3d edge = X.col(b) - X.col(a);
      const double share = std::clamp((point - X.col(a)).dot(edge) / edge.squaredNorm(), 0., 1.);
      Vector3d own = Vector3d::Zero();
      own[a] = 1 - share;
      own[b] = share;
      if (const double d = (X * own - point).norm(); d < nearest) {
        nearest = d;
        N = own;
      }
    }
  }
  const Vector3d x = X * N;
  return {.nodes = {shell.nodes.begin(), shell.nodes.end()},
          .N = {N.begin(), N.end()},
          .at = x,
          .distance = (point - x).norm(),
          .thickness = N.dot(shell.thickness)};
}

// Distance that a point has at least from a shell.
template <class Shell>
double at_least(const Mesh& mesh, const Shell& shell, const Vector3d& point) {
  const Vector3d& first = mesh.nodes[std::size_t(shell.nodes[0])];
  double reach = 0; // of its farthest corner
  for (int node : shell.nodes)
    reach = std::max(reach, (mesh.nodes[std::size_t(node)] - first).norm());
  return (point - first).norm() - reach;
}

// u of a node, and the arm from it: factor (u + theta x arm).
struct Follower {
  int node = 0;
  double factor = 0;
  Vector3d arm{0, 0, 0};
};

// A node that follows the sum of others: theta the sum of their factor theta.
void add_rows(Model& model, int node, const std::vector<Follower>& of, const std::string& origin) {
  for (int dof = 0; dof < 6; ++dof) {
    Constraint row{.node = node, .dof = dof, .terms = {}, .origin = origin};
    for (const Follower& f : of) {
      if (f.factor == 0) continue;
      row.terms.push_back({f.node, dof, f.factor});
      if (dof >= 3) continue;
      for (int k = 0; k < 3; ++k)
        if (const double lever = Vector3d::Unit(k).cross(f.arm)[dof]; lever != 0)
          row.terms.push_back({f.node, 3 + k, f.factor * lever});
    }
    model.constraints.push_back(std::move(row));
  }
}

// Ties places one after the other. Corners that follow already are put in terms of what they
// follow, so that two places in one element do not determine each other in a circle.
class Ties {
public:
  explicit Ties(Building& b) : model_(b.built.model) {
    for (const PlacedOnWall& place : b.wall_places) places_.insert(place.node);
    determined_.insert(b.built.held_nodes.begin(), b.built.held_nodes.end());
    for (const Constraint& row : model_.constraints) determined_.insert(row.node);
  }

  void add(const PlacedOnWall& place) {
    const Vector3d& x = model_.mesh.nodes[std::size_t(place.node)];
    const WallPoint wall = nearest_on_wall(model_, x, place.component);
    const std::vector<Follower> sum = wall_motion(wall);
    const auto corner = largest_free(sum);
    if (!corner) {
      if (determined_.contains(place.node))
        input_error(part_key(place.name), "is held, on a wall whose motion is determined already",
                    "a place farther inside the wall, or nothing that holds it");
      tie_to_wall(model_, place.node, wall, "place " + place.name);
      determined_.insert(place.node);
      return;
    }
    std::vector<Follower>& of = follows_[corner->node];
    of.push_back({place.node, 1 / corner->factor, wall.at - x});
    for (const Follower& f : sum)
      if (f.node != corner->node) of.push_back({f.node, -f.factor / corner->factor, f.arm});
    add_rows(model_, corner->node, of, "place " + place.name);
    determined_.insert(corner->node);
  }

private:
  std::vector<Follower> wall_motion(const WallPoint& wall) const {
    std::vector<Follower> sum;
    const auto add = [&](const Follower& f) {
      const auto same = std::find_if(sum.begin(), sum.end(), [&](const Follower& other) {
        return other.node == f.node && other.arm == f.arm;
      });
      if (same == sum.end())
        sum.push_back(f);
      else
        same->factor += f.factor;
    };
    for (std::size_t a = 0; a < wall.nodes.size(); ++a)
      for_each_free({.node = wall.nodes[a], .factor = wall.N[a]}, add);
    return sum;
  }

  // f(what a corner follows, down to nodes that follow nothing here), or the corner itself.
  template <class F> void for_each_free(const Follower& of, F&& f) const {
    const auto known = follows_.find(of.node);
    if (known == follows_.end()) return f(of);
    for (const Follower& next : known->second)
      for_each_free({next.node, of.factor * next.factor, next.arm}, f);
  }

  // Of corners, which have no arms; nothing where all are determined or their shares are none.
  std::optional<Follower> largest_free(const std::vector<Follower>& sum) const {
    std::optional<Follower> best;
    for (const Follower& f : sum)
      if (std::abs(f.factor) > std::max(least, best ? std::abs(best->factor) : 0) &&
          f.arm.isZero() && !determined_.contains(f.node) && !places_.contains(f.node))
        best = f;
    return best;
  }

  Model& model_;
  std::set<int> determined_, places_;
  std::map<int, std::vector<Follower>> follows_; // corners by places
};

} // namespace

WallPoint nearest_on_wall(const Model& model, const Vector3d& point, int component) {
  WallPoint nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  const auto look = [&](const auto& shells) {
    for (const auto& shell : shells) {
      if (component >= 0 && model.shells[std::size_t(shell.section)].component != component)
        continue;
      if (at_least(model.mesh, shell, point) >= nearest.distance) continue;
      if (WallPoint own = on_shell(model.mesh, shell, point); own.distance < nearest.distance)
        nearest = std::move(own);
    }
  };
  look(model.mesh.quads);
  look(model.mesh.triangles);
  return nearest;
}

double off_wall(const WallPoint& wall) {
  return std::max(0., wall.distance - wall.thickness / 2);
}

void tie_to_wall(Model& model, int node, const WallPoint& wall, const std::string& origin) {
  const Vector3d arm = model.mesh.nodes[std::size_t(node)] - wall.at;
  std::vector<Follower> corners;
  for (std::size_t a = 0; a < wall.nodes.size(); ++a)
    corners.push_back({wall.nodes[a], wall.N[a], arm});
  add_rows(model, node, corners, origin);
}

void add_wall_places(Building& b, const std::string& part, const std::vector<PartPlace>& places,
                     int component) {
  for (const PartPlace& place : places) {
    const std::string name = part + ".places." + place.name;
    const WallPoint wall = nearest_on_wall(b.built.model, vector(place.at), component);
    if (wall.nodes.empty())
      input_error(part_key(name), "is on no shell: the part has none",
                  "`within`, for the nodes near the place");
    if (const double off = off_wall(wall); off > sensor_reach)
      input_error(part_key(name) + ".at", fmt::format("is {:.2f} mm off the wall", 1e3 * off),
                  fmt::format("at most {:.0f} mm; the wall is nearest at [{:.2f} mm, {:.2f} mm, "
                              "{:.2f} mm]",
                              1e3 * sensor_reach, 1e3 * wall.at.x(), 1e3 * wall.at.y(),
                              1e3 * wall.at.z()));
    const int node = add_node(b.built.model, vector(place.at));
    b.built.model.mesh.sets[part + "." + place.name] = {node};
    b.wall_places.push_back({node, component, name});
  }
}

void tie_wall_places(Building& b) {
  Ties ties(b);
  for (const PlacedOnWall& place : b.wall_places) ties.add(place);
}

} // namespace plica
