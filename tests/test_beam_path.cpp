// Places along a beam, modes of free and hung ones, orders that bind, priors with bounds.
#include "run/results/normal_distribution.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

using namespace changed_beam;
using Eigen::VectorXd;

// Closed form: the clamped beam with a spring k at its tip (Blevins, Formulas for Natural Frequency
// and Mode Shape, table 8-1), kappa = k L^3 / EI: kappa (sin b cosh b - cos b sinh b) +
// b^3 (1 + cos b cosh b) = 0. Two thirds of what the tip itself has is a touch, and the very end of
// a beam is where things touch.
TEST(BeamPath, a_soft_touch_at_the_tip_is_found_as_that) {
  const double L = 0.8, width = 0.03, depth = 0.005, kappa = 2;
  const auto off = [&](double b) {
    return kappa * (std::sin(b) * std::cosh(b) - std::cos(b) * std::sinh(b)) +
           b * b * b * (1 + std::cos(b) * std::cosh(b));
  };
  const Case nominal = beam_of(4, L, width, depth, true);
  Measured m;
  m.specimen = "beam";
  // Between the roots of the beam that is free at its tip, and pinned there.
  constexpr std::array ends{std::pair{1.8752, 3.9266}, std::pair{4.6942, 7.0685},
                            std::pair{7.8549, 10.2101}, std::pair{10.9956, 13.3517}};
  const double unit =
      std::sqrt(200e9 * depth * depth / (12 * 7850)) / (2 * std::numbers::pi * L * L);
  for (int k = 0; k < 4; ++k) {
    auto [low, high] = ends[std::size_t(k)];
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (off(middle) * off(low) > 0 ? low : high) = middle;
    }
    m.modes.push_back(bending(Axis::z, k + 1, "", unit * low * low));
    m.modes.back().sigma = 1e-3 * unit * low * low;
  }
  const Diagnosis d = diagnosis_of(nominal, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "extra_support") << d.headline;
  const double k = kappa * 200e9 * width * depth * depth * depth / 12 / (L * L * L);
  ASSERT_EQ(e.parameters.front().name, "k");
  EXPECT_LE(e.parameters.front().interval[0], k);
  EXPECT_GE(e.parameters.front().interval[1], k);
  EXPECT_GE(e.parameters.back().value, 0.9 * L) << d.headline;
  EXPECT_GE(e.parameters.back().interval[1], 0.98 * L) << d.headline;
}

// Closed form: (beta L)^2 of the free-free beam, Blevins, Formulas for Natural Frequency and Mode
// Shape, table 8-1. Slender enough for shear and rotary inertia to take 0.1 % of the third.
TEST(FreeParts, have_the_modes_of_a_free_beam_whether_they_hang_or_not) {
  const double L = 1, depth = 0.005;
  Case free = beam_of(4, L, 0.03, depth, false);
  Case hung = beam_of(4, L, 0.03, depth, true);
  hung.mount.front().kind = MountKind::springs;
  hung.mount.front().stiffness = {20, 20, 20, 0.02, 0.02, 0.02};
  Measured m;
  m.specimen = "beam";
  for (int order = 1; order <= 3; ++order) m.modes.push_back(bending(Axis::z, order, ""));
  constexpr std::array beta{4.730041, 7.853205, 10.995608};
  for (int k = 0; k < 3; ++k) {
    const double expected = std::pow(beta[std::size_t(k)] / L, 2) / (2 * std::numbers::pi) *
                            std::sqrt(200e9 * depth * depth / (12 * 7850));
    m.modes[std::size_t(k)].frequency = expected;
    EXPECT_NEAR(std::exp(read_by(free, m)[k]) / expected, 1, 2e-3) << k;
    EXPECT_NEAR(std::exp(read_by(hung, m)[k]) / expected, 1, 4e-3) << k;
  }
}

TEST(Orders, bind_however_far_the_frequency) {
  const Case nominal = held_beam();
  Measured m;
  m.specimen = "beam";
  m.modes = {bending(Axis::z, 1, "", 1), bending(Axis::z, 2, "", 1)};
  const VectorXd near = read_by(nominal, m);
  m.modes[0].frequency = 10 * std::exp(near[0]); // where the second and third are
  m.modes[1].frequency = 10 * std::exp(near[1]);
  const VectorXd far = read_by(nominal, m);
  EXPECT_EQ(far[0], near[0]);
  EXPECT_EQ(far[1], near[1]);
}

TEST(Priors, keep_within_their_bounds_and_their_shape) {
  const Prior bounded{PriorKind::normal, 0, 100, -10, 10};
  EXPECT_NEAR(value_of(bounded, 0), 0, 1e-9);
  EXPECT_GE(value_of(bounded, -8), -10);
  EXPECT_LE(value_of(bounded, 8), 10);
  EXPECT_NEAR(value_of(bounded, normal_quantile(0.75)), 5, 0.01); // nearly even between them
  const Prior half{PriorKind::normal, 0, 1, 0, std::numeric_limits<double>::infinity()};
  EXPECT_NEAR(value_of(half, 0), normal_quantile(0.75), 1e-9);
  const Prior ends{PriorKind::towards_ends, 1, 3}; // arcsine law: a third lies in either quarter
  EXPECT_NEAR(value_of(ends, 0), 2, 1e-12);
  EXPECT_NEAR(value_of(ends, normal_quantile(1. / 3)), 1.5, 1e-9);
  EXPECT_NEAR(value_of(ends, 8), 3, 1e-9);
}

} // namespace
} // namespace plica
