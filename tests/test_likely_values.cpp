// What is told of the draws of a posterior: intervals, and the place where they are densest.
#include "diagnose/weigh/fit_words.hpp"
#include "diagnose/weigh/interval.hpp"
#include "diagnose/weigh/likely_values.hpp"
#include "run/results/normal_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plica {
namespace {

using Eigen::VectorXd;

// Quantiles of what was drawn: equal tails, or up to the bound where the draws crowd.
TEST(Intervals, end_at_a_bound_where_the_draws_crowd) {
  HypothesisFit fit;
  constexpr int count = 1000;
  fit.draws.resize(1, count);
  for (int i = 0; i < count; ++i) fit.draws(0, i) = normal_quantile((i + 0.5) / count);
  const auto [low, high] = interval_of({&fit}, 0, {PriorKind::normal, 10, 2}).ends;
  EXPECT_NEAR(low, 10 - 2 * 1.645, 0.02);
  EXPECT_NEAR(high, 10 + 2 * 1.645, 0.02);
  // Exponential towards zero with mean 0.05, of a share between 0 and 1.
  for (int i = 0; i < count; ++i)
    fit.draws(0, i) = normal_quantile(-0.05 * std::log(1 - (i + 0.5) / count));
  const auto [none, most] = interval_of({&fit}, 0, {PriorKind::uniform, 0, 1}).ends;
  EXPECT_EQ(none, 0);
  EXPECT_NEAR(most, 0.05 * std::log(10.), 5e-3);
}

// A place and a size on a ridge: size = z_2, place = 0.5 + 0.02 (z_1 + lopsided tail of z_2). Most
// draws lie at 0.5, the optimum at the far end of the tail; a second, smaller heap lies elsewhere.
TEST(LikelyValues, are_where_the_draws_of_a_place_are_densest) {
  constexpr int count = 600, heap = 400, tail = 100;
  Hypothesis h{.effect = "extra_support",
               .place = "beam",
               .way = "z",
               .parameters = {{"k", "N/m", {PriorKind::normal, 0, 1}},
                              {"at", "m", {PriorKind::uniform, 0, 1}}},
               .along = {1}};
  HypothesisFit fit;
  fit.together = {&h};
  fit.solved = true;
  fit.values = Eigen::Vector2d(-3, 0.7);
  fit.z = Eigen::Vector2d(-3, normal_quantile(0.7));
  EXPECT_EQ(likely_values(fit, 0)[1], 0.7) << "without draws";
  fit.draws.resize(2, count);
  for (int i = 0; i < count; ++i) {
    const double share = i < heap          ? (i + 0.5) / heap
                         : i < heap + tail ? (i - heap + 0.5) / tail
                                           : (i - heap - tail + 0.5) / (count - heap - tail);
    const double at = i < heap          ? 0.5 + 0.01 * normal_quantile(share)
                      : i < heap + tail ? 0.5 + 0.2 * share
                                        : 0.1 + 0.01 * normal_quantile(share);
    fit.draws(1, i) = normal_quantile(at);
    fit.draws(0, i) = i < heap ? 2 + 0.1 * std::sin(i) : i < heap + tail ? 2 - 5 * share : -4;
  }
  const VectorXd likely = likely_values(fit, 0);
  EXPECT_NEAR(likely[1], 0.5, 0.005);
  EXPECT_NEAR(likely[0], 2, 0.1) << "the size that goes with the place";
  EXPECT_NE(name_of(fit).find("beam, 0.5"), std::string::npos) << name_of(fit);
}

// On a plate two numbers are one place: a heap of a fifth of the draws, narrow in both, and the
// rest spread along a band whose two numbers cross it, so that each of them alone is densest
// elsewhere.
TEST(LikelyValues, of_a_place_on_a_plate_are_densest_in_both_numbers_together) {
  constexpr int count = 1000, heap = 200;
  Hypothesis h{.effect = "added_mass",
               .place = "plate",
               .way = "",
               .parameters = {{"mass", "kg", {PriorKind::normal, 0, 1}},
                              {"at", "m", {PriorKind::uniform, 0, 1}},
                              {"across", "m", {PriorKind::uniform, 0, 0.1}}},
               .along = {1, 2}};
  HypothesisFit fit;
  fit.together = {&h};
  fit.solved = true;
  fit.values = Eigen::Vector3d(0, 0.5, 0.05);
  fit.z = Eigen::Vector3d::Zero();
  fit.draws.resize(3, count);
  for (int i = 0; i < count; ++i) {
    const bool in_heap = i < heap;
    const double share = in_heap ? (i + 0.5) / heap : (i - heap + 0.5) / (count - heap);
    const double turn = std::remainder(0.618034 * i, 1.); // an even second number
    const double at = in_heap ? 0.7 + 0.01 * normal_quantile(share) : 0.02 + 0.96 * share;
    const double across =
        in_heap ? 0.08 + 0.001 * normal_quantile(std::abs(turn) + 0.25) : 0.03 + 0.004 * turn;
    fit.draws.col(i) << (in_heap ? 1 : -1), normal_quantile(at), normal_quantile(across / 0.1);
  }
  const VectorXd likely = likely_values(fit, 0);
  EXPECT_NEAR(likely[1], 0.7, 0.01);
  EXPECT_NEAR(likely[2], 0.08, 0.001);
  EXPECT_NEAR(likely[0], 1, 1e-9) << "the mass that goes with the place";
  EXPECT_NE(name_of(fit).find("m across"), std::string::npos) << name_of(fit);
}

} // namespace
} // namespace plica
