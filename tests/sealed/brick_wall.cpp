#include "brick_mesh.hpp"
#include "places.hpp"

#include <numbers>

namespace sealed {
namespace {

// What each displacement is of the free unknowns: rigid columns follow their body.
std::vector<Terms> follow(const WallShape& shape, const BrickMesh& mesh, int& unknowns) {
  const auto body_of = [&](int i) { // the ends, and the middle root
    if (i == 0) return 0;
    if (i == mesh.along - 1) return 2;
    return 2 * i == mesh.along - 1 ? 1 : -1;
  };
  const std::array centre{0., shape.length() / 2, shape.length()};
  std::vector<int> body(mesh.nodes.size(), -1);
  for (int i = 0; i < mesh.along; ++i)
    for (int j = 0; j < mesh.around; ++j)
      for (const int node : mesh.column(i, j))
        if (node >= 0) body[std::size_t(node)] = body_of(i);
  std::vector<Terms> terms;
  unknowns = rigid_unknowns;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const int b = body[n];
    const Eigen::Vector3d d =
        b < 0 ? Eigen::Vector3d::Zero()
              : Eigen::Vector3d(mesh.nodes[n] - centre[std::size_t(b)] * Eigen::Vector3d::UnitY());
    for (int a = 0; a < 3; ++a) {
      if (b < 0) {
        terms.push_back({{unknowns++, 1.}});
        continue;
      }
      const int u = (a + 1) % 3, v = (a + 2) % 3; // u_a + theta_u d_v - theta_v d_u
      terms.push_back({{6 * b + a, 1.}, {6 * b + 3 + u, d[v]}, {6 * b + 3 + v, -d[u]}});
    }
  }
  return terms;
}

plica::SparseMatrix eliminate(const std::vector<Eigen::Triplet<double>>& entries,
                              const std::vector<Terms>& terms, int unknowns) {
  std::vector<Eigen::Triplet<double>> lower;
  lower.reserve(entries.size());
  for (const auto& e : entries)
    for (const auto& [p, f] : terms[std::size_t(e.row())])
      for (const auto& [q, g] : terms[std::size_t(e.col())]) {
        const double value = f * g * e.value();
        if (e.row() == e.col()) {
          if (p >= q) lower.emplace_back(p, q, value); // each pair comes twice
          continue;
        }
        lower.emplace_back(std::max(p, q), std::min(p, q), p == q ? 2 * value : value);
      }
  plica::SparseMatrix m(unknowns, unknowns);
  m.setFromTriplets(lower.begin(), lower.end());
  return m;
}

Circle circle(const BrickMesh& mesh, int i) {
  Circle c;
  for (int j = 0; j < mesh.around; j += 2) { // spots with nodes at the corners of bricks
    const auto& column = mesh.column(i, j);
    c.x.push_back((mesh.nodes[std::size_t(column[0])] + mesh.nodes[std::size_t(column[1])]) / 2);
    c.nodes.push_back(i * mesh.around + j);
  }
  return c;
}

// Nearest spot of the meridian whose outline is highest (crown) or lowest (root) at that y.
int spot_at(const BrickMesh& mesh, double y, bool crown) {
  int best = 0;
  double error = 1;
  for (int i = 0; i < mesh.along; ++i) {
    const auto& at = mesh.meridian[std::size_t(i)].at;
    const double off = std::abs(at.x() - y) + (crown ? -1 : 1) * 1e-3 * at.y();
    if (off < error) {
      error = off;
      best = i;
    }
  }
  return best;
}

} // namespace

FullWall brick_wall(const WallShape& shape, const WallSpecimen& s,
                    const std::filesystem::path& folder) {
  const BrickMesh mesh = brick_mesh(shape, s);
  const BrickMatrices matrices = calculix_matrices(shape, s, mesh, folder);
  int unknowns = 0;
  const std::vector<Terms> terms = follow(shape, mesh, unknowns);
  FullWall wall;
  wall.K = eliminate(matrices.K, terms, unknowns);
  wall.M = eliminate(matrices.M, terms, unknowns);
  WallSpots spots;
  for (int k = 1; k <= shape.convolutions; ++k)
    spots.crowns[k] = circle(mesh, spot_at(mesh, shape.crown(k), true));
  for (const int k : {3, 7}) spots.roots[k] = circle(mesh, spot_at(mesh, shape.root(k), false));
  for (int a = 0; a < 3; ++a) { // circles of corner spots
    spots.mid[std::size_t(a)] = circle(mesh, spot_at(mesh, shape.crown(4), true) + 2 * (a - 1));
    spots.quarter[std::size_t(a)] = circle(mesh, spot_at(mesh, shape.crown(2), true) + 2 * (a - 1));
  }
  const Displacement middle = [&](int column, int axis) { // mean of both faces
    Terms sum;
    for (const int face : {0, 1})
      for (const auto& [unknown, factor] :
           terms[std::size_t(3 * mesh.columns[std::size_t(column)][std::size_t(face)] + axis)])
        sum.emplace_back(unknown, factor / 2);
    return sum;
  };
  add_places(wall, spots, middle, unknowns);
  VectorXd along = VectorXd::Zero(unknowns);
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (i % 3 == 1) // motion along y as a rigid body
      for (const auto& [unknown, factor] : terms[i])
        if (unknown % 6 < 3 || unknown >= rigid_unknowns) along[unknown] = 1;
  wall.mass = along.dot(plica::symmetric_product(wall.M, along).col(0));
  return wall;
}

} // namespace sealed
