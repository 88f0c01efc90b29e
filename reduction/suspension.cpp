#include "reduction/suspension.hpp"

#include "solve/symmetric_pairs.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd Suspension::rigid_shares(const MatrixXd& q) const {
  const MatrixXd moved = rigid.transpose() * q;
  return moved.cwiseProduct(MatrixXd(rigid_mass.ldlt().solve(moved))).colwise().sum();
}

std::optional<ReducedModes> reduced_modes(const MatrixXd& K, const MatrixXd& M,
                                          const Suspension& suspension, Index most) {
  const MatrixXd shifted = suspension.shift == 0 ? K : MatrixXd(K + suspension.shift * M);
  const auto pairs = symmetric_pairs(M, shifted);
  if (!pairs) return std::nullopt;
  const VectorXd& theta = pairs->values; // 1 / (lambda + shift), increasing
  const Index n = theta.size();
  Index count = 0;
  constexpr double finite = 1e-12;
  while (count < std::min(n, most) && theta[n - 1 - count] > finite * theta[n - 1]) ++count;
  if (count == 0) return std::nullopt;
  ReducedModes modes;
  modes.lambda = theta.tail(count).reverse().cwiseInverse();
  modes.q =
      pairs->vectors.rightCols(count).rowwise().reverse() * modes.lambda.cwiseSqrt().asDiagonal();
  modes.lambda.array() -= suspension.shift;
  if (!suspension.leaves_rigid) return modes;
  constexpr double is_rigid = 0.5;
  const VectorXd shares = suspension.rigid_shares(modes.q);
  std::vector<Index> kept;
  for (Index i = 0; i < count; ++i)
    if (shares[i] < is_rigid) kept.push_back(i);
  if (kept.empty()) return std::nullopt;
  return ReducedModes{modes.lambda(kept), modes.q(Eigen::all, kept)};
}

} // namespace plica
