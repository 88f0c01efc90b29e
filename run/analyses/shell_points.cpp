#include "run/analyses/shell_points.hpp"

#include "elements/shell_section.hpp"
#include "model/description/profile.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

class Places {
public:
  Places(const Case& data, const BuiltCase& built) : data_(data), mesh_(built.model.mesh) {
    ring_of_.assign(mesh_.nodes.size(), -1);
    place_of_ring_.assign(mesh_.rings.size(), -1);
    for (std::size_t r = 0; r < mesh_.rings.size(); ++r)
      for (const int node : mesh_.rings[r].nodes) ring_of_[std::size_t(node)] = int(r);
    for (const std::string& component : built.model.components)
      if (const Bellows* bellows = bellows_named(component)) add(component, *bellows);
  }

  std::vector<StressPlace> names;

  const Bellows* bellows_named(const std::string& name) const {
    for (const Part& part : data_.parts)
      if (part.name == name) return std::get_if<Bellows>(&part.body);
    return nullptr;
  }
  int ring_of(int node) const { return ring_of_[std::size_t(node)]; }
  int of(int node, const std::string& component) {
    if (const int ring = ring_of(node); ring >= 0 && place_of_ring_[std::size_t(ring)] >= 0)
      return place_of_ring_[std::size_t(ring)];
    return place(component, "");
  }

private:
  int place(const std::string& part, const std::string& name) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i].part == part && names[i].name == name) return int(i);
    names.push_back({part, name});
    return int(names.size()) - 1;
  }

  // Ring of a set "bellows.root[3]"; -1 = there is none.
  int ring_of_set(const std::string& part, const char* kind, int k) const {
    const auto set = mesh_.sets.find(part + "." + kind + "[" + std::to_string(k) + "]");
    return set == mesh_.sets.end() || set->second.empty() ? -1 : ring_of(set->second.front());
  }

  void name_rings(int from, int to, const std::string& part, const std::string& name) {
    if (from > to) return;
    const int own = place(part, name);
    for (int r = from; r <= to; ++r) place_of_ring_[std::size_t(r)] = own;
  }

  // Rings between a root and a crown, in any order, by half the height.
  void divide(const std::string& part, int root, const std::string& root_name, int crown,
              const std::string& crown_name) {
    const auto radius = [&](int r) { return mesh_.rings[std::size_t(r)].radius; };
    const double half = (radius(root) + radius(crown)) / 2;
    for (int r = std::min(root, crown); r <= std::max(root, crown); ++r)
      place_of_ring_[std::size_t(r)] = place(part, radius(r) < half ? root_name : crown_name);
  }

  void add(const std::string& part, const Bellows& bellows) {
    const auto all = mesh_.sets.find(part + ".all");
    if (all == mesh_.sets.end()) return;
    int first = ring_of(all->second.front()), last = first;
    for (const int node : all->second) {
      first = std::min(first, ring_of(node));
      last = std::max(last, ring_of(node));
    }
    const int count = convolutions(bellows);
    const auto numbered = [](const char* kind, int k) { return kind + std::to_string(k); };
    name_rings(first, count > 0 ? ring_of_set(part, "root", 1) - 1 : last, part, "left cuff");
    for (int k = 1; k <= count; ++k) {
      const int left = ring_of_set(part, "root", k), crown = ring_of_set(part, "crown", k),
                right = ring_of_set(part, "root", k + 1);
      if (left < 0 || crown < 0) continue;
      divide(part, left, numbered("root ", k), crown, numbered("crown ", k));
      if (right >= 0) divide(part, right, numbered("root ", k + 1), crown, numbered("crown ", k));
    }
    if (const int end = ring_of_set(part, "root", count + 1); count > 0 && end >= 0)
      name_rings(end + 1, last, part, "right cuff");
  }

  const Case& data_;
  const Mesh& mesh_;
  std::vector<int> ring_of_, place_of_ring_;
};

// Any direction in the wall, the same for neighbours: along y where that lies in it.
Vector3d along_wall(const Vector3d& normal) {
  Vector3d e = Vector3d::UnitY() - normal.y() * normal;
  if (e.norm() < 0.1) e = Vector3d::UnitX() - normal.x() * normal;
  return e.normalized();
}

std::vector<double> plies_of(const Wall& wall, const ShellSection& section) {
  const double slip = ply_bending_factor(wall.plies, 0);
  if (wall.plies.size() < 2 || std::abs(section.bending_factor - slip) > 1e-9 * slip) return {};
  std::vector<double> factors;
  for (const double t : wall.plies)
    factors.push_back(t / (total_thickness(wall) * std::sqrt(slip)));
  return factors;
}

} // namespace

ShellPoints shell_points(const Case& data, const BuiltCase& built, const StressField& field) {
  Places places(data, built);
  ShellPoints all;
  std::map<int, int> wall_of_section;
  for (std::size_t i = 0; i < field.node_of_point.size(); ++i) {
    const int section = field.section[i], node = field.node_of_point[i];
    const ShellProperties& shell = built.model.shells[std::size_t(section)];
    const std::string& component = built.model.components[std::size_t(shell.component)];
    const Bellows* bellows = places.bellows_named(component);
    const auto [wall, is_new] = wall_of_section.try_emplace(section, int(all.plies.size()));
    if (is_new)
      all.plies.push_back(bellows ? plies_of(bellows->wall, shell.section) : std::vector<double>{});
    StressPoint p{.node = node,
                  .place = places.of(node, component),
                  .revolved = bellows != nullptr,
                  .ring = places.ring_of(node),
                  .e1 = along_wall(field.director[i]),
                  .e2 = {},
                  .wall = wall->second};
    const Vector3d& x = built.model.mesh.nodes[std::size_t(node)];
    const Vector3d around = Vector3d::UnitY().cross(Vector3d(x.x(), 0, x.z()));
    if (p.revolved && around.norm() > 0) p.e1 = around.cross(field.director[i]).normalized();
    p.e2 = field.director[i].cross(p.e1).normalized();
    all.points.push_back(p);
  }
  all.places = std::move(places.names);
  return all;
}

MatrixXd plane_stress(const ShellPoints& points, const MatrixXd& shell) {
  MatrixXd plane(shell.rows() / 2, shell.cols());
  const auto row_of = [](const Vector3d& a, const Vector3d& b) {
    Eigen::Matrix<double, 1, 6> row;
    row << a.x() * b.x(), a.y() * b.y(), a.z() * b.z(), a.x() * b.y() + a.y() * b.x(),
        a.y() * b.z() + a.z() * b.y(), a.z() * b.x() + a.x() * b.z();
    return row;
  };
  const auto count = int(points.points.size());
#pragma omp parallel for schedule(static) if (count > 1000)
  for (int i = 0; i < count; ++i) {
    const StressPoint& p = points.points[std::size_t(i)];
    Eigen::Matrix<double, 3, 6> T;
    T << row_of(p.e1, p.e1), row_of(p.e2, p.e2), row_of(p.e1, p.e2);
    for (Index face : {0, 1})
      plane.middleRows<3>(6 * Index(i) + 3 * face) =
          T * shell.middleRows<6>(12 * Index(i) + 6 * face);
  }
  return plane;
}

void take_thickest_ply(const ShellPoints& points, MatrixXd& plane) {
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const std::vector<double>& plies = points.plies[std::size_t(points.points[i].wall)];
    if (plies.empty()) continue;
    const double factor = *std::max_element(plies.begin(), plies.end());
    if (std::abs(factor - 1) < 1e-12) continue;
    auto below = plane.middleRows<3>(6 * Index(i)), above = plane.middleRows<3>(6 * Index(i) + 3);
    const MatrixXd membrane = (below + above) / 2, bending = factor * (above - below) / 2;
    below = membrane - bending;
    above = membrane + bending;
  }
}

std::array<double, 2> principal(const Vector3d& s) {
  const double middle = (s[0] + s[1]) / 2, radius = std::hypot((s[0] - s[1]) / 2, s[2]);
  return {middle + radius, middle - radius};
}

double plane_von_mises(const Vector3d& s) {
  return std::sqrt(std::max(0., s[0] * s[0] + s[1] * s[1] - s[0] * s[1] + 3 * s[2] * s[2]));
}

double signed_von_mises(const Vector3d& s) {
  return s[0] + s[1] < 0 ? -plane_von_mises(s) : plane_von_mises(s);
}

} // namespace plica
