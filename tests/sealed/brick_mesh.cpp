#include "brick_mesh.hpp"

#include <cmath>
#include <numbers>

namespace sealed {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

// Adds the 2 n spots after the first of a stretch.
void add_line(std::vector<MeridianSpot>& spots, const Vector2d& end, int n) {
  const Vector2d start = spots.back().at, along = (end - start).normalized();
  for (int i = 1; i <= 2 * n; ++i)
    spots.push_back({start + (end - start) * i / (2 * n), {-along.y(), along.x()}});
}

// A quarter round `centre`; `sign` +1 where the normal points away from it.
void add_quarter(std::vector<MeridianSpot>& spots, const Vector2d& centre, double from, double to,
                 double sign, int n) {
  const double radius = (spots.back().at - centre).norm();
  for (int i = 1; i <= 2 * n; ++i) {
    const double a = from + (to - from) * i / (2 * n);
    const Vector2d out(std::cos(a), std::sin(a));
    spots.push_back({centre + radius * out, sign * out});
  }
}

} // namespace

std::vector<MeridianSpot> meridian_spots(const WallShape& w, int arc, int flat, int cuff) {
  std::vector<MeridianSpot> spots{{{0, w.root_radius}, {0, 1}}};
  add_line(spots, {w.cuff, w.root_radius}, cuff);
  const double a = w.pitch / 4, low = w.root_radius + a, high = w.root_radius + w.height - a;
  for (int k = 1; k <= w.convolutions; ++k) {
    const double y = w.root(k), crown = w.crown(k);
    add_quarter(spots, {y, low}, -pi / 2, 0, -1, arc);
    add_line(spots, {y + a, high}, flat);
    add_quarter(spots, {crown, high}, pi, pi / 2, 1, arc);
    add_quarter(spots, {crown, high}, pi / 2, 0, 1, arc);
    add_line(spots, {crown + a, low}, flat);
    add_quarter(spots, {y + w.pitch, low}, pi, 3 * pi / 2, -1, arc);
  }
  add_line(spots, {w.length(), w.root_radius}, cuff);
  return spots;
}

BrickMesh brick_mesh(const WallShape& shape, const WallSpecimen& s) {
  BrickMesh mesh;
  mesh.meridian = meridian_spots(shape, 1 + s.refine, 1 + s.refine, 1 + s.refine);
  mesh.along = int(mesh.meridian.size());
  mesh.around = 2 * (12 + 8 * s.refine);
  const double thinner = std::sqrt(bending_factor(s.bond));
  for (int i = 0; i < mesh.along; ++i)
    for (int j = 0; j < mesh.around; ++j) {
      std::array<int, 3> column{-1, -1, -1};
      const MeridianSpot& spot = mesh.meridian[std::size_t(i)];
      const double half = thinner * thickness_at(shape, s, spot.at.y()) / 2,
                   angle = 2 * pi * j / mesh.around;
      const auto add = [&](double out) {
        const Vector2d p = spot.at + out * spot.normal;
        mesh.nodes.emplace_back(p.y() * std::cos(angle), p.x(), p.y() * std::sin(angle));
        return int(mesh.nodes.size()) - 1;
      };
      if (i % 2 == 0 || j % 2 == 0) column = {add(-half), add(half), -1};
      if (i % 2 == 0 && j % 2 == 0) column[2] = add(0);
      mesh.columns.push_back(column);
    }
  for (int i = 0; i + 2 < mesh.along; i += 2)
    for (int j = 0; j < mesh.around; j += 2) {
      const int next = (j + 2) % mesh.around;
      const std::array corners{mesh.column(i, j), mesh.column(i + 2, j), mesh.column(i + 2, next),
                               mesh.column(i, next)};
      const std::array middles{mesh.column(i + 1, j), mesh.column(i + 2, j + 1),
                               mesh.column(i + 1, next), mesh.column(i, j + 1)};
      std::array<int, 20> brick{};
      for (std::size_t c = 0; c < 4; ++c) {
        brick[c] = corners[c][0];
        brick[4 + c] = corners[c][1];
        brick[8 + c] = middles[c][0];
        brick[12 + c] = middles[c][1];
        brick[16 + c] = corners[c][2];
      }
      mesh.bricks.push_back(brick);
      mesh.factor.push_back(stiffness_factor(shape, s, mesh.meridian[std::size_t(i + 1)].at.x(),
                                             2 * pi * (j + 1) / mesh.around));
    }
  return mesh;
}

} // namespace sealed
