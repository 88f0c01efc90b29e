#include "mesher/meshed.hpp"

#include "words/short_text.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace plica {

namespace cad = gmsh::model;

gmsh::vectorpair faces_of_model() {
  gmsh::vectorpair faces;
  cad::getEntities(faces, 2);
  return faces;
}

void mesh_faces() {
  // Gmsh would throw through its own parallel loop.
  constexpr int stop_meshing = 1;
  gmsh::option::setNumber("General.AbortOnError", stop_meshing);
  gmsh::logger::start();
  cad::mesh::generate(2);
  std::vector<std::string> log;
  gmsh::logger::get(log);
  gmsh::logger::stop();
  constexpr std::string_view error = "Error: ";
  for (const std::string& line : log)
    if (line.starts_with(error))
      throw std::runtime_error("Gmsh says: " + line.substr(error.size()));
}

SurfaceFaces collected() {
  SurfaceFaces surface;
  std::map<std::size_t, int> number;
  for (const auto& face : faces_of_model()) {
    std::vector<std::size_t> tags;
    std::vector<double> x, ignored;
    cad::mesh::getNodes(tags, x, ignored, 2, face.second, true, false);
    for (std::size_t i = 0; i < tags.size(); ++i)
      if (number.try_emplace(tags[i], int(surface.nodes.size())).second)
        surface.nodes.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, nodes;
    cad::mesh::getElements(types, elements, nodes, 2, face.second);
    constexpr int triangle = 2, quad = 3;
    for (std::size_t t = 0; t < types.size(); ++t) {
      if (types[t] != quad && types[t] != triangle)
        throw std::runtime_error("Gmsh left elements that are no quads and no triangles");
      const std::size_t corners = types[t] == quad ? 4 : 3;
      for (std::size_t e = 0; e < elements[t].size(); ++e) {
        std::array<int, 4> q{-1, -1, -1, -1};
        for (std::size_t c = 0; c < corners; ++c) q[c] = number.at(nodes[t][corners * e + c]);
        surface.faces.push_back(q);
      }
    }
  }
  if (surface.faces.empty()) throw std::runtime_error("Gmsh made no element");
  return surface;
}

SurfaceFaces in_order(const SurfaceFaces& surface) {
  const std::size_t count = surface.nodes.size();
  std::vector<std::size_t> nodes(count), faces(surface.faces.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  const auto key = [&](std::size_t i) {
    const Eigen::Vector3d& x = surface.nodes[i];
    return std::tuple(x.y(), x.x(), x.z());
  };
  std::stable_sort(nodes.begin(), nodes.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<int> number(count);
  SurfaceFaces ordered;
  for (std::size_t i = 0; i < count; ++i) {
    number[nodes[i]] = int(i);
    ordered.nodes.push_back(surface.nodes[nodes[i]]);
  }
  struct Corner {
    int node;
    std::size_t was;
  };
  std::vector<std::array<Corner, 4>> all;
  for (const auto& face : surface.faces) {
    const std::size_t corners = face[3] < 0 ? 3 : 4;
    std::array<Corner, 4> own{{{-1, 0}, {-1, 0}, {-1, 0}, {-1, 3}}};
    for (std::size_t c = 0; c < corners; ++c) own[c] = {number[std::size_t(face[c])], c};
    const auto before = [](const Corner& a, const Corner& b) { return a.node < b.node; };
    const auto end = own.begin() + std::ptrdiff_t(corners);
    std::rotate(own.begin(), std::min_element(own.begin(), end, before), end);
    if (own[1].node > own[corners - 1].node) std::reverse(own.begin() + 1, end);
    all.push_back(own);
  }
  std::iota(faces.begin(), faces.end(), 0);
  const auto nodes_of = [&](std::size_t f) {
    return std::array{all[f][0].node, all[f][1].node, all[f][2].node, all[f][3].node};
  };
  std::sort(faces.begin(), faces.end(),
            [&](std::size_t a, std::size_t b) { return nodes_of(a) < nodes_of(b); });
  for (std::size_t f : faces) {
    ordered.faces.push_back(nodes_of(f));
    if (surface.normals.empty()) continue;
    std::array<Eigen::Vector3d, 4>& normals = ordered.normals.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) normals[c] = surface.normals[f][all[f][c].was];
  }
  return ordered;
}

double area_of(const SurfaceFaces& surface) {
  const auto at = [&](int node) { return surface.nodes[std::size_t(node)]; };
  double sum = 0;
  for (const auto& [a, b, c, d] : surface.faces) {
    sum += (at(b) - at(a)).cross(at(c) - at(a)).norm() / 2;
    if (d >= 0) sum += (at(c) - at(a)).cross(at(d) - at(a)).norm() / 2;
  }
  return sum;
}

std::string area_text(double m2) {
  return short_text(1e6 * m2, 6) + " mm2";
}

} // namespace plica
