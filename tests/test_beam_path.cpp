// Places along a beam, modes of free and hung ones, orders that bind, priors with bounds.
#include "diagnose/effects/beam_path.hpp"
#include "diagnose/results/normal_distribution.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

using namespace changed_beam;
using Eigen::VectorXd;

// A spring between two nodes of a path is the sum of those at the samples, exactly: that of an
// element whose ends move by a cubic, at a third of the way.
TEST(BeamPath, weights_of_a_place_are_those_of_polynomials_of_degree_six) {
  const BeamPath path{.part = "beam", .nodes = {0, 1, 2}, .at = {0, 0.3, 1.2}};
  const double s = 0.6, t = (s - 0.3) / 0.9;
  const VectorXd w = path.weights(s);
  ASSERT_EQ(w.size(), 13);
  EXPECT_TRUE(w.head(6).isZero());
  const auto h = [](double x) { return 1 - 3 * x * x + 2 * x * x * x; };
  double sum = 0;
  for (int j = 0; j <= 6; ++j) sum += w[6 + j] * h(j / 6.) * h(j / 6.);
  EXPECT_NEAR(sum, h(t) * h(t), 1e-12);
  EXPECT_NEAR(w.sum(), 1, 1e-12);
  EXPECT_NEAR(path.weights(0.3)[6], 1, 1e-12); // on a node
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
  const Case nominal = beam_of(5, 0.5, 0.03, 0.01, true);
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
}

} // namespace
} // namespace plica
