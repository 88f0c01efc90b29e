#include "diagnose/effects/wall_spots.hpp"

#include "diagnose/effects/held_motions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

namespace plica {
namespace {

using Eigen::Vector3d;

constexpr std::size_t looked_at = 24, with_those_between = 96;

// Sum of the normals of the shells at each node of a part, each as long as its shell is large;
// nodes of beams alone have none.
std::map<int, Vector3d> normals_of(const Model& model, const std::string& part) {
  std::map<int, Vector3d> normals;
  const auto own = [&](int component) {
    return component >= 0 && model.components[std::size_t(component)] == part;
  };
  const auto x = [&](int node) { return model.mesh.nodes[std::size_t(node)]; };
  const auto add = [&](const auto& shell, const Vector3d& normal) {
    if (!own(model.shells[std::size_t(shell.section)].component)) return;
    for (int node : shell.nodes) normals.try_emplace(node, Vector3d::Zero()).first->second += normal;
  };
  for (const ShellQuad& q : model.mesh.quads)
    add(q, (x(q.nodes[2]) - x(q.nodes[0])).cross(x(q.nodes[3]) - x(q.nodes[1])));
  for (const ShellTriangle& t : model.mesh.triangles)
    add(t, (x(t.nodes[1]) - x(t.nodes[0])).cross(x(t.nodes[2]) - x(t.nodes[0])));
  for (const BeamElement& b : model.beams)
    if (own(b.component))
      for (int node : {b.node1, b.node2}) normals.try_emplace(node, Vector3d::Zero());
  return normals;
}

// Up to so many of these nodes, each as far as may be from those before it; the first from the
// middle.
std::vector<int> spread_over(const Mesh& mesh, const std::vector<int>& nodes, std::size_t most) {
  const auto x = [&](int node) { return mesh.nodes[std::size_t(node)]; };
  Vector3d middle = Vector3d::Zero();
  for (int node : nodes) middle += x(node) / double(nodes.size());
  std::vector<double> away;
  for (int node : nodes) away.push_back((x(node) - middle).norm());
  std::vector<int> chosen;
  while (chosen.size() < std::min(most, nodes.size())) {
    const auto farthest = std::max_element(away.begin(), away.end());
    if (!(*farthest > 0)) break; // what is left shares its place with others
    chosen.push_back(nodes[std::size_t(farthest - away.begin())]);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double own = (x(nodes[i]) - x(chosen.back())).norm();
      away[i] = chosen.size() == 1 ? own : std::min(away[i], own);
    }
  }
  return chosen;
}

// Millimetres, as many digits as tell a thousandth of the size of the part.
std::string place_name(const std::string& part, const Vector3d& x, double size) {
  const int digits = std::max(0, int(std::ceil(-std::log10(size))));
  std::string name = part + ".spot";
  for (double metres : x) {
    const double unit = std::pow(10, -digits);
    const double rounded = unit * std::round(1e3 * metres / unit);
    name += fmt::format("[{:.{}f}]", rounded == 0 ? 0. : rounded, digits);
  }
  return name;
}

// The three nearest of those that are looked at, the nearer the more.
PlaceShares nearest_looked_at(const std::vector<Spot>& spots, const Mesh& mesh, const Vector3d& x) {
  std::vector<std::pair<double, std::string>> by_distance;
  for (const Spot& spot : spots)
    if (spot.between.empty())
      by_distance.emplace_back((mesh.nodes[std::size_t(spot.touched)] - x).norm(), spot.place);
  const std::size_t count = std::min<std::size_t>(3, by_distance.size());
  std::partial_sort(by_distance.begin(), by_distance.begin() + std::ptrdiff_t(count),
                    by_distance.end());
  PlaceShares between;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += 1 / by_distance[i].first;
  for (std::size_t i = 0; i < count; ++i)
    between.emplace_back(by_distance[i].second, 1 / (by_distance[i].first * sum));
  return between;
}

} // namespace

std::vector<Spot> wall_spots(const BuiltCase& built, const std::string& part) {
  const Mesh& mesh = built.model.mesh;
  const std::map<int, Vector3d> normals = normals_of(built.model, part);
  const HeldMotions held(built);
  const auto spot_at = [&](int node, const Vector3d& normal) {
    Spot spot{.place = "", .nodes = {node}, .touched = node};
    if (normal.norm() > 0) spot.normal = normal.normalized();
    return spot;
  };
  std::vector<int> nodes;
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& [node, normal] : normals) {
    if (!held.leave(spot_at(node, normal))) continue;
    nodes.push_back(node);
    low = low.cwiseMin(mesh.nodes[std::size_t(node)]);
    high = high.cwiseMax(mesh.nodes[std::size_t(node)]);
  }
  std::vector<Spot> found;
  std::set<std::string> names;
  for (int node : spread_over(mesh, nodes, with_those_between)) {
    const Vector3d& x = mesh.nodes[std::size_t(node)];
    Spot spot = spot_at(node, normals.at(node));
    spot.place = place_name(part, x, (high - low).norm());
    if (!names.insert(spot.place).second) continue;
    if (found.size() >= looked_at) spot.between = nearest_looked_at(found, mesh, x);
    found.push_back(std::move(spot));
  }
  return found;
}

} // namespace plica
