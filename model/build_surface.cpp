#include "model/build_surface.hpp"

#include "mesh/cad_mesh.hpp"
#include "mesh/surface_file.hpp"

#include <Eigen/Geometry>

#include <mutex>
#include <tuple>

namespace plica {
namespace {

using Eigen::Vector3d;

SurfaceQuads quads_of(const SurfacePart& part) {
  if (is_cad_file(part.file)) return mesh_cad(part.file, {.size = part.size, .turn = part.turn});
  const Surface surface = read_surface(part.file, part.unit.value(), part.weld);
  return remesh(surface.nodes, surface.triangles, part.size);
}

// Variants, error bars and diagnoses build a case many times.
SurfaceQuads quads_once(const SurfacePart& part) {
  using Key =
      std::tuple<std::string, double, double, double, double, std::filesystem::file_time_type>;
  static std::mutex mutex;
  static std::map<Key, SurfaceQuads> known;
  const Key key{part.file, part.unit.value_or(0),
                part.size, part.turn,
                part.weld, std::filesystem::last_write_time(part.file)};
  const std::lock_guard lock(mutex);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  return known.try_emplace(key, quads_of(part)).first->second;
}

} // namespace

Mesh surface_mesh(const SurfacePart& part) {
  Mesh mesh = shell_mesh(quads_once(part), part.thickness, part.given);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(part.rotate[2], Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(part.rotate[1], Vector3d::UnitY()) *
                                Eigen::AngleAxisd(part.rotate[0], Vector3d::UnitX()))
                                   .toRotationMatrix();
  const Vector3d move(part.move[0], part.move[1], part.move[2]);
  for (Vector3d& x : mesh.nodes) x = turn * x + move;
  for (ShellQuad& q : mesh.quads) q.directors = turn * q.directors;
  for (const SurfacePlace& place : part.places) {
    const Vector3d at(place.at[0], place.at[1], place.at[2]);
    std::vector<int>& set = mesh.sets[place.name];
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if ((mesh.nodes[i] - at).norm() <= place.within) set.push_back(int(i));
    if (set.empty())
      throw std::runtime_error("no node of the surface is within " +
                               std::to_string(1e3 * place.within) + " mm of its place " +
                               place.name);
  }
  return mesh;
}

} // namespace plica
