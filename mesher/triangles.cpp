#include "mesher/triangles.hpp"

#include "mesh/generation/gmsh_session.hpp"
#include "mesher/meshed.hpp"
#include "words/short_text.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace plica {
namespace {

namespace cad = gmsh::model;
using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

std::string mm_text(const Vector3d& x) {
  return short_text(Vector3d(1e3 * x)) + " mm";
}

Eigen::AlignedBox3d box_of(const SurfaceFaces& surface) {
  Eigen::AlignedBox3d box;
  for (const auto& face : surface.faces)
    for (int node : face)
      if (node >= 0) box.extend(surface.nodes[std::size_t(node)]);
  return box;
}

// Where its parametrisation fails, Gmsh puts nodes anywhere, or meshes a face twice.
void require_same(const SurfaceFaces& made, const SurfaceFaces& given, double size) {
  constexpr const char* advice = ": another element_size, or none: the triangles of the file";
  constexpr double tolerance = 0.03;
  const double area = area_of(made), right = area_of(given);
  if (!(std::abs(area - right) <= tolerance * right))
    throw std::runtime_error("Gmsh made a mesh of " + area_text(area) + " of triangles of " +
                             area_text(right) + advice);
  const Eigen::AlignedBox3d box = box_of(made), of = box_of(given);
  const double gap = std::max((box.min() - of.min()).cwiseAbs().maxCoeff(),
                              (box.max() - of.max()).cwiseAbs().maxCoeff());
  if (!(gap <= size / 2))
    throw std::runtime_error("Gmsh made a mesh from " + mm_text(box.min()) + " to " +
                             mm_text(box.max()) + " of triangles from " + mm_text(of.min()) +
                             " to " + mm_text(of.max()) + advice);
}

} // namespace

SurfaceFaces as_they_are(const Surface& surface) {
  SurfaceFaces faces{.nodes = surface.nodes, .faces = {}, .normals = {}};
  for (const auto& [a, b, c] : surface.triangles) faces.faces.push_back({a, b, c, -1});
  return faces;
}

void require_single_wall(const Surface& surface) {
  const auto at = [&](int node) { return surface.nodes[std::size_t(node)]; };
  const auto fail = [&](const std::string& what, int node) {
    throw std::runtime_error(what + " at " + mm_text(at(node)) +
                             ": the wall would be counted twice; leave one out");
  };
  std::map<Triangle, int> known;
  struct Side {
    Vector3d normal, inwards; // of length 1
  };
  std::map<std::pair<int, int>, std::vector<Side>> edges;
  for (const Triangle& t : surface.triangles) {
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (!known.try_emplace(sorted, 0).second)
      fail("two triangles have the same three vertices, one", t[0]);
    const Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back(
          {normal, normal.cross(at(b) - at(a)).normalized()});
    }
  }
  constexpr double flat = 0.99985; // cosine of 1 degree
  for (const auto& [edge, sides] : edges)
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (sides[i].inwards.dot(sides[j].inwards) > flat)
          fail("two triangles lie on each other at their common edge, one end", edge.first);
}

void require_no_gap(const Surface& surface) {
  const auto at = [&](int node) { return surface.nodes[std::size_t(node)]; };
  constexpr double farthest = 1000;
  if (const Eigen::AlignedBox3d box = box_of(as_they_are(surface));
      !(box.diagonal().norm() <= farthest))
    throw std::runtime_error("its triangles reach from " + mm_text(box.min()) + " to " +
                             mm_text(box.max()) + ": is its unit right?");
  constexpr std::size_t few = 12; // such loops are their outlines
  if (surface.triangles.size() <= few) return;
  std::map<std::pair<int, int>, std::vector<int>> edges;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = surface.triangles[t][i], b = surface.triangles[t][(i + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back(int(t));
    }
  std::map<int, std::map<int, int>> free; // node, next node, triangle
  for (const auto& [edge, own] : edges)
    if (own.size() == 1) free[edge.first][edge.second] = free[edge.second][edge.first] = own[0];
  const auto fail = [&](int node, const char* what) {
    throw std::runtime_error(std::string(what) + " at " + mm_text(at(node)) +
                             ": the file is damaged, or its triangles do not meet within `weld`");
  };
  for (const auto& [a, after] : free)
    for (const auto& [b, first] : after)
      for (const auto& [c, second] : free.at(b)) {
        if (c == a) continue;
        for (const auto& [d, third] : free.at(c)) {
          if (d == b) continue;
          if (d == a && std::set{first, second, third}.size() == 3)
            fail(a, "a triangle is missing in the surface");
          if (d == a || !free.at(d).contains(a)) continue;
          if (std::set{first, second, third, free.at(d).at(a)}.size() == 3)
            fail(a, "a triangle has a corner away from its neighbours");
        }
      }
}

SurfaceFaces remesh(const Surface& surface, double size) {
  return in_gmsh([&] {
    constexpr int triangle = 2;
    std::vector<std::size_t> tags(surface.nodes.size()), corners;
    std::iota(tags.begin(), tags.end(), 1);
    std::vector<double> x;
    for (const Vector3d& p : surface.nodes) x.insert(x.end(), {p.x(), p.y(), p.z()});
    for (const Triangle& t : surface.triangles)
      for (int node : t) corners.push_back(std::size_t(node) + 1);
    cad::addDiscreteEntity(2, 1);
    cad::mesh::addNodes(2, 1, tags, x);
    cad::mesh::addElementsByType(1, triangle, {}, corners);
    constexpr double sharp = 40 * std::numbers::pi / 180;
    cad::mesh::classifySurfaces(sharp, true, true, sharp);
    cad::mesh::createGeometry();
    for (const auto& face : faces_of_model()) cad::mesh::setRecombine(2, face.second);
    gmsh::option::setNumber("Mesh.CharacteristicLengthMin", size);
    gmsh::option::setNumber("Mesh.CharacteristicLengthMax", size);
    mesh_faces();
    const SurfaceFaces made = collected();
    require_same(made, as_they_are(surface), size);
    return in_order(made);
  });
}

} // namespace plica
