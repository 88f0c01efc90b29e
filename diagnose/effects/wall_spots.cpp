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

// So many are looked at first; then, where these come near, some of so many in all, twice as close;
// and twice as close again.
constexpr std::array<std::size_t, 3> levels{24, 96, 384};

// Normals of the shells at a node, each as long as its shell is large, whichever way round its
// corners are listed.
struct NodeNormal {
  Vector3d sum = Vector3d::Zero();
  double sizes = 0;
  void add(const Vector3d& normal) {
    sum += sum.dot(normal) < 0 ? -normal : normal;
    sizes += normal.norm();
  }
  // None: there are beams alone, or shells that stand across each other.
  std::optional<Vector3d> mean() const {
    constexpr double clear = 0.1;
    return sizes > 0 && sum.norm() > clear * sizes ? std::optional<Vector3d>(sum.normalized())
                                                   : std::nullopt;
  }
};

// Of the nodes of shells and beams of a part.
std::map<int, NodeNormal> normals_of(const Model& model, const std::string& part) {
  std::map<int, NodeNormal> normals;
  const auto own = [&](int component) {
    return component >= 0 && model.components[std::size_t(component)] == part;
  };
  const auto x = [&](int node) { return model.mesh.nodes[std::size_t(node)]; };
  const auto add = [&](const auto& shell, const Vector3d& normal) {
    if (own(model.shells[std::size_t(shell.section)].component))
      for (int node : shell.nodes) normals[node].add(normal);
  };
  for (const ShellQuad& q : model.mesh.quads)
    add(q, (x(q.nodes[2]) - x(q.nodes[0])).cross(x(q.nodes[3]) - x(q.nodes[1])));
  for (const ShellTriangle& t : model.mesh.triangles)
    add(t, (x(t.nodes[1]) - x(t.nodes[0])).cross(x(t.nodes[2]) - x(t.nodes[0])));
  for (const BeamElement& b : model.beams)
    if (own(b.component))
      for (int node : {b.node1, b.node2}) normals.try_emplace(node);
  return normals;
}

// Up to so many of these nodes: the one nearest to their middle, then each as far as may be from
// those before it.
std::vector<int> spread_over(const Mesh& mesh, const std::vector<int>& nodes, std::size_t most) {
  if (nodes.empty()) return {};
  const auto x = [&](int node) { return mesh.nodes[std::size_t(node)]; };
  Vector3d middle = Vector3d::Zero();
  for (int node : nodes) middle += x(node) / double(nodes.size());
  std::vector<int> chosen{*std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) {
    return (x(a) - middle).squaredNorm() < (x(b) - middle).squaredNorm();
  })};
  std::vector<double> away(nodes.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < most) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      away[i] = std::min(away[i], (x(nodes[i]) - x(chosen.back())).norm());
    const auto farthest = std::max_element(away.begin(), away.end());
    if (!(*farthest > 0)) break; // what is left shares its place with others
    chosen.push_back(nodes[std::size_t(farthest - away.begin())]);
  }
  return chosen;
}

// Millimetres, as many digits as tell a thousandth of the size of the part.
std::string place_name(const std::string& part, const Vector3d& x, double size) {
  const int digits = size > 0 ? std::max(0, int(std::ceil(-std::log10(size)))) : 0;
  std::string name = part + ".spot";
  for (double metres : x) {
    const double unit = std::pow(10, -digits);
    const double rounded = unit * std::round(1e3 * metres / unit);
    name += fmt::format("[{:.{}f}]", rounded == 0 ? 0. : rounded, digits);
  }
  return name;
}

// The three nearest of the first so many that move the same ways, the nearer the more.
PlaceShares nearest_of(const std::vector<Spot>& spots, std::size_t first, const Mesh& mesh,
                       const Spot& spot) {
  const auto x = [&](const Spot& at) { return mesh.nodes[std::size_t(at.touched)]; };
  std::vector<std::pair<double, std::string>> by_distance;
  for (std::size_t i = 0; i < first; ++i)
    if (const Spot& other = spots[i]; other.normal.has_value() == spot.normal.has_value())
      by_distance.emplace_back((x(other) - x(spot)).norm(), other.place);
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

// Spots spread over nodes, by the way that each gives way.
std::vector<Spot> spots_among(const Mesh& mesh, const std::string& part,
                              const std::map<int, std::optional<Vector3d>>& normals) {
  std::vector<int> nodes;
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& [node, normal] : normals) {
    nodes.push_back(node);
    low = low.cwiseMin(mesh.nodes[std::size_t(node)]);
    high = high.cwiseMax(mesh.nodes[std::size_t(node)]);
  }
  std::vector<Spot> found;
  std::set<std::string> names;
  std::size_t level = 0;
  for (int node : spread_over(mesh, nodes, levels.back())) {
    if (found.size() == levels[level]) ++level;
    Spot spot{.place = place_name(part, mesh.nodes[std::size_t(node)], (high - low).norm()),
              .nodes = {node},
              .touched = node,
              .normal = normals.at(node),
              .free_numbers = 2};
    if (!names.insert(spot.place).second) continue;
    if (level > 0) spot.between = nearest_of(found, levels[level - 1], mesh, spot);
    found.push_back(std::move(spot));
  }
  for (Spot& spot : found) spot.weight = 1 / double(found.size());
  return found;
}

} // namespace

bool is_from_file(const Part& part) {
  return std::holds_alternative<SurfacePart>(part.body) ||
         std::holds_alternative<DeckPart>(part.body);
}

std::vector<Spot> wall_spots(const BuiltCase& built, const std::string& part) {
  const HeldMotions held(built);
  std::map<int, std::optional<Vector3d>> normals;
  for (const auto& [node, normal] : normals_of(built.model, part))
    if (held.let_move({.place = "", .nodes = {}, .touched = node, .normal = normal.mean()}))
      normals[node] = normal.mean();
  return spots_among(built.model.mesh, part, normals);
}

std::vector<Spot> damage_spots(const BuiltCase& built, const std::string& part) {
  std::map<int, std::optional<Vector3d>> nodes;
  for (const auto& [node, normal] : normals_of(built.model, part)) nodes[node] = std::nullopt;
  return spots_among(built.model.mesh, part, nodes);
}

} // namespace plica
