// Rainflow counting and Miner's sum.
//
// Sources: the example of ASTM E1049-85 (figure 6 and its table of ranges); the worked example of
// cumulative usage of ASME VIII-2 4.19: 110,000 psi for 1,000 and 50,000 psi for 9,000 cycles.
#include "life/miner.hpp"
#include "life/rainflow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <random>

namespace plica::test {
namespace {

constexpr double pound_per_square_inch = 6894.757293168;

const std::vector<double> astm_history{-2, 1, -3, 5, -1, 3, -4, 4, -2};

std::map<double, double> counts_by_range(const std::vector<RainflowCycle>& cycles) {
  std::map<double, double> counts;
  for (const RainflowCycle& c : cycles) counts[c.range] += c.count;
  return counts;
}

TEST(LifeRainflow, the_example_of_astm_e1049_to_the_digit) {
  const std::map<double, double> expected{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1}, {9, 0.5}};
  EXPECT_EQ(counts_by_range(rainflow(astm_history)), expected);
}

// Letters of the figure: A-B, B-C, E-F (whole), C-D, D-G, G-H, H-I.
TEST(LifeRainflow, the_example_has_the_means_and_the_order_of_the_standard) {
  const double expected[][3] = {{3, -0.5, 0.5}, {4, -1, 0.5}, {4, 1, 1},  {8, 1, 0.5},
                                {9, 0.5, 0.5},  {8, 0, 0.5},  {6, 1, 0.5}};
  const std::vector<RainflowCycle> cycles = rainflow(astm_history);
  ASSERT_EQ(cycles.size(), std::size(expected));
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    EXPECT_EQ(cycles[i].range, expected[i][0]) << i;
    EXPECT_EQ(cycles[i].mean, expected[i][1]) << i;
    EXPECT_EQ(cycles[i].count, expected[i][2]) << i;
  }
}

TEST(LifeRainflow, samples_between_reversals_and_plateaus_change_nothing) {
  std::vector<double> fine;
  for (std::size_t i = 0; i + 1 < astm_history.size(); ++i)
    for (int k = 0; k < 8; ++k)
      for (int twice = 0; twice < 2; ++twice)
        fine.push_back(astm_history[i] + (astm_history[i + 1] - astm_history[i]) * k / 8.);
  fine.insert(fine.end(), 3, astm_history.back());
  EXPECT_EQ(counts_by_range(rainflow(fine)), counts_by_range(rainflow(astm_history)));
}

TEST(LifeRainflow, a_sine_of_n_periods_is_n_cycles_of_its_range) {
  std::vector<double> sine;
  for (int i = 0; i <= 1000; ++i) sine.push_back(std::cos(2 * M_PI * i / 100));
  double count = 0;
  for (const RainflowCycle& c : rainflow(sine)) {
    EXPECT_NEAR(c.range, 2, 1e-12);
    EXPECT_NEAR(c.mean, 0, 1e-12);
    count += c.count;
  }
  EXPECT_EQ(count, 10);
}

// Each cycle takes two reversals; halves take one.
TEST(LifeRainflow, of_noise_every_reversal_is_counted_once_and_the_largest_range_is_found) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> noise(20001);
  for (double& x : noise) x = normal(random);
  std::size_t reversals = 2;
  for (std::size_t i = 1; i + 1 < noise.size(); ++i)
    reversals += (noise[i] - noise[i - 1]) * (noise[i + 1] - noise[i]) < 0;
  double halves = 0, largest = 0;
  for (const RainflowCycle& c : rainflow(noise)) {
    halves += 2 * c.count;
    largest = std::max(largest, c.range);
  }
  EXPECT_EQ(halves, double(reversals - 1));
  const auto [low, high] = std::minmax_element(noise.begin(), noise.end());
  EXPECT_EQ(largest, *high - *low);
}

// Ten million samples of noise, as a record of hours has them: processor time.
TEST(LifeRainflow, ten_million_samples_are_counted_in_two_seconds) {
  std::mt19937_64 random(3);
  std::vector<double> noise(10'000'000);
  for (double& x : noise) x = double(random() >> 11);
  double cycles = 0;
  const std::clock_t start = std::clock();
  Rainflow flow([&](const RainflowCycle& c) { cycles += c.count; });
  for (const double x : noise) flow.add(x);
  flow.finish();
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("ten million samples, %.0f cycles: %.2f s\n", cycles, seconds);
  EXPECT_NEAR(cycles / (1e7 / 3), 1, 0.01) << "two of three samples of noise are reversals";
  EXPECT_LT(seconds, 2);
}

TEST(LifeRainflow, a_history_without_reversals_and_one_with_a_hole) {
  EXPECT_TRUE(rainflow({}).empty());
  EXPECT_TRUE(rainflow({1}).empty());
  EXPECT_TRUE(rainflow({1, 1, 1}).empty());
  ASSERT_EQ(rainflow({1, 2, 4}).size(), 1u);
  EXPECT_EQ(rainflow({1, 2, 4})[0].count, 0.5);
  EXPECT_THROW(rainflow({1, std::nan(""), 2}), std::invalid_argument);
}

FatigueCurve bellows_curve() {
  return {.name = "bellows", .source = "", .law = BellowsCurve{}};
}

TEST(LifeMiner, the_example_of_asme_for_bellows) {
  const MinerSum sum = miner(
      bellows_curve(), std::vector<StressBlock>{{{.range = 110000 * pound_per_square_inch}, 1000},
                                                {{.range = 50000 * pound_per_square_inch}, 9000}});
  EXPECT_NEAR(sum.blocks[0].life.cycles, 5258, 0.5);
  EXPECT_NEAR(sum.blocks[1].life.cycles / 119333, 1, 1e-4);
  EXPECT_NEAR(sum.damage, 0.266, 5e-4);
  EXPECT_NEAR(sum.repeats(), 1 / 0.266, 0.01);
  EXPECT_FALSE(sum.at_most || sum.at_least);
}

TEST(LifeMiner, cycles_below_the_curve_bound_the_damage_from_above) {
  const MinerSum sum = miner(
      bellows_curve(), std::vector<StressBlock>{{{.range = 200e6}, 1e5}, {{.range = 500e6}, 0}});
  EXPECT_TRUE(sum.at_most);
  EXPECT_FALSE(sum.at_least);
  EXPECT_DOUBLE_EQ(sum.damage, 0.1);
  EXPECT_EQ(sum.blocks[1].damage, 0);
  EXPECT_THROW(miner(bellows_curve(), std::vector<StressBlock>{{{.range = 1}, -1}}),
               std::invalid_argument);
}

TEST(LifeMiner, rainflow_cycles_of_a_sine_are_its_blocks) {
  std::vector<double> sine;
  for (int i = 0; i <= 2000; ++i) sine.push_back(300e6 * std::cos(2 * M_PI * i / 20));
  const FatigueCurve curve = bellows_curve();
  EXPECT_NEAR(miner(curve, rainflow(sine)).damage / (100 / life(curve, {.range = 600e6}).cycles), 1,
              1e-9);
}

} // namespace
} // namespace plica::test
