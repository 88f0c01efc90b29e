#include "solve/statics.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <stdexcept>

namespace plica {

using Eigen::MatrixXd;

std::vector<int> complement(int n, const std::vector<int>& removed) {
  std::vector<int> kept;
  auto next = removed.begin();
  for (int i = 0; i < n; ++i) {
    if (next != removed.end() && *next == i)
      ++next;
    else
      kept.push_back(i);
  }
  return kept;
}

MatrixXd condense(const SparseMatrix& K, const std::vector<int>& boundary,
                  const SparseFactor& inner) {
  const int n = static_cast<int>(K.rows()), b = static_cast<int>(boundary.size());
  const std::vector<int> kept = complement(n, boundary);
  MatrixXd unit = MatrixXd::Zero(n, b);
  for (int j = 0; j < b; ++j) unit(boundary[j], j) = 1;
  const MatrixXd columns = symmetric_product(K, unit);
  const MatrixXd K_ib = columns(kept, Eigen::all);
  const MatrixXd reduced = columns(boundary, Eigen::all) - K_ib.transpose() * inner.solve(K_ib);
  return (reduced + reduced.transpose()) / 2;
}

MatrixXd follow_boundary(const SparseMatrix& K, const std::vector<int>& boundary,
                         const SparseFactor& inner, const MatrixXd& u_b) {
  const std::vector<int> kept = complement(static_cast<int>(K.rows()), boundary);
  MatrixXd u = MatrixXd::Zero(K.rows(), u_b.cols());
  u(boundary, Eigen::all) = u_b;
  const MatrixXd pull = symmetric_product(K, u)(kept, Eigen::all);
  u(kept, Eigen::all) = -inner.solve(pull);
  return u;
}

EndStiffness end_stiffness(const Matrix66& K) {
  const Eigen::LLT<MatrixXd> cholesky{MatrixXd(K)};
  if (cholesky.info() != Eigen::Success)
    throw std::runtime_error("the end stiffness between the two caps is singular: the part does "
                             "not hold them together in all six directions");
  const MatrixXd free = cholesky.solve(MatrixXd::Identity(6, 6));
  const MatrixXd parallel = MatrixXd(K.topLeftCorner<3, 3>()).inverse();
  return {.axial = 1 / parallel(1, 1),
          .transverse_x = 1 / parallel(0, 0),
          .transverse_z = 1 / parallel(2, 2),
          .bending_x = 1 / free(3, 3),
          .bending_z = 1 / free(5, 5),
          .torsion = 1 / free(4, 4)};
}

} // namespace plica
