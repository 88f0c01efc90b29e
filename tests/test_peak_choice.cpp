// Which modes of a model are the peaks of a measured channel.
#include "diagnose/predict/peak_choice.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Peaks = std::vector<Index>;

constexpr std::array<double, 2> no_band{0, 0};

TEST(PeakChoice, pairs_by_the_least_sum_of_logarithms_not_each_with_its_nearest) {
  // 100 is nearest to 105, but then 110 would have to take 150: 0.05 + 0.31 against 0.22 + 0.05.
  EXPECT_EQ(paired({100, 110}, {80, 105, 150}, false), (Peaks{0, 1}));
}

TEST(PeakChoice, keeps_the_order_and_takes_each_peak_once) {
  EXPECT_EQ(paired({100, 101}, {100, 200, 300}, false), (Peaks{0, 1}));
}

TEST(PeakChoice, takes_the_first_ones_when_the_test_says_so) {
  EXPECT_EQ(paired({300}, {100, 290, 310}, true), (Peaks{0}));
  EXPECT_EQ(paired({300}, {100, 290, 310}, false), (Peaks{2}));
}

TEST(PeakChoice, repeats_the_last_where_the_model_has_too_few_and_minus_one_where_none) {
  EXPECT_EQ(paired({100, 200, 300}, {110, 190}, false), (Peaks{0, 1, 1}));
  EXPECT_EQ(paired({100, 200}, {}, false), (Peaks{-1, -1}));
}

// Plies that slip made the second mode of a mounted bellows weaker than a share of the first: its
// peak jumped by a quarter to the next mode, and slip was stopped there or given a mass besides.
TEST(PeakChoice, takes_a_weak_mode_where_the_strong_one_is_far) {
  const VectorXd height{{1, 0.06, 0.3}};
  const std::vector<Index> modes{0, 1, 2};
  const std::vector<double> cost = handicaps(height, modes, 0.12);
  EXPECT_NEAR(cost[1], 0.1 * std::log(2), 1e-12);
  EXPECT_EQ(cost[0] + cost[2], 0);
  EXPECT_EQ(paired({108, 142}, {109, 144, 187}, false, cost), (Peaks{0, 1}));
  EXPECT_EQ(paired({108, 142}, {109, 144, 150}, false, cost), (Peaks{0, 2}));
}

// 0.02 in ln f for each mode between two that are paired: 130 would rather be 131 than 128.8, but
// the latter is the next one. None before the first nor after the last.
TEST(PeakChoice, passes_over_a_mode_between_two_at_a_cost) {
  const std::vector<double> test{100, 130}, model{60, 100, 128.8, 131, 170};
  const std::vector<bool> all(5, true);
  EXPECT_EQ(paired(test, model, false), (Peaks{1, 3}));
  EXPECT_EQ(paired(test, model, false, {}, {.counts = all, .missed = {}}), (Peaks{1, 2}));
  EXPECT_EQ(paired({100, 130}, {60, 100, 120, 131, 170}, false, {}, {.counts = all, .missed = {}}),
            (Peaks{1, 3}))
      << "far cheaper";
  EXPECT_EQ(paired(test, model, false, {}, {.counts = all, .missed = {0, 1}}), (Peaks{1, 3}))
      << "the test says that it has not got one";
  EXPECT_EQ(paired(test, model, false, {}, {{true, true, false, true, true}, {}}), (Peaks{1, 3}))
      << "one along another axis";
}

// Two ways through the same sums: what is passed over costs nothing, or could but never does.
TEST(PeakChoice, pairs_alike_where_nothing_is_passed_over_at_a_cost) {
  std::mt19937 draw(20261127);
  std::uniform_real_distribution<double> step(0, 0.3);
  for (int round = 0; round < 200; ++round) {
    const auto list = [&](std::size_t count) {
      std::vector<double> hertz{100};
      while (hertz.size() < count) hertz.push_back(hertz.back() * std::exp(step(draw)));
      return hertz;
    };
    const std::vector<double> test = list(5), model = list(12);
    EXPECT_EQ(paired(test, model, false),
              paired(test, model, false, {}, {std::vector<bool>(model.size(), false), {}}));
  }
}

TEST(PeakChoice, leaves_out_what_is_below_twelve_percent_of_the_highest) {
  const VectorXd hertz{{10, 20, 30}}, zeta{{0.01, 0.01, 0.01}}, height{{1, 0.119, 0.121}};
  EXPECT_EQ(strong_peaks(hertz, zeta, height, no_band, 1), (Peaks{0, 2}));
  EXPECT_EQ(strong_peaks(hertz, zeta, height, no_band, 3), (Peaks{0, 1, 2})) << "as many as wanted";
}

TEST(PeakChoice, sees_two_modes_within_their_widths_as_one) {
  const VectorXd hertz{{100, 100.9, 120}}, zeta{{0.01, 0.01, 0.01}}, height{{0.9, 1, 0.5}};
  EXPECT_EQ(strong_peaks(hertz, zeta, height, no_band, 1), (Peaks{1, 2}));
}

TEST(PeakChoice, leaves_out_what_lies_a_fifth_beyond_the_band) {
  const VectorXd hertz{{39, 41, 100, 239, 241}}, zeta = VectorXd::Constant(5, 0.01),
                                                 height = VectorXd::Ones(5);
  EXPECT_EQ(strong_peaks(hertz, zeta, height, {50, 200}, 1), (Peaks{1, 2, 3}));
}

} // namespace
} // namespace plica
