#include "io/decks/deck_pressure.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace plica {
namespace {

using Eigen::Vector3d;

// Load per area times dA, from da, the vector of an element of area.
Vector3d load_on(const Vector3d& da, double p, const Vector3d& along) {
  return along.isZero(0) ? Vector3d(p * da) : Vector3d(p * da.norm() * along);
}

} // namespace

void add_pressure(std::vector<DeckForce>& forces, const std::vector<Vector3d>& places,
                  const std::vector<int>& nodes, const std::vector<double>& pressure,
                  const Vector3d& along) {
  const auto x = [&](std::size_t i) { return places[std::size_t(nodes[i])]; };
  std::vector<Vector3d> sum(nodes.size(), Vector3d(0, 0, 0));
  if (nodes.size() == 3) {
    const Vector3d da = (x(1) - x(0)).cross(x(2) - x(0)) / 2;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        sum[a] += load_on(da, pressure[b], along) * (a == b ? 2 : 1) / 12;
  } else {
    const double g = 1 / std::sqrt(3.);
    constexpr double r[4] = {-1, 1, 1, -1}, s[4] = {-1, -1, 1, 1};
    for (std::size_t point = 0; point < 4; ++point) {
      const double xi = g * r[point], eta = g * s[point];
      Vector3d xr(0, 0, 0), xs(0, 0, 0);
      double p = 0, N[4];
      for (std::size_t a = 0; a < 4; ++a) {
        N[a] = (1 + r[a] * xi) * (1 + s[a] * eta) / 4;
        xr += r[a] * (1 + s[a] * eta) / 4 * x(a);
        xs += s[a] * (1 + r[a] * xi) / 4 * x(a);
        p += N[a] * pressure[a];
      }
      for (std::size_t a = 0; a < 4; ++a) sum[a] += N[a] * load_on(xr.cross(xs), p, along);
    }
  }
  for (std::size_t a = 0; a < nodes.size(); ++a)
    forces.push_back({.node = nodes[a], .force = sum[a]});
}

} // namespace plica
