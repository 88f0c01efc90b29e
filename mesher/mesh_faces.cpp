#include "mesher/mesh_faces.hpp"

#include "mesh/generation/gmsh_session.hpp"
#include "mesher/meshed.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace plica {
namespace {

namespace cad = gmsh::model;
using Entities = gmsh::vectorpair;
using Eigen::Vector3d;

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

// Each side begins where another ends: no hole.
bool is_one_loop(const std::vector<int>& tags) {
  std::set<int> reached, left(tags.begin(), tags.end());
  for (bool grown = true; grown;) {
    grown = false;
    for (int curve : std::set<int>(left)) {
      Entities ends;
      cad::getBoundary({{1, curve}}, ends, false, false, false);
      const bool touches =
          reached.empty() || std::any_of(ends.begin(), ends.end(),
                                         [&](const auto& e) { return reached.contains(e.second); });
      if (!touches) continue;
      for (const auto& end : ends) reached.insert(end.second);
      left.erase(curve);
      grown = true;
    }
  }
  return left.empty();
}

// Faces of four different sides, without a hole and a curve inside.
std::set<int> mapped_faces() {
  const std::map<int, std::vector<int>> inside = curves_inside();
  std::set<int> mapped;
  for (const auto& face : faces_of_model())
    if (const std::vector<int> tags = sides(face);
        tags.size() == 4 && !has_seam(face) && !inside.contains(face.second) && is_one_loop(tags))
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

void import_cad(const CadFaces& part) {
  gmsh::clear();
  cad::add("cad");
  Entities shapes;
  cad::occ::importShapesNativePointer(part.shape.get(), shapes, false);
  cad::occ::synchronize();
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
void cut_seams(const CadFaces& part) {
  const Entities faces = faces_of_model();
  if (std::none_of(faces.begin(), faces.end(), has_seam)) {
    join_faces();
    return;
  }
  int best = -1;
  std::size_t least = not_mapped();
  for (int axis : {2, 0, 1}) {
    if (least == 0) break;
    import_cad(part);
    cut(axis);
    if (const std::size_t left = not_mapped(); left < least) {
      least = left;
      best = axis;
      if (left == 0) return;
    }
  }
  import_cad(part);
  if (best >= 0)
    cut(best);
  else
    join_faces();
}

// Elements that a curve needs by its length and its turn.
int elements_along(int curve, const SurfaceMeshing& meshing) {
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

void seed(const SurfaceMeshing& meshing) {
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

// Of the faces as they are meshed: cut, and joined where they touch.
double area_of_faces() {
  double sum = 0;
  for (const auto& [dimension, face] : faces_of_model()) {
    double own = 0;
    cad::occ::getMass(dimension, face, own);
    sum += own;
  }
  return sum;
}

// Chords across arcs of `turn` are short by its square over 24.
void require_area(const SurfaceFaces& surface, double turn) {
  const double right = area_of_faces(), made = area_of(surface);
  const double tolerance = 0.02 + 2 * turn * turn / 24;
  if (!(std::abs(made - right) <= tolerance * right))
    throw std::runtime_error("the mesh has an area of " + area_text(made) +
                             ", the faces of the file " + area_text(right) +
                             ": another element_size");
}

} // namespace

SurfaceFaces mesh_cad(const CadFaces& part, const SurfaceMeshing& meshing) {
  return in_gmsh([&] {
    import_cad(part);
    cut_seams(part);
    for (const auto& [face, curves] : curves_inside()) cad::mesh::embed(1, curves, 2, face);
    seed(meshing);
    mesh_faces();
    SurfaceFaces surface = collected();
    require_area(surface, meshing.turn);
    add_normals(surface);
    return in_order(surface);
  });
}

} // namespace plica
