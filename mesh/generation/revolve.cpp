#include "mesh/generation/revolve.hpp"

#include "mesh/machine_memory.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace plica {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d turned(const Vector2d& yr, double angle) {
  return {yr.y() * std::cos(angle), yr.x(), yr.y() * std::sin(angle)};
}

void add_ring(Mesh& mesh, const Vector2d& at, int around) {
  Ring ring{.y = at.x(), .radius = at.y(), .nodes = {}};
  for (int k = 0; k < around; ++k) {
    ring.nodes.push_back(static_cast<int>(mesh.nodes.size()));
    mesh.nodes.push_back(turned(at, 2 * std::numbers::pi * k / around));
  }
  mesh.rings.push_back(std::move(ring));
}

void add_belt(Mesh& mesh, const MeridianPoint& left, const MeridianPoint& right, int around,
              const std::function<double(double)>& thickness) {
  const std::vector<int>& a = mesh.rings[mesh.rings.size() - 2].nodes;
  const std::vector<int>& b = mesh.rings.back().nodes;
  const double t_left = thickness(left.position.y()), t_right = thickness(right.position.y());
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    const double angle = 2 * std::numbers::pi * k / around;
    const double angle_next = 2 * std::numbers::pi * next / around;
    ShellQuad quad;
    quad.nodes = {a[k], b[k], b[next], a[next]};
    quad.directors << turned(left.normal, angle), turned(right.normal, angle),
        turned(right.normal, angle_next), turned(left.normal, angle_next);
    quad.thickness << t_left, t_right, t_right, t_left;
    mesh.quads.push_back(quad);
  }
}

void put(Mesh& mesh, const std::string& set, std::size_t first_ring, std::size_t last_ring) {
  std::vector<int>& nodes = mesh.sets[set];
  for (std::size_t j = first_ring; j <= last_ring; ++j)
    nodes.insert(nodes.end(), mesh.rings[j].nodes.begin(), mesh.rings[j].nodes.end());
}

std::string numbered(const char* name, int k) {
  return std::string(name) + "[" + std::to_string(k) + "]";
}

void name_sets(Mesh& mesh, const Meridian& meridian, const std::vector<std::size_t>& ring_of_end) {
  const auto& curves = meridian.curves();
  std::size_t ring = 0;
  std::size_t convolution_start = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const int k = curves[i].convolution;
    if (curves[i].starts_at_root) {
      convolution_start = ring;
      put(mesh, numbered("root", k), ring, ring);
    }
    if (curves[i].ends_at_crown) put(mesh, numbered("crown", k), ring_of_end[i], ring_of_end[i]);
    if (curves[i].kind == CurveKind::spline) {
      std::size_t crown = ring;
      for (std::size_t j = ring; j <= ring_of_end[i]; ++j)
        if (mesh.rings[j].radius > mesh.rings[crown].radius) crown = j;
      put(mesh, numbered("crown", k), crown, crown);
    }
    const bool last_of_convolution =
        k > 0 && (i + 1 == curves.size() || curves[i + 1].convolution != k);
    if (last_of_convolution) {
      put(mesh, numbered("convolution", k), convolution_start, ring_of_end[i]);
      if (k == meridian.convolutions())
        put(mesh, numbered("root", k + 1), ring_of_end[i], ring_of_end[i]);
    }
    if (k == 0 && i == 0) put(mesh, "cuff.left", ring, ring_of_end[i]);
    if (k == 0 && i > 0 && i + 1 == curves.size()) put(mesh, "cuff.right", ring, ring_of_end[i]);
    ring = ring_of_end[i];
  }
  put(mesh, "left", 0, 0);
  put(mesh, "right", mesh.rings.size() - 1, mesh.rings.size() - 1);
  put(mesh, "all", 0, mesh.rings.size() - 1);
}

} // namespace

Mesh revolve(const Meridian& meridian, int around, const std::function<double(double)>& thickness) {
  const auto curves = mesh_meridian(meridian);
  double rings = 1;
  for (const std::vector<MeridianPoint>& curve : curves) rings += double(curve.size()) - 1;
  require_memory(leanest_bytes_per_node * rings * around,
                 "a mesh of " + std::to_string(long(rings)) + " rings of " +
                     std::to_string(around) + " nodes",
                 "A coarser mesh needs less.");
  Mesh mesh;
  std::vector<std::size_t> ring_of_end;
  for (const std::vector<MeridianPoint>& curve : curves) {
    if (mesh.rings.empty()) add_ring(mesh, curve.front().position, around);
    for (std::size_t i = 1; i < curve.size(); ++i) {
      add_ring(mesh, curve[i].position, around);
      add_belt(mesh, curve[i - 1], curve[i], around, thickness);
    }
    ring_of_end.push_back(mesh.rings.size() - 1);
  }
  name_sets(mesh, meridian, ring_of_end);
  return mesh;
}

} // namespace plica
