// Modes by slices of the spectrum: beside single vectors in the small models, and beside closed
// forms where eigenvalues are equal many times over.
#include "tests/small_models.hpp"

#include "solve/block_lanczos.hpp"
#include "solve/modes.hpp"
#include "solve/signed_cholesky.hpp"
#include "solve/spectrum_slices.hpp"
#include "solve/supernodes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void expect_orthonormal(const SparseMatrix& M, const MatrixXd& Phi, double within) {
  const MatrixXd gram = Phi.transpose() * symmetric_product(M, Phi);
  EXPECT_LT((gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), within);
}

class InSlices : public testing::TestWithParam<SmallModel> {};
INSTANTIATE_TEST_SUITE_P(Models, InSlices, testing::ValuesIn(small_models()),
                         [](const auto& p) { return p.param.name; });

// Slices so thin that pairs, rigid modes and modes as good as equal lie at their borders.
TEST_P(InSlices, the_same_pairs_are_found_as_by_single_vectors) {
  const System system = assemble(GetParam().make());
  const BaseFactor base = factor_below_spectrum(system.K, system.M);
  const int count = std::min(60, reachable_modes(system.M) / 2);
  const EigenPairs referee = lanczos(system.M, base.factor, base.sigma, {.count = count});
  ASSERT_TRUE(referee.converged) << referee.reason;
  for (int slice : {12, 17}) {
    const EigenPairs found = spectrum_slices(system.K, system.M, base.factor, base.sigma,
                                             {.count = count, .slice = slice});
    ASSERT_TRUE(found.converged) << found.reason;
    ASSERT_GE(found.values.size(), count);
    const double elastic = referee.values.maxCoeff();
    for (int i = 0; i < count; ++i)
      EXPECT_NEAR(found.values[i], referee.values[i],
                  1e-9 * std::max(referee.values[i] - base.sigma, 1e-3 * elastic))
          << i + 1 << ", slices of " << slice;
    expect_orthonormal(system.M, found.vectors, 1e-9);
  }
}

// `copies` chains of equal masses and springs between two walls, side by side: each eigenvalue
//   lambda_j = 4 sin^2(j pi / (2 (n + 1)))
// (Meirovitch, Fundamentals of Vibrations, 7.9) so many times.
struct Chains {
  SparseMatrix K, M;
  int masses, copies;
  double lambda(int i) const { // from 0
    return std::pow(2 * std::sin((i / copies + 1) * std::numbers::pi / (2. * (masses + 1))), 2);
  }
};

Chains chains(int masses, int copies) {
  std::vector<Eigen::Triplet<double>> k, m;
  for (int c = 0; c < copies; ++c)
    for (int i = 0; i < masses; ++i) {
      const int row = c * masses + i;
      k.emplace_back(row, row, 2);
      m.emplace_back(row, row, 1);
      if (i + 1 == masses) continue;
      k.emplace_back(row + 1, row, -1);
      m.emplace_back(row + 1, row, 0);
    }
  Chains chains{SparseMatrix(masses * copies, masses * copies),
                SparseMatrix(masses * copies, masses * copies), masses, copies};
  chains.K.setFromTriplets(k.begin(), k.end());
  chains.M.setFromTriplets(m.begin(), m.end());
  return chains;
}

TEST(SpectrumSlices, equal_eigenvalues_at_their_borders_are_all_found) {
  for (int copies : {1, 2, 3, 6}) {
    const Chains c = chains(600, copies);
    const BaseFactor base = factor_below_spectrum(c.K, c.M);
    const EigenPairs found =
        spectrum_slices(c.K, c.M, base.factor, base.sigma, {.count = 300, .slice = 40});
    ASSERT_TRUE(found.converged) << found.reason;
    for (int i = 0; i < 300; ++i)
      EXPECT_NEAR(found.values[i] / c.lambda(i), 1, 1e-9) << i + 1 << ", " << copies << " copies";
    expect_orthonormal(c.M, found.vectors, 1e-9);
  }
}

// As `plica run` asks for many modes: found by slices, all proved.
TEST(SpectrumSlices, hundreds_of_modes_are_proved_and_no_pair_is_cut) {
  const Chains c = chains(5200, 2);
  BaseFactor base = factor_below_spectrum(c.K, c.M);
  for (const ModesRequest& request :
       {ModesRequest{.count = 519}, ModesRequest{.band = {0, frequency(c.lambda(519) * 1.0001)}}}) {
    ASSERT_TRUE(base.factor.factorise(c.K).ok);
    const ModeSet modes = find_modes(c.K, c.M, request, base);
    ASSERT_TRUE(modes.proof.passed) << modes.proof.reason;
    ASSERT_EQ(modes.lambda.size(), 520);
    for (int i = 0; i < 520; ++i) EXPECT_NEAR(modes.lambda[i] / c.lambda(i), 1, 1e-9) << i + 1;
    EXPECT_EQ(modes.restarts, 0);
  }
}

TEST_P(InSlices, a_factor_that_is_not_definite_solves) {
  const System system = assemble(GetParam().make());
  BaseFactor base = factor_below_spectrum(system.K, system.M);
  const ModeSet modes = find_modes(system.K, system.M, {.count = 8}, base);
  const SparseMatrix A = shifted(system.K, system.M, modes.proof.sigma);
  const SignedCholesky factor(A, base.factor.order());
  ASSERT_TRUE(factor.keeps_digits(system.K));
  EXPECT_EQ(factor.negative_pivots(), modes.proof.inertia_count);
  const MatrixXd b = MatrixXd::Random(A.rows(), 35);
  EXPECT_LT((symmetric_product(A, factor.solve(b)) - b).norm(), 1e-6 * b.norm());
}

// Large enough to be parted among the cores.
TEST(SpectrumSlices, subtrees_of_supernodes_give_the_same_bits_on_any_number_of_threads) {
  const System system =
      assemble(small::held(small::plate(50, 50, 0.3), {"edge1", "edge2", "edge3", "edge4"}));
  const SparseFactor order(system.K);
  EXPECT_GT(supernodes(system.K, order.order()).subtrees.size(), 1);
  const double between = 1e-4 * system.K.diagonal().mean() / system.M.diagonal().mean();
  const SparseMatrix A = shifted(system.K, system.M, between);
  const MatrixXd b = MatrixXd::Random(A.rows(), 35);
  set_threads(1);
  const SignedCholesky one(A, order.order());
  ASSERT_TRUE(one.keeps_digits(system.K));
  const MatrixXd x = one.solve(b);
  set_threads(2);
  const SignedCholesky two(A, order.order());
  EXPECT_EQ(one.squares(), two.squares());
  EXPECT_EQ(x, two.solve(b));
  set_threads(0);
  EXPECT_EQ(one.negative_pivots(),
            count_below_ldlt(system.K, system.M, between).below.value_or(-1));
  EXPECT_GT(one.negative_pivots(), 0);
  EXPECT_LT((symmetric_product(A, x) - b).norm(), 1e-6 * b.norm());
}

} // namespace
} // namespace plica::test
