#include "mesh/cad_mesh.hpp"

#include "mesh/gmsh.hpp"
#include "mesh/surface_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace plica {
namespace {

namespace cad = gmsh::model;
using Entities = gmsh::vectorpair;
using Eigen::Vector3d;

Entities faces_of_model() {
  Entities faces;
  cad::getEntities(faces, 2);
  return faces;
}

// Tags of the curves round a face, a seam twice.
std::vector<int> sides(const std::pair<int, int>& face) {
  Entities curves;
  cad::getBoundary({face}, curves, false, false, false);
  std::vector<int> tags;
  for (const auto& curve : curves) tags.push_back(std::abs(curve.second));
  return tags;
}

bool has_seam(const std::pair<int, int>& face) {
  const std::vector<int> tags = sides(face);
  return std::set<int>(tags.begin(), tags.end()).size() < tags.size();
}

// Curves inside a face, where another face stands on it.
std::map<int, std::vector<int>> curves_inside() {
  std::map<int, std::set<int>> around;
  for (const auto& face : faces_of_model()) {
    const std::vector<int> tags = sides(face);
    around[face.second].insert(tags.begin(), tags.end());
  }
  std::map<int, std::vector<int>> inside;
  Entities curves;
  cad::getEntities(curves, 1);
  for (const auto& curve : curves) {
    std::vector<int> faces, ends;
    cad::getAdjacencies(1, curve.second, faces, ends);
    for (int face : std::set<int>(faces.begin(), faces.end()))
      if (!around[face].contains(curve.second)) inside[face].push_back(curve.second);
  }
  return inside;
}

// Faces of four different sides and no curve inside.
std::set<int> mapped_faces() {
  const std::map<int, std::vector<int>> inside = curves_inside();
  std::set<int> mapped;
  for (const auto& face : faces_of_model())
    if (sides(face).size() == 4 && !has_seam(face) && !inside.contains(face.second))
      mapped.insert(face.second);
  return mapped;
}

struct Box {
  Vector3d low, high;
};
Box box_of_model() {
  Box b;
  cad::getBoundingBox(-1, -1, b.low.x(), b.low.y(), b.low.z(), b.high.x(), b.high.y(), b.high.z());
  return b;
}

// In metres. OpenCASCADE takes a unit for IGES only when it has read one before: the first reading
// is for nothing.
Entities shapes_of(const std::filesystem::path& file) {
  const std::string suffix = lower_suffix(file);
  Entities shapes;
  if (suffix == ".iges" || suffix == ".igs") {
    gmsh::option::setString("Geometry.OCCTargetUnit", "");
    cad::occ::importShapes(file.string(), shapes, false);
    gmsh::clear();
    cad::add("cad");
    shapes.clear();
  }
  gmsh::option::setString("Geometry.OCCTargetUnit", has_unit(file) ? "M" : "");
  cad::occ::importShapes(file.string(), shapes, false);
  return shapes;
}

void import_cad(const std::filesystem::path& file, double unit) {
  gmsh::clear();
  cad::add("cad");
  try {
    Entities shapes = shapes_of(file);
    std::erase_if(shapes, [](const auto& shape) { return shape.first != 2; }); // edges follow
    if (!has_unit(file)) cad::occ::dilate(shapes, 0, 0, 0, unit, unit, unit);
  } catch (...) {
    throw std::runtime_error("Gmsh cannot read " + file.filename().string() +
                             " as STEP, IGES or BREP");
  }
  cad::occ::synchronize();
  Entities solids;
  cad::getEntities(solids, 3);
  if (!solids.empty())
    throw std::runtime_error(file.filename().string() + " holds " + std::to_string(solids.size()) +
                             " solids; a shell is meshed on faces: export the middle or outer "
                             "surface alone");
  if (faces_of_model().empty())
    throw std::runtime_error(file.filename().string() + " holds no face");
}

// Cuts all faces by the plane through the middle of the part with this normal.
void cut(int axis) {
  const Box box = box_of_model();
  const Vector3d middle = (box.low + box.high) / 2;
  const double size = 2 * (box.high - box.low).norm();
  const int plane = cad::occ::addRectangle(-size / 2, -size / 2, 0, size, size);
  if (axis == 0) cad::occ::rotate({{2, plane}}, 0, 0, 0, 0, 1, 0, std::numbers::pi / 2);
  if (axis == 1) cad::occ::rotate({{2, plane}}, 0, 0, 0, 1, 0, 0, std::numbers::pi / 2);
  cad::occ::translate({{2, plane}}, middle.x(), middle.y(), middle.z());
  const Entities faces = faces_of_model();
  Entities pieces;
  std::vector<Entities> of;
  Entities own;
  for (const auto& face : faces)
    if (face.second != plane) own.push_back(face);
  cad::occ::fragment(own, {{2, plane}}, pieces, of);
  std::set<int> kept;
  for (std::size_t i = 0; i < own.size(); ++i)
    for (const auto& piece : of[i]) kept.insert(piece.second);
  Entities rest;
  for (const auto& piece : of.back())
    if (!kept.contains(piece.second)) rest.push_back(piece);
  cad::occ::remove(rest, true);
  cad::occ::synchronize();
}

// Faces that cannot be mapped; those with a seam count twice.
std::size_t not_mapped() {
  const Entities faces = faces_of_model();
  return faces.size() - mapped_faces().size() +
         std::size_t(std::count_if(faces.begin(), faces.end(), has_seam));
}

// Faces that touch share their edges.
void join_faces() {
  const Entities faces = faces_of_model();
  if (faces.size() < 2) return;
  Entities pieces;
  std::vector<Entities> of;
  cad::occ::fragment(faces, {}, pieces, of);
  cad::occ::synchronize();
}

// Cut where faces close on themselves, by the plane that leaves the fewest that cannot be mapped.
void cut_seams(const std::filesystem::path& file, double unit) {
  const Entities faces = faces_of_model();
  if (std::none_of(faces.begin(), faces.end(), has_seam)) {
    join_faces();
    return;
  }
  int best = -1;
  std::size_t least = not_mapped();
  for (int axis : {2, 0, 1}) {
    if (least == 0) break;
    import_cad(file, unit);
    cut(axis);
    if (const std::size_t left = not_mapped(); left < least) {
      least = left;
      best = axis;
      if (left == 0) return;
    }
  }
  import_cad(file, unit);
  if (best >= 0)
    cut(best);
  else
    join_faces();
}

// Elements that a curve needs by its length and its turn.
int elements_along(int curve, const CadMeshing& meshing) {
  std::vector<double> low, high, at, points, slopes;
  cad::getParametrizationBounds(1, curve, low, high);
  constexpr int steps = 64;
  for (int i = 0; i <= steps; ++i) at.push_back(low[0] + (high[0] - low[0]) * i / steps);
  cad::getValue(1, curve, at, points);
  cad::getDerivative(1, curve, at, slopes);
  double length = 0, turn = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const auto vector = [&](const std::vector<double>& x, std::size_t k) {
      return Vector3d(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
    };
    length += (vector(points, i + 1) - vector(points, i)).norm();
    const Vector3d a = vector(slopes, i).normalized(), b = vector(slopes, i + 1).normalized();
    turn += std::acos(std::clamp(a.dot(b), -1., 1.));
  }
  constexpr double rounding = 1e-6;
  return std::max({1, int(std::ceil(length / meshing.size - rounding)),
                   int(std::ceil(turn / meshing.turn - rounding))});
}

// Curves that need as many elements as others: opposite sides of mapped faces.
class Alike {
public:
  int of(int curve) {
    int& up = parent_.try_emplace(curve, curve).first->second;
    return up == curve ? curve : up = of(up);
  }
  void join(int a, int b) { parent_[of(a)] = of(b); }

private:
  std::map<int, int> parent_;
};

constexpr int most_along = 5000; // elements on a curve

void seed(const CadMeshing& meshing) {
  const std::set<int> mapped = mapped_faces();
  Alike alike;
  for (const auto& face : faces_of_model()) {
    if (!mapped.contains(face.second)) continue;
    const std::vector<int> tags = sides(face);
    alike.join(tags[0], tags[2]);
    alike.join(tags[1], tags[3]);
  }
  Entities curves;
  cad::getEntities(curves, 1);
  // Where faces are filled, all are split in four at the end: half as many before.
  const bool split = mapped.size() < faces_of_model().size();
  std::map<int, int> count;
  for (const auto& [dimension, curve] : curves) {
    int& n = count[alike.of(curve)];
    n = std::max(n, elements_along(curve, meshing));
  }
  for (const auto& [dimension, curve] : curves) {
    const int n = count[alike.of(curve)];
    if (n > most_along)
      throw std::runtime_error("an edge would need " + std::to_string(n) +
                               " elements: is the element size meant for lengths in metres?");
    cad::mesh::setTransfiniteCurve(curve, (split ? (n + 1) / 2 : n) + 1);
  }
  for (const auto& [dimension, face] : faces_of_model()) {
    if (mapped.contains(face)) cad::mesh::setTransfiniteSurface(face);
    cad::mesh::setRecombine(2, face);
  }
  const double size = split ? 2 * meshing.size : meshing.size;
  gmsh::option::setNumber("Mesh.CharacteristicLengthMax", size);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", split ? 1 : 0);
}

// Quads of all faces, their nodes numbered from 0.
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

// Where its parametrisation fails Gmsh puts nodes anywhere.
void check_near(const std::vector<Vector3d>& made, const std::vector<Vector3d>& given,
                double size) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& x : given) box.extend(x);
  for (const Vector3d& x : made)
    if (!(box.exteriorDistance(x) <= size))
      throw std::runtime_error(
          "Gmsh put a node off the surface; another element_size, or none: the "
          "triangles of the file");
}

// Exact normals of CAD faces at the corners of their quads.
void add_normals(SurfaceFaces& surface) {
  std::size_t q = 0;
  surface.normals.resize(surface.faces.size());
  for (const auto& face : faces_of_model()) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, ignored;
    cad::mesh::getElements(types, elements, ignored, 2, face.second);
    std::size_t own = 0;
    for (const auto& e : elements) own += e.size();
    std::vector<double> x, parameters, normals;
    for (std::size_t i = q; i < q + own; ++i)
      for (int node : surface.faces[i]) {
        const Vector3d& p = surface.nodes[std::size_t(node)];
        x.insert(x.end(), {p.x(), p.y(), p.z()});
      }
    cad::getParametrization(2, face.second, x, parameters);
    cad::getNormal(face.second, parameters, normals);
    for (std::size_t i = 0; i < own; ++i)
      for (std::size_t c = 0; c < 4; ++c) {
        const double* n = &normals[3 * (4 * i + c)];
        surface.normals[q + i][c] = Vector3d(n[0], n[1], n[2]).normalized();
      }
    q += own;
  }
}

} // namespace

bool has_unit(const std::filesystem::path& cad_file) {
  return lower_suffix(cad_file) != ".brep";
}

bool is_cad_file(const std::filesystem::path& file) {
  const std::string suffix = lower_suffix(file);
  return suffix == ".step" || suffix == ".stp" || suffix == ".iges" || suffix == ".igs" ||
         suffix == ".brep";
}

SurfaceFaces mesh_cad(const std::filesystem::path& file, const CadMeshing& meshing) {
  return in_gmsh([&] {
    import_cad(file, meshing.unit);
    cut_seams(file, meshing.unit);
    for (const auto& [face, curves] : curves_inside()) cad::mesh::embed(1, curves, 2, face);
    seed(meshing);
    cad::mesh::generate(2);
    SurfaceFaces surface = collected();
    add_normals(surface);
    return surface;
  });
}

SurfaceFaces remesh(const std::vector<Vector3d>& nodes,
                    const std::vector<std::array<int, 3>>& triangles, double size) {
  return in_gmsh([&] {
    constexpr int triangle = 2;
    std::vector<std::size_t> tags(nodes.size()), corners;
    std::iota(tags.begin(), tags.end(), 1);
    std::vector<double> x;
    for (const Vector3d& p : nodes) x.insert(x.end(), {p.x(), p.y(), p.z()});
    for (const auto& t : triangles)
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
    cad::mesh::generate(2);
    SurfaceFaces surface = collected();
    check_near(surface.nodes, nodes, size);
    return surface;
  });
}

} // namespace plica
