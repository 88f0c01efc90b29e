#include "solve/statics.hpp"
#include "solve/model_error.hpp"

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

namespace {

// K x with sums in extended precision. The terms of a thin shell cancel to a billionth of their
// size, so that sums in double would leave a stiffness with nine digits.
MatrixXd force_of(const SparseMatrix& K, const MatrixXd& x) {
  using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  MatrixXd force(K.rows(), x.cols());
#pragma omp parallel for schedule(static)
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    Extended sum = Extended::Zero(K.rows());
    for (Eigen::Index j = 0; j < K.cols(); ++j)
      for (SparseMatrix::InnerIterator it(K, j); it; ++it) {
        const long double k = it.value();
        sum[it.row()] += k * x(j, c);
        if (it.row() != j) sum[j] += k * x(it.row(), c);
      }
    force.col(c) = sum.cast<double>();
  }
  return force;
}

} // namespace

MatrixXd follow_boundary(const SparseMatrix& K, const std::vector<int>& boundary,
                         const SparseFactor& inner, const MatrixXd& u_b) {
  constexpr int refinements = 2; // with exact residuals each gains six digits or more
  const std::vector<int> kept = complement(static_cast<int>(K.rows()), boundary);
  MatrixXd u = MatrixXd::Zero(K.rows(), u_b.cols());
  u(boundary, Eigen::all) = u_b;
  for (int step = 0; step <= refinements; ++step)
    u(kept, Eigen::all) -= inner.solve(force_of(K, u)(kept, Eigen::all));
  return u;
}

MatrixXd boundary_stiffness(const SparseMatrix& K, const std::vector<int>& boundary,
                            const MatrixXd& Psi) {
  const MatrixXd reaction = force_of(K, Psi)(boundary, Eigen::all);
  return (reaction + reaction.transpose()) / 2;
}

MatrixXd condense(const SparseMatrix& K, const std::vector<int>& boundary,
                  const SparseFactor& inner) {
  const auto size = static_cast<Eigen::Index>(boundary.size());
  return boundary_stiffness(K, boundary,
                            follow_boundary(K, boundary, inner, MatrixXd::Identity(size, size)));
}

EndStiffness end_stiffness(const Matrix66& K, bool loaded) {
  const Eigen::LLT<MatrixXd> cholesky{MatrixXd(K)};
  if (!loaded && cholesky.info() != Eigen::Success)
    throw ModelError("the end stiffness between the two caps is singular: the part does "
                     "not hold them together in all six directions");
  const MatrixXd free = MatrixXd(K).inverse();
  const MatrixXd parallel = MatrixXd(K.topLeftCorner<3, 3>()).inverse();
  return {.axial = 1 / parallel(1, 1),
          .transverse_x = 1 / parallel(0, 0),
          .transverse_z = 1 / parallel(2, 2),
          .bending_x = 1 / free(3, 3),
          .bending_z = 1 / free(5, 5),
          .torsion = 1 / free(4, 4)};
}

} // namespace plica
