#include "model/shape/build_surface.hpp"

#include "mesh/generation/surface_mesher.hpp"
#include "words/short_text.hpp"
#include "words/units.hpp"

#include <Eigen/Geometry>

#include <mutex>
#include <tuple>

namespace plica {
namespace {

using Eigen::Vector3d;

// Variants, error bars and diagnoses build a case many times.
SurfaceFaces faces_once(const SurfacePart& part) {
  using Key =
      std::tuple<std::string, double, double, double, double, std::filesystem::file_time_type>;
  static std::mutex mutex;
  static std::map<Key, SurfaceFaces> known;
  const Key key{part.file, part.unit.value_or(0),
                part.size, part.turn,
                part.weld, std::filesystem::last_write_time(part.file)};
  const SurfaceMeshing meshing{
      .unit = part.unit.value_or(1), .size = part.size, .turn = part.turn, .weld = part.weld};
  const std::lock_guard lock(mutex);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  return known.try_emplace(key, mesh_surface_file(part.file, meshing)).first->second;
}

} // namespace

Mesh surface_mesh(const SurfacePart& part) {
  Mesh mesh = shell_mesh(faces_once(part), part.thickness, part.given);
  if (const double ratio = mesh_quality(mesh).min_jacobian; !(ratio > folded_ratio))
    throw std::runtime_error("a quad of the mesh is folded, or a triangle (Jacobian ratio " +
                             short_text(ratio) +
                             "); another element_size, or none: the triangles of the file");
  const Eigen::Matrix3d turn = turn_of(part.rotate);
  const Vector3d move(part.move[0], part.move[1], part.move[2]);
  for (Vector3d& x : mesh.nodes) x = turn * x + move;
  for (ShellQuad& q : mesh.quads) q.directors = turn * q.directors;
  for (ShellTriangle& t : mesh.triangles) t.directors = turn * t.directors;
  add_places(mesh, part.places);
  return mesh;
}

Eigen::Matrix3d turn_of(const Triple& rotate) {
  return (Eigen::AngleAxisd(rotate[2], Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rotate[1], Vector3d::UnitY()) *
          Eigen::AngleAxisd(rotate[0], Vector3d::UnitX()))
      .toRotationMatrix();
}

void add_places(Mesh& mesh, const std::vector<SurfacePlace>& places) {
  for (const SurfacePlace& place : places) {
    if (place.within == 0) continue; // a point of the wall: model/shape/wall_places.hpp
    const Vector3d at(place.at[0], place.at[1], place.at[2]);
    std::vector<int>& set = mesh.sets[place.name];
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if ((mesh.nodes[i] - at).norm() <= place.within) set.push_back(int(i));
    if (set.empty())
      throw std::runtime_error("no node is within " + millimetres(place.within) + " of the place " +
                               place.name + " at [" + millimetres(place.at[0]) + ", " +
                               millimetres(place.at[1]) + ", " + millimetres(place.at[2]) + "]");
  }
}

} // namespace plica
