#include "wall.hpp"

#include "solve/lanczos.hpp"

#include <Eigen/Dense>
#include <fstream>
#include <numeric>
#include <stdexcept>

namespace sealed {
namespace {

using plica::SparseMatrix;

void write(std::ostream& out, const MatrixXd& m) {
  const std::int64_t size[2] = {m.rows(), m.cols()};
  out.write(reinterpret_cast<const char*>(size), sizeof size);
  out.write(reinterpret_cast<const char*>(m.data()), std::streamsize(sizeof(double)) * m.size());
}

MatrixXd read(std::istream& in) {
  std::int64_t size[2] = {0, 0};
  in.read(reinterpret_cast<char*>(size), sizeof size);
  MatrixXd m(size[0], size[1]);
  in.read(reinterpret_cast<char*>(m.data()), std::streamsize(sizeof(double)) * m.size());
  return m;
}

// Columns whose span is kept: mass-orthonormal, without those that depend on the others.
MatrixXd orthonormal(const SparseMatrix& M, MatrixXd V) {
  for (int c = 0; c < V.cols(); ++c) V.col(c) /= V.col(c).norm();
  for (int pass = 0; pass < 2; ++pass) {
    const MatrixXd gram = V.transpose() * plica::symmetric_product(M, V);
    const VectorXd scale = gram.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        MatrixXd(scale.asDiagonal() * gram * scale.asDiagonal()));
    const auto kept = (eigen.eigenvalues().array() > 1e-9).count();
    V = V * (scale.asDiagonal() * eigen.eigenvectors().rightCols(kept) *
             eigen.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal());
  }
  return V;
}

} // namespace

ReducedWall reduce(const FullWall& wall, int modes) {
  const int n = int(wall.K.rows()), b = rigid_unknowns;
  std::vector<int> inner(n - b);
  std::iota(inner.begin(), inner.end(), b);
  const SparseMatrix K = plica::restrict_to(wall.K, inner), M = plica::restrict_to(wall.M, inner);
  plica::SparseFactor factor(K);
  if (const auto status = factor.factorise(K); !status.ok) throw std::runtime_error(status.reason);
  const auto pairs = plica::lanczos(M, factor, 0, {.count = modes});
  if (!pairs.converged) throw std::runtime_error(pairs.reason);

  MatrixXd unit = MatrixXd::Zero(n, b);
  unit.topRows(b).setIdentity();
  const MatrixXd load = -plica::symmetric_product(wall.K, unit).bottomRows(n - b);
  int count = modes;
  for (const auto& [name, rows] : wall.loaded) count += int(rows.rows());
  MatrixXd V(n - b, count);
  V.leftCols(modes) = pairs.vectors;
  int c = modes;
  for (const auto& [name, rows] : wall.loaded) {
    const MatrixXd force = MatrixXd(rows.transpose()).bottomRows(n - b);
    V.middleCols(c, force.cols()) = factor.solve(force);
    c += int(force.cols());
  }
  V = orthonormal(M, V);
  MatrixXd basis = MatrixXd::Zero(n, b + V.cols());
  basis.topLeftCorner(b, b).setIdentity();
  basis.bottomLeftCorner(n - b, b) = factor.solve(load);
  basis.bottomRightCorner(n - b, V.cols()) = V;

  ReducedWall reduced;
  reduced.K = basis.transpose() * plica::symmetric_product(wall.K, basis);
  reduced.M = basis.transpose() * plica::symmetric_product(wall.M, basis);
  for (const auto* rows : {&wall.loaded, &wall.read})
    for (const auto& [name, r] : *rows) reduced.places[name] = r * basis;
  for (const auto& [name, spacing] : wall.spacing)
    reduced.places[name + ".spacing"] = Eigen::RowVector2d(spacing[0], spacing[1]);
  for (int end = 0; end < 3; ++end)
    reduced.places[std::array{"left", "middle", "right"}[end]] =
        MatrixXd::Identity(b + V.cols(), b + V.cols()).middleRows(6 * end, 6);
  reduced.mass = wall.mass;
  return reduced;
}

ReducedWall cached_wall(const WallShape& shape, const WallSpecimen& s,
                        const std::filesystem::path& folder, const std::string& name) {
  const auto file = folder / (name + ".wall");
  ReducedWall wall;
  if (std::ifstream in(file, std::ios::binary); in) {
    wall.K = read(in);
    wall.M = read(in);
    wall.mass = read(in)(0, 0);
    for (std::string place; std::getline(in, place);) wall.places[place] = read(in);
    return wall;
  }
  wall =
      reduce(s.road == Road::calculix ? brick_wall(shape, s, folder / name) : shell_wall(shape, s));
  const auto part = folder / (name + ".part"); // complete or absent
  std::ofstream out(part, std::ios::binary);
  write(out, wall.K);
  write(out, wall.M);
  write(out, MatrixXd::Constant(1, 1, wall.mass));
  for (const auto& [place, rows] : wall.places) {
    out << place << '\n';
    write(out, rows);
  }
  out.close();
  std::filesystem::rename(part, file);
  return wall;
}

} // namespace sealed
