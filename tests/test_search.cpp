// Local and global search on functions whose minimum is known (De Jong, Rastrigin, Ackley,
// Schwefel, Griewank), and on a fit with two valleys.
#include "compare/search/search.hpp"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

struct Known {
  const char* name;
  int unknowns;
  double low, high, minimum; // at `place` in every unknown
  double place;
  double (*value)(const VectorXd&);
};

double rastrigin(const VectorXd& x) {
  return 10. * double(x.size()) + (x.array().square() - 10 * (2 * pi * x.array()).cos()).sum();
}
double ackley(const VectorXd& x) {
  const auto n = double(x.size());
  return -20 * std::exp(-0.2 * std::sqrt(x.squaredNorm() / n)) -
         std::exp((2 * pi * x.array()).cos().sum() / n) + 20 + std::numbers::e;
}
double schwefel(const VectorXd& x) {
  return 418.9828872724338 * double(x.size()) - (x.array() * x.array().abs().sqrt().sin()).sum();
}
double griewank(const VectorXd& x) {
  double product = 1;
  for (Eigen::Index i = 0; i < x.size(); ++i) product *= std::cos(x[i] / std::sqrt(double(i + 1)));
  return 1 + x.squaredNorm() / 4000 - product;
}
double rosenbrock(const VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i)
    sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
  return sum;
}

class GlobalSearchOn : public testing::TestWithParam<Known> {};

TEST_P(GlobalSearchOn, finds_the_global_minimum) {
  const Known& f = GetParam();
  const auto scaled = [&](const VectorXd& u) {
    return f.value(VectorXd((f.low + (f.high - f.low) * u.array()).matrix()));
  };
  GlobalSettings settings;
  settings.evaluations = 60000;
  settings.good_enough = 1e-6;
  const GlobalSearch found = search_globally(scaled, f.unknowns, settings);
  EXPECT_LT(found.cost, 1e-4) << found.evaluations << " evaluations";
  for (const double u : found.best) EXPECT_NEAR(f.low + (f.high - f.low) * u, f.place, 0.02);
}

// Boxes off centre, so that their middle is not the answer.
INSTANTIATE_TEST_SUITE_P(Functions, GlobalSearchOn,
                         testing::Values(Known{"rastrigin", 5, -5.12, 4.1, 0, 0, rastrigin},
                                         Known{"ackley", 5, -32, 25, 0, 0, ackley},
                                         Known{"schwefel", 4, -500, 500, 0, 420.9687, schwefel},
                                         Known{"griewank", 4, -60, 45, 0, 0, griewank},
                                         Known{"rosenbrock", 4, -2, 3, 0, 1, rosenbrock}),
                         [](const auto& f) { return std::string(f.param.name); });

TEST(GlobalSearch, gives_the_same_for_the_same_seed_and_keeps_its_budget) {
  GlobalSettings settings;
  settings.evaluations = 2000;
  const auto raised = [](const VectorXd& u) { return 1 + rastrigin(u); };
  const GlobalSearch a = search_globally(raised, 3, settings);
  const GlobalSearch b = search_globally(raised, 3, settings);
  EXPECT_EQ(a.best, b.best);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_GE(a.evaluations, 2000);
  EXPECT_LT(a.evaluations, 3200); // a round of all islands beyond
  EXPECT_GE(a.islands.size(), 5U);
}

TEST(GlobalSearch, begins_with_the_designs_it_is_given) {
  GlobalSettings settings;
  settings.evaluations = 10;
  const VectorXd best = VectorXd::Constant(6, 0.37);
  settings.starts = {best};
  const GlobalSearch found =
      search_globally([&](const VectorXd& u) { return (u - best).norm(); }, 6, settings);
  EXPECT_EQ(found.cost, 0);
}

TEST(LocalSearch, solves_rosenbrock_as_least_squares) {
  const ResidualModel model = [](const VectorXd& u) -> std::optional<VectorXd> {
    const double x = -2 + 4 * u[0], y = -1 + 3 * u[1];
    return VectorXd{{10 * (y - x * x), 1 - x}};
  };
  const LocalSearch found = search_locally(model, VectorXd{{0.1, 0.9}});
  EXPECT_TRUE(found.converged) << found.reason;
  EXPECT_NEAR(found.best[0], 0.75, 1e-6);
  EXPECT_NEAR(found.best[1], 2. / 3, 1e-6);
  EXPECT_LT(found.cost, 1e-12);
}

TEST(LocalSearch, stays_in_the_box_and_steps_back_where_there_is_no_result) {
  const ResidualModel model = [](const VectorXd& u) -> std::optional<VectorXd> {
    if (u[0] > 0.8) return std::nullopt;
    return VectorXd{{u[0] - 0.75, u[1] + 1}};
  };
  const LocalSearch found = search_locally(model, VectorXd{{0.1, 0.5}});
  EXPECT_NEAR(found.best[0], 0.75, 1e-6);
  EXPECT_NEAR(found.best[1], 0, 1e-9);
  EXPECT_THROW(search_locally(model, VectorXd{{0.9, 0.5}}), std::invalid_argument);
}

// Stopped within a step, where Ceres has nothing but its start.
TEST(LocalSearch, that_is_stopped_has_the_best_design_it_was_asked_for) {
  std::atomic<int> asked{0};
  std::atomic<double> least{1e30};
  const ResidualModel model = [&](const VectorXd& u) -> std::optional<VectorXd> {
    ++asked;
    const VectorXd r{{10 * (u[1] - u[0] * u[0]), 1 - u[0]}};
    for (double known = least;
         cost_of(r) < known && !least.compare_exchange_weak(known, cost_of(r));)
      ;
    return r;
  };
  const VectorXd start{{0.1, 0.9}};
  const double first = cost_of(model(start));
  int steps = 0;
  const LocalSearch found = search_locally(
      model, start, {.stop = [&] { return asked >= 12; }, .step = [&](int, double) { ++steps; }});
  EXPECT_TRUE(found.stopped);
  EXPECT_FALSE(found.converged);
  EXPECT_GT(steps, 0);
  EXPECT_LT(found.cost, 0.9 * first);
  EXPECT_EQ(found.cost, least);
  EXPECT_EQ(cost_of(model(found.best)), found.cost);
  EXPECT_LE(asked, 12 + 4); // those under way
}

// A strip at the optimum has results on one side alone.
TEST(LocalSearch, takes_slopes_from_the_side_that_has_a_result) {
  const ResidualModel model = [](const VectorXd& u) -> std::optional<VectorXd> {
    if (u[0] > 0.5) return std::nullopt;
    return VectorXd{{2 * u[0], 3 * u[1]}};
  };
  const auto J = residual_jacobian(model, VectorXd{{0.5, 0.5}});
  ASSERT_TRUE(J.has_value());
  EXPECT_NEAR((*J)(0, 0), 2, 1e-9);
  EXPECT_NEAR((*J)(1, 1), 3, 1e-9);
}

// x^2 is met by both signs of x, x itself by one of them.
// Least side of rectangles of an area of at least 0.1: the square. Stresses come in single
// precision.
TEST(LimitedSearch, ends_on_a_limit_that_bends) {
  int asked = 0;
  const ResidualModel sides = [&](const VectorXd& u) -> std::optional<VectorXd> {
    ++asked;
    return VectorXd{{u[0] + u[1], (0.1 - double(float(u[0] * u[1]))) / 1e-4}};
  };
  const LocalSearch found = search_within(sides, 1, VectorXd{{0.9, 0.2}});
  EXPECT_TRUE(found.converged) << found.reason;
  EXPECT_NEAR(found.best.sum(), 2 * std::sqrt(0.1), 1e-6);
  EXPECT_NEAR(found.best[0], std::sqrt(0.1), 2e-3); // the sum is flat along the limit
  EXPECT_NEAR(found.best.prod(), 0.1, 1e-6);
  EXPECT_LT(asked, 200);
}

TEST(LimitedSearch, meets_a_limit_from_either_side_in_few_evaluations) {
  for (const double start : {0.05, 0.4, 0.95}) {
    int asked = 0;
    const ResidualModel stress = [&](const VectorXd& u) -> std::optional<VectorXd> {
      ++asked;
      const double height = 6 + 7 * u[0];
      return VectorXd{{height / 8, (double(float(150 * std::pow(8 / height, 2.2))) - 150) / 0.15}};
    };
    const LocalSearch found = search_within(stress, 1, VectorXd{{start}});
    EXPECT_TRUE(found.converged) << found.reason;
    EXPECT_NEAR(found.best[0], 2. / 7, 1e-6) << start;
    EXPECT_LT(asked, 50) << start;
  }
}

TEST(LimitedSearch, keeps_bounds_and_says_what_no_design_keeps) {
  const ResidualModel never = [](const VectorXd& u) -> std::optional<VectorXd> {
    return VectorXd{{u[0] + u[1] + 1, (2 - u[0]) / 1e-3}};
  };
  const LocalSearch found = search_within(never, 1, VectorXd{{0.1, 0.5}});
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.best[0], 1);
  EXPECT_NEAR(found.best[1], 0, 1e-6);
  EXPECT_NEAR(found.cost, (1000. * 1000 + 4) / 2, 1e-6 * found.cost);
  EXPECT_THROW(search_within([](const VectorXd&) -> std::optional<VectorXd> { return {}; }, 0,
                             VectorXd{{0.5}}),
               std::invalid_argument);
}

TEST(Search, is_trapped_locally_in_a_valley_that_the_global_one_leaves) {
  const ResidualModel model = [](const VectorXd& u) -> std::optional<VectorXd> {
    const double x = 6 * u[0] - 3; // valleys near -2 (cost 0.5) and 2 (cost 0)
    return VectorXd{{x * x - 4, 0.25 * (x - 2)}};
  };
  const LocalSearch local = search_locally(model, VectorXd{{0.2}});
  EXPECT_TRUE(local.converged);
  EXPECT_NEAR(6 * local.best[0] - 3, -1.984252, 1e-5); // root of its derivative
  EXPECT_GT(local.cost, 0.4);
  GlobalSettings settings;
  settings.evaluations = 3000;
  settings.starts = {VectorXd{{0.2}}};
  const GlobalSearch global =
      search_globally([&](const VectorXd& u) { return cost_of(model(u)); }, 1, settings);
  EXPECT_LT(global.cost, 1e-6);
  EXPECT_NEAR(6 * global.best[0] - 3, 2, 1e-3);
}

} // namespace
} // namespace plica
