#include "diagnose/weigh/cross_scatter.hpp"

#include "diagnose/readings/reading.hpp"
#include "diagnose/weigh/normal_draws.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

double log_reading(double value) {
  return std::log(std::abs(value) + cross_floor);
}

// Specimens whose structure shows `own` and whose scatter adds a normal variable: mean and variance
// of the log reading.
std::pair<double, double> drawn(double own, double sigma) {
  constexpr int count = 20000;
  NormalDraws draw(7);
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const double y = log_reading(own + sigma * draw());
    sum += y;
    squares += y * y;
  }
  const double mean = sum / count;
  return {mean, squares / count - mean * mean};
}

// What the nominal structure shows by itself, say by a sensor off its axis, a fixture may take
// away: scatter stays. Judged by direct draws.
TEST(CrossScatter, is_left_where_the_structure_shows_nothing) {
  constexpr double sigma = 0.05, nominal = 0.16;
  const auto [expected, variance] = drawn(nominal, sigma);
  const CrossLaw law(sigma * sigma, log_reading(nominal), expected);
  EXPECT_NEAR(law.mean(log_reading(nominal), 1), expected, 1e-12);
  EXPECT_EQ(law.further_deviation(log_reading(nominal), 1), 0);
  for (const double own : {0., 0.03, 0.08, 0.4, 2.}) {
    const auto [mean, spread] = drawn(own, sigma);
    EXPECT_NEAR(law.mean(log_reading(own), 1), mean, 0.05) << own;
    const double total =
        std::sqrt(variance + std::pow(law.further_deviation(log_reading(own), 1), 2));
    EXPECT_NEAR(total, std::sqrt(std::max(variance, spread)), 0.05) << own;
  }
}

// The other way round: a symmetrical structure shows nothing, a hypothesis much.
TEST(CrossScatter, vanishes_beside_a_large_response) {
  constexpr double sigma = 0.05;
  const auto [expected, variance] = drawn(0, sigma);
  const CrossLaw law(sigma * sigma, log_reading(0), expected);
  EXPECT_NEAR(law.mean(log_reading(0), 1), expected, 1e-12);
  EXPECT_NEAR(law.mean(log_reading(1), 1), log_reading(1), 0.01);
  EXPECT_EQ(law.further_deviation(log_reading(1), 1), 0);
}

// A table and sensors whose errors show four times as much where a hypothesis brings the other axis
// near its resonance.
TEST(CrossScatter, grows_with_what_the_errors_of_the_test_show) {
  constexpr double sigma = 0.05;
  const CrossLaw law(sigma * sigma, log_reading(0), drawn(0, sigma).first);
  EXPECT_NEAR(law.mean(log_reading(0), 16), drawn(0, 4 * sigma).first, 0.05);
  EXPECT_EQ(law.mean(log_reading(0), 0.5), law.mean(log_reading(0), 1));
}

// Where the nominal structure shows no peak nothing says how much its errors grow.
TEST(CrossScatter, stays_where_the_errors_of_the_test_are_not_known) {
  const CrossScatter unknown, known{.by_test = 0.01};
  EXPECT_EQ(unknown.times(0.04), 1);
  EXPECT_EQ(known.times(0.04), 4);
}

} // namespace
} // namespace plica
