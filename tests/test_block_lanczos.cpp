// Block Lanczos beside Spectra's, which shares with it the operator alone; and that the cores share
// a solve without changing it.
#include "tests/small_models.hpp"

#include "solve/block_lanczos.hpp"
#include "solve/modes.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

struct Factored {
  System system;
  BaseFactor base;
};

Factored factored(const SmallModel& small) {
  System system = assemble(small.make());
  BaseFactor base = factor_below_spectrum(system.K, system.M);
  return {std::move(system), std::move(base)};
}

class InBlocks : public testing::TestWithParam<SmallModel> {};
INSTANTIATE_TEST_SUITE_P(Models, InBlocks, testing::ValuesIn(small_models()),
                         [](const auto& p) { return p.param.name; });

// Of the shifted problem, so that rigid modes have a size to be held against.
TEST_P(InBlocks, the_same_pairs_are_found_as_by_single_vectors_from_any_start) {
  const Factored f = factored(GetParam());
  const double sigma = f.base.sigma;
  LanczosSettings settings{.count = std::min(12, reachable_modes(f.system.M))};
  const EigenPairs referee = lanczos(f.system.M, f.base.factor, sigma, settings);
  ASSERT_TRUE(referee.converged) << referee.reason;
  const int pairs = static_cast<int>(referee.values.size());
  for (settings.seed = 1; settings.seed <= 4; ++settings.seed) {
    const EigenPairs found = block_lanczos(f.system.M, f.base.factor, sigma, settings);
    ASSERT_TRUE(found.converged) << found.reason;
    ASSERT_EQ(found.values.size(), pairs);
    const double elastic = referee.values.maxCoeff() - sigma;
    for (int i = 0; i < pairs; ++i)
      EXPECT_NEAR(found.values[i], referee.values[i],
                  1e-9 * std::max(referee.values[i] - sigma, 1e-3 * elastic))
          << i + 1;
    const Eigen::MatrixXd gram =
        found.vectors.transpose() * symmetric_product(f.system.M, found.vectors);
    EXPECT_LT((gram - Eigen::MatrixXd::Identity(pairs, pairs)).cwiseAbs().maxCoeff(), 1e-10);
  }
}

// A basis far too narrow for forty modes: many restarts, and none is lost on the way.
TEST(BlockLanczos, a_narrow_basis_restarts_and_loses_nothing) {
  for (const SmallModel& small : small_models()) {
    if (small.name != "bellows_two" && small.name != "tube_clamped") continue;
    const Factored f = factored(small);
    constexpr int many = 40;
    const EigenPairs referee = lanczos(f.system.M, f.base.factor, 0, {.count = many});
    const EigenPairs narrow =
        block_lanczos(f.system.M, f.base.factor, 0, {.count = many, .subspace = 1});
    const EigenPairs wide = block_lanczos(f.system.M, f.base.factor, 0, {.count = many});
    ASSERT_TRUE(narrow.converged) << narrow.reason;
    EXPECT_GT(narrow.operations, wide.operations) << small.name << ": it did not restart";
    for (int i = 0; i < many; ++i)
      EXPECT_NEAR(narrow.values[i] / referee.values[i], 1, 1e-9) << small.name << ", " << i + 1;
  }
}

TEST(BlockLanczos, one_and_two_threads_find_the_same_bits) {
  for (const SmallModel& small : small_models()) {
    if (small.name != "bellows_two") continue;
    const Factored f = factored(small);
    set_threads(1);
    const EigenPairs one = block_lanczos(f.system.M, f.base.factor, 0, {.count = 12});
    set_threads(2);
    const EigenPairs two = block_lanczos(f.system.M, f.base.factor, 0, {.count = 12});
    set_threads(0);
    EXPECT_EQ(one.values, two.values);
    EXPECT_EQ(one.vectors, two.vectors);
  }
}

// Thirteen columns are two groups; each is a solve by itself.
TEST(SparseFactor, columns_in_groups_are_solved_as_columns_alone) {
  const Factored f = factored(small_models().front());
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(f.system.K.rows(), 13);
  const Eigen::MatrixXd x = f.base.factor.solve(b);
  const Eigen::MatrixXd lower = f.base.factor.solve_lower(b), upper = f.base.factor.solve_upper(b);
  for (int j = 0; j < 13; ++j) {
    const Eigen::VectorXd alone = f.base.factor.solve(b.col(j));
    EXPECT_LT((x.col(j) - alone).norm(), 1e-10 * alone.norm());
    Eigen::VectorXd y(b.rows());
    f.base.factor.solve_lower(b.col(j).eval().data(), y.data());
    EXPECT_LT((lower.col(j) - y).norm(), 1e-10 * y.norm());
    f.base.factor.solve_upper(b.col(j).eval().data(), y.data());
    EXPECT_LT((upper.col(j) - y).norm(), 1e-10 * y.norm());
  }
}

// On small models too, so that the road for four million unknowns is walked here.
class WideIndices : public testing::TestWithParam<SmallModel> {};
INSTANTIATE_TEST_SUITE_P(Models, WideIndices, testing::ValuesIn(small_models()),
                         [](const auto& p) { return p.param.name; });

TEST_P(WideIndices, give_the_numbers_of_narrow_ones) {
  const System system = assemble(GetParam().make());
  const SparseMatrix K = system.K + 1e5 * system.M;
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(K.rows(), 5);
  SparseFactor narrow(K), wide(K, Factorisation::cholesky, IndexWidth::wide);
  ASSERT_TRUE(narrow.factorise(K).ok && wide.factorise(K).ok);
  const Eigen::MatrixXd x = wide.solve(b);
  EXPECT_LT((symmetric_product(K, x) - b).norm(), 1e-6 * b.norm());
  EXPECT_LT((x - narrow.solve(b)).norm(), 1e-6 * x.norm());
  EXPECT_EQ(wide.factor_entries() > 0, narrow.factor_entries() > 0);
  Eigen::VectorXi rows = wide.order();
  std::sort(rows.begin(), rows.end());
  EXPECT_EQ(rows, Eigen::VectorXi::LinSpaced(int(K.rows()), 0, int(K.rows()) - 1));

  const double between = 1e3 * K.diagonal().minCoeff() / system.M.diagonal().maxCoeff();
  const SparseMatrix shifted = system.K - between * system.M;
  SparseFactor count(shifted, Factorisation::ldlt),
      wide_count(shifted, Factorisation::ldlt, IndexWidth::wide);
  ASSERT_TRUE(count.factorise(shifted).ok && wide_count.factorise(shifted).ok);
  EXPECT_EQ(wide_count.negative_pivots(), count.negative_pivots());
}

} // namespace
} // namespace plica::test
