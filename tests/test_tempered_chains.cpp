// Markov chains against posteriors in closed form. Standard normal prior throughout.
#include "diagnose/weigh/ridge.hpp"
#include "diagnose/weigh/tempered_chains.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <omp.h>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int particles = 4000;

// Likelihood exp(-(z - at)^2 / (2 s^2)) in one dimension: evidence s / sqrt(1 + s^2)
// exp(-at^2 / (2 (1 + s^2))), posterior normal about at / (1 + s^2) with variance s^2 / (1 + s^2).
TEST(TemperedChains, of_a_gaussian_give_its_evidence_mean_and_variance) {
  constexpr double at = 2, s = 0.3, v = s * s / (1 + s * s);
  const auto likelihood = [&](const VectorXd& z) -> std::optional<double> {
    return -std::pow((z[0] - at) / s, 2) / 2;
  };
  const ChainDraws drawn =
      tempered_chains({{VectorXd::Constant(1, at / (1 + s * s)), MatrixXd::Constant(1, 1, v)}},
                      likelihood, particles, 1);
  ASSERT_TRUE(drawn.log_evidence);
  const double exact = std::log(s / std::sqrt(1 + s * s)) - at * at / (2 * (1 + s * s));
  EXPECT_NEAR(*drawn.log_evidence, exact, 0.05); // a few times 1 / sqrt(particles)
  EXPECT_NEAR(drawn.z.mean(), at / (1 + s * s), 4 * std::sqrt(v / particles) * 2);
  const double variance = (drawn.z.array() - drawn.z.mean()).square().mean();
  EXPECT_NEAR(variance, v, 0.15 * v);
}

// A sign that does not show: both halves are found from one of them, as a tenth of the chains
// begins anywhere in the prior. By quadrature the evidence is twice that of one half.
TEST(TemperedChains, find_an_optimum_that_they_were_not_told_of) {
  constexpr double at = 1, s = 0.2;
  const auto density = [&](double z) { return -std::pow((std::abs(z) - at) / s, 2) / 2; };
  double evidence = 0;
  constexpr double step = 1e-3;
  for (double z = -8; z < 8; z += step)
    evidence += step * std::exp(density(z) - z * z / 2) / std::sqrt(2 * std::numbers::pi);
  const ChainDraws drawn = tempered_chains(
      {{VectorXd::Constant(1, at), MatrixXd::Constant(1, 1, s * s)}},
      [&](const VectorXd& z) { return std::optional(density(z[0])); }, particles, 3);
  ASSERT_TRUE(drawn.log_evidence);
  EXPECT_NEAR(*drawn.log_evidence, std::log(evidence), 0.2);
  const double negative = (drawn.z.array() < 0).cast<double>().mean();
  EXPECT_GT(negative, 0.3);
  EXPECT_LT(negative, 0.7);
}

TEST(TemperedChains, keep_out_of_what_is_impossible) {
  const auto likelihood = [](const VectorXd& z) {
    return z[0] > 0 ? std::optional(0.) : std::nullopt;
  };
  const ChainDraws drawn = tempered_chains(
      {{VectorXd::Constant(1, 0.5), MatrixXd::Constant(1, 1, 0.25)}}, likelihood, particles, 5);
  ASSERT_TRUE(drawn.log_evidence);
  EXPECT_NEAR(*drawn.log_evidence, std::log(0.5), 0.05); // half of the prior
  EXPECT_GT(drawn.z.minCoeff(), 0);
}

TEST(TemperedChains, hang_on_the_seed_and_not_on_the_threads) {
  const auto likelihood = [](const VectorXd& z) { return std::optional(-z.squaredNorm()); };
  const std::vector<ChainStart> start{{VectorXd::Zero(3), MatrixXd::Identity(3, 3) / 3}};
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const ChainDraws alone = tempered_chains(start, likelihood, 100, 7);
  omp_set_num_threads(2);
  const ChainDraws together = tempered_chains(start, likelihood, 100, 7);
  const ChainDraws other = tempered_chains(start, likelihood, 100, 8);
  omp_set_num_threads(threads);
  EXPECT_EQ(alone.z, together.z);
  EXPECT_EQ(alone.log_evidence, together.log_evidence);
  EXPECT_NE(alone.z, other.z);
}

// A ridge z0 = -z1^2, a hundredth as wide as it is long, that ends where nothing can be beyond
// z1 = 1: chains that begin along it have the posterior of z1, by quadrature the standard normal
// one times exp(-z1^4 / 2), up to there.
TEST(Ridge, lets_chains_see_all_of_it) {
  constexpr double wide = 0.01, end = 1;
  const auto error = [&](const VectorXd& z) -> std::optional<double> {
    return z[1] > end ? std::nullopt : std::optional((z[0] + z[1] * z[1]) / wide);
  };
  const ResidualModel residuals = [&](const VectorXd& z) -> std::optional<VectorXd> {
    const auto e = error(z);
    return e ? std::optional(VectorXd(Eigen::Vector3d(*e, z[0], z[1]))) : std::nullopt;
  };
  const std::vector<ChainStart> ridge = ridge_from(residuals, VectorXd::Zero(2), 1);
  ASSERT_GT(ridge.size(), 10U);
  for (const ChainStart& start : ridge) {
    EXPECT_NEAR(start.optimum[0], -std::pow(start.optimum[1], 2), wide);
    EXPECT_LE(start.optimum[1], end);
  }
  const ChainDraws drawn = tempered_chains(
      ridge,
      [&](const VectorXd& z) -> std::optional<double> {
        const auto e = error(z);
        return e ? std::optional(-*e * *e / 2) : std::nullopt;
      },
      particles, 1);
  double all = 0, below = 0, square = 0;
  constexpr double step = 1e-3;
  for (double z = -8; z < end; z += step) {
    const double density = std::exp(-z * z / 2 - std::pow(z, 4) / 2);
    all += density;
    below += z < 0 ? density : 0;
    square += z * z * density;
  }
  EXPECT_NEAR((drawn.z.row(1).array() < 0).cast<double>().mean(), below / all, 0.05);
  EXPECT_NEAR(drawn.z.row(1).array().square().mean(), square / all, 0.1 * square / all);
}

} // namespace
} // namespace plica
