// Eigenpairs of dense pencils: a chain of masses in closed form, on either side of the size from
// which LAPACK answers.
#include "solve/symmetric_pairs.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// n springs and masses of unity between two walls.
MatrixXd chain(Index n) {
  MatrixXd K = 2 * MatrixXd::Identity(n, n);
  K.diagonal(1).setConstant(-1);
  K.diagonal(-1).setConstant(-1);
  return K;
}

// M x = theta K x: theta = 1 / (4 sin^2(j pi / (2 (n + 1)))), a textbook's (Meirovitch,
// Fundamentals of Vibrations, section 7).
TEST(SymmetricPairs, of_a_chain_are_those_of_the_closed_form) {
  for (const Index n : {5, 63, 64, 150}) {
    const MatrixXd K = chain(n);
    const auto pairs = symmetric_pairs(MatrixXd::Identity(n, n), K);
    ASSERT_TRUE(pairs) << n;
    for (Index j = 1; j <= n; ++j) {
      const double s = 2 * std::sin(double(j) * std::numbers::pi / (2 * double(n + 1)));
      EXPECT_NEAR(pairs->values[n - j] * s * s, 1, 1e-10) << n << ", " << j;
    }
    const MatrixXd& X = pairs->vectors;
    EXPECT_LT((X.transpose() * K * X - MatrixXd::Identity(n, n)).norm(), 1e-11) << n;
    EXPECT_LT((X - K * X * pairs->values.asDiagonal()).norm(), 1e-10 * X.norm()) << n;
  }
}

TEST(SymmetricPairs, massless_unknowns_are_zeros) {
  for (const Index n : {10, 80}) {
    MatrixXd M = MatrixXd::Identity(n, n);
    M.bottomRightCorner(n / 2, n / 2).setZero();
    const auto pairs = symmetric_pairs(M, chain(n));
    ASSERT_TRUE(pairs) << n;
    EXPECT_LT(pairs->values.head(n / 2).cwiseAbs().maxCoeff(), 1e-12 * pairs->values[n - 1]) << n;
    EXPECT_GT(pairs->values[n / 2], 1e-3) << n;
  }
}

TEST(SymmetricPairs, are_none_where_nothing_holds) {
  for (const Index n : {10, 80}) {
    MatrixXd K = chain(n);
    K(n / 2, n / 2) = -1;
    EXPECT_FALSE(symmetric_pairs(MatrixXd::Identity(n, n), K)) << n;
  }
}

} // namespace
} // namespace plica::test
