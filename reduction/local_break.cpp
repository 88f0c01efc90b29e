#include "reduction/substructures.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace plica {
namespace {

constexpr double same_place = 1e-9; // relative

struct RingPlace {
  int ring = -1;
  double angle = 0; // from x towards z
};

std::vector<RingPlace> places(const Mesh& mesh) {
  std::vector<RingPlace> place(mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.rings.size(); ++i) {
    const std::vector<int>& nodes = mesh.rings[i].nodes;
    for (std::size_t j = 0; j < nodes.size(); ++j)
      place[nodes[j]] = {static_cast<int>(i), 2 * M_PI * double(j) / double(nodes.size())};
  }
  return place;
}

// Components along the radius, the axis and the circle.
Eigen::Vector3d cylindrical(const Eigen::Vector3d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() + s * v.z(), v.y(), c * v.z() - s * v.x()};
}

// Rings with a node off their circle, or a wall that differs round them.
std::vector<bool> broken_rings(const Mesh& mesh, const std::vector<RingPlace>& place) {
  std::vector<bool> broken(mesh.rings.size(), false);
  for (std::size_t node = 0; node < place.size(); ++node) {
    if (place[node].ring < 0) continue;
    const Ring& ring = mesh.rings[place[node].ring];
    const Eigen::Vector3d x = cylindrical(mesh.nodes[node], place[node].angle);
    if ((x - Eigen::Vector3d(ring.radius, ring.y, 0)).norm() > same_place * ring.radius)
      broken[place[node].ring] = true;
  }
  // Director and thickness at a ring, seen from the quads on one side of it.
  std::map<std::pair<int, int>, std::pair<Eigen::Vector3d, double>> wall;
  for (const ShellQuad& quad : mesh.quads) {
    int rings = 0; // sum of both numbers: names the belt beside a ring
    for (int node : quad.nodes) rings += place[node].ring;
    for (int a = 0; a < 4; ++a) {
      const RingPlace& p = place[quad.nodes[a]];
      if (p.ring < 0) continue;
      const Eigen::Vector3d director = cylindrical(quad.directors.col(a), p.angle);
      const auto [first, is_new] = wall.try_emplace({p.ring, rings}, director, quad.thickness[a]);
      if (!is_new && ((first->second.first - director).norm() > same_place ||
                      std::abs(first->second.second / quad.thickness[a] - 1) > same_place))
        broken[p.ring] = true;
    }
  }
  return broken;
}

} // namespace

std::vector<int> nodes_around_breaks(const Model& model) {
  const Mesh& mesh = model.mesh;
  const std::vector<RingPlace> place = places(mesh);
  const std::vector<bool> broken = broken_rings(mesh, place);
  std::vector<bool> near(mesh.rings.size(), false);
  for (const ShellQuad& quad : mesh.quads) {
    const bool touches = std::any_of(quad.nodes.begin(), quad.nodes.end(), [&](int node) {
      return place[node].ring >= 0 && broken[place[node].ring];
    });
    for (int node : quad.nodes)
      if (touches && place[node].ring >= 0) near[place[node].ring] = true;
  }
  std::set<int> nodes;
  for (std::size_t i = 0; i < near.size(); ++i)
    if (near[i]) nodes.insert(mesh.rings[i].nodes.begin(), mesh.rings[i].nodes.end());
  for (const Constraint& c : model.constraints) // ties of a liner; spiders follow one node
    if (c.terms.size() > 6 && place[c.node].ring < 0 && nodes.contains(c.terms.front().node))
      nodes.insert(c.node);
  return {nodes.begin(), nodes.end()};
}

} // namespace plica
