#include "io/report/surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plica {
namespace {

// Rings [first, last] that quads join one to the next.
struct Chain {
  int first = 0, last = 0;
};

struct Split {
  std::vector<Chain> chains;
  std::vector<std::array<int, 4>> loose; // what does not lie between two neighbouring rings
};

Split split(const Mesh& mesh) {
  std::vector<int> ring_of(mesh.nodes.size(), -1);
  for (std::size_t ring = 0; ring < mesh.rings.size(); ++ring) {
    for (const int node : mesh.rings[ring].nodes) ring_of[node] = static_cast<int>(ring);
  }
  std::vector<bool> joined(mesh.rings.size(), false);
  Split result;
  for (const ShellQuad& quad : mesh.quads) {
    int low = ring_of[quad.nodes[0]], high = low;
    for (const int node : quad.nodes) {
      low = std::min(low, ring_of[node]);
      high = std::max(high, ring_of[node]);
    }
    const bool between = low >= 0 && high == low + 1 &&
                         mesh.rings[low].nodes.size() == mesh.rings[high].nodes.size();
    if (between)
      joined[low] = true;
    else
      result.loose.push_back(quad.nodes);
  }
  for (const ShellTriangle& t : mesh.triangles)
    result.loose.push_back({t.nodes[0], t.nodes[1], t.nodes[2], t.nodes[2]});
  const int count = static_cast<int>(mesh.rings.size());
  for (int ring = 0; ring < count;) {
    const int first = ring;
    while (ring < count && joined[ring]) ++ring;
    if (ring > first) result.chains.push_back({first, ring});
    ++ring;
  }
  return result;
}

// First and last ring, and those where the radius or y turns back.
std::vector<int> turning_rings(const std::vector<Ring>& rings, const Chain& chain) {
  std::vector<int> turning{chain.first};
  double previous_dr = 0, previous_dy = 0;
  for (int ring = chain.first; ring < chain.last; ++ring) {
    const double dr = rings[ring + 1].radius - rings[ring].radius;
    const double dy = rings[ring + 1].y - rings[ring].y;
    const double step = 1e-6 * std::hypot(dr, dy);
    const bool turns = dr * previous_dr < 0 || dy * previous_dy < 0;
    if (turns && turning.back() != ring) turning.push_back(ring);
    if (std::abs(dr) > step) previous_dr = dr;
    if (std::abs(dy) > step) previous_dy = dy;
  }
  turning.push_back(chain.last);
  return turning;
}

// At most `parts` equal stretches between neighbouring turning rings.
std::vector<int> kept_rings(const std::vector<int>& turning, int parts) {
  std::vector<int> kept{turning.front()};
  for (std::size_t i = 1; i < turning.size(); ++i) {
    const int length = turning[i] - turning[i - 1];
    const int steps = std::min(parts, length);
    for (int step = 1; step <= steps; ++step) {
      kept.push_back(turning[i - 1] + length * step / steps);
    }
  }
  return kept;
}

void add_between(std::vector<std::array<int, 4>>& quads, const Ring& left, const Ring& right,
                 int columns) {
  const int around = static_cast<int>(left.nodes.size());
  const int count = std::min(columns, around);
  for (int column = 0; column < count; ++column) {
    const int a = around * column / count;
    const int b = around * (column + 1) / count % around;
    quads.push_back({left.nodes[a], right.nodes[a], right.nodes[b], left.nodes[b]});
  }
}

void add_chains(std::vector<std::array<int, 4>>& quads, const Mesh& mesh,
                const std::vector<Chain>& chains, int budget) {
  constexpr int fewest_columns = 36, most_columns = 72;
  std::vector<std::vector<int>> turning;
  turning.reserve(chains.size());
  for (const Chain& chain : chains) turning.push_back(turning_rings(mesh.rings, chain));
  std::vector<std::vector<int>> kept;
  int strips = 0;
  for (int parts = 8; parts >= 1; --parts) {
    kept.clear();
    strips = 0;
    for (const std::vector<int>& rings : turning) {
      kept.push_back(kept_rings(rings, parts));
      strips += static_cast<int>(kept.back().size()) - 1;
    }
    if (strips * fewest_columns <= budget) break;
  }
  const int columns = std::clamp(budget / std::max(strips, 1), 8, most_columns);
  for (const std::vector<int>& rings : kept) {
    for (std::size_t i = 1; i < rings.size(); ++i) {
      add_between(quads, mesh.rings[rings[i - 1]], mesh.rings[rings[i]], columns);
    }
  }
}

std::vector<std::array<int, 4>>
clustered(const Mesh& mesh, const std::vector<std::array<int, 4>>& quads, double cell) {
  std::map<std::array<long, 3>, int> node_of_cell;
  const auto representative = [&](int node) {
    std::array<long, 3> key{};
    for (int i = 0; i < 3; ++i) key[i] = std::lround(mesh.nodes[node][i] / cell);
    return node_of_cell.try_emplace(key, node).first->second;
  };
  std::set<std::array<int, 4>> seen;
  std::vector<std::array<int, 4>> result;
  for (std::array<int, 4> quad : quads) {
    for (int& node : quad) node = representative(node);
    std::array<int, 4> sorted = quad;
    std::sort(sorted.begin(), sorted.end());
    const auto different = std::set<int>(quad.begin(), quad.end()).size();
    if (different >= 3 && seen.insert(sorted).second) result.push_back(quad);
  }
  return result;
}

void add_loose(std::vector<std::array<int, 4>>& quads, const Mesh& mesh,
               const std::vector<std::array<int, 4>>& loose, int budget) {
  std::vector<std::array<int, 4>> thinned = loose;
  double cell = 0;
  for (const Eigen::Vector3d& node : mesh.nodes) cell = std::max(cell, node.norm());
  cell /= 256;
  while (static_cast<int>(thinned.size()) > budget) {
    thinned = clustered(mesh, loose, cell);
    cell *= 1.25;
  }
  quads.insert(quads.end(), thinned.begin(), thinned.end());
}

} // namespace

std::vector<std::array<int, 4>> drawn_quads(const Mesh& mesh, int budget) {
  const Split parts = split(mesh);
  std::vector<std::array<int, 4>> quads;
  const bool both = !parts.loose.empty() && !parts.chains.empty();
  add_chains(quads, mesh, parts.chains, both ? budget * 2 / 3 : budget);
  add_loose(quads, mesh, parts.loose, both ? budget / 3 : budget);
  return quads;
}

} // namespace plica
