// Response to motion of chosen ends: closed forms, the motion of all ends together, the routes
// against each other.
#include "tests/tube_case.hpp"

#include <complex>
#include <numbers>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// Two springs in a row with half the bar each on either side of a mass m: with k1 = 1 / (1/k_left +
// 1/half) and k2 alike, moving both by a1, a2 gives the mass (a1 k1 + a2 k2) / (k1 + k2) at rest,
// and that times 1 + w^2 / (w0^2 - w^2 + 2 i zeta w0 w) in motion.
TEST(MovedEnds, one_mass_between_two_mounts_follows_the_closed_form) {
  constexpr double k_left = 4e4, k_right = 1e4, m = 2, zeta = 0.03, phase = 2;
  Case data = mass_between(k_left, k_right, m, zeta);
  Motion both = motion_of("left", 1);
  both.name = "both";
  both.with = {end_of(motion_of("right", 1, 0.4, phase))};
  data.analyses.response =
      Response{.bases = {},
               .motions = {motion_of("left", 1), motion_of("right", 1, 2.5), both},
               .band = {1, 80},
               .points = 60};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 3u);
  EXPECT_EQ(results.responses[0].excitation, "left_y");
  EXPECT_EQ(results.responses[0].source, Source::ends);
  constexpr double half = 2 * EA / L;
  const double k1 = 1 / (1 / k_left + 1 / half), k2 = 1 / (1 / k_right + 1 / half);
  const double w0 = std::sqrt((k1 + k2) / m);
  const std::array<Complex, 3> carried{k1 / (k1 + k2), 2.5 * k2 / (k1 + k2),
                                       (k1 + 0.4 * std::polar(1., phase) * k2) / (k1 + k2)};
  for (std::size_t r = 0; r < 3; ++r) {
    const ResponseResult& response = results.responses[r];
    for (Eigen::Index i = 0; i < response.hertz.size(); ++i) {
      const double w = 2 * pi * response.hertz[i];
      const Complex wanted =
          carried[r] * (1. + w * w / Complex(w0 * w0 - w * w, 2 * zeta * w0 * w));
      EXPECT_LT(std::abs(response.acceleration(i, 1) - wanted), 1e-5 * std::abs(wanted))
          << response.excitation << " at " << response.hertz[i] << " Hz";
    }
  }
}

// Ends that all move alike are the base, for translations.
TEST(MovedEnds, that_move_together_are_the_base) {
  Case data = verification_case("bellows_a", {.around = 24, .arc = 3, .wall = 3});
  data.mount = {
      {.cap = "left"},
      {.cap = "right", .kind = MountKind::springs, .stiffness = {1e5, 2e5, 1e5, 10, 10, 10}}};
  data.sensors = {{.name = "mid", .at = {0.035, 0.03, 0}, .reach = 0.1}};
  data.analyses.modes = Modes{.count = 8};
  data.analyses.damping.modal = 0.02;
  Motion together = motion_of("left", 2);
  together.move = {"left", "right"};
  data.analyses.response =
      Response{.bases = {2}, .motions = {together}, .band = {10, 400}, .points = 40};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 2u);
  const auto& base = results.responses[0].acceleration;
  EXPECT_LT((base - results.responses[1].acceleration).norm(), 1e-6 * base.norm());
}

// The same by rotational symmetry, on the full mesh and with superelements.
TEST(MovedEnds, are_the_same_on_every_route) {
  Case data = verification_case("bellows_a", {.around = 24, .arc = 3, .wall = 3});
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.sensors = {{.name = "mid", .at = {0.035, 0.03, 0}, .reach = 0.1}};
  data.analyses.modes = Modes{.count = 12};
  data.analyses.damping.modal = 0.02;
  Motion shaken = motion_of("right", 0);
  shaken.with = {end_of(motion_of("left", 4, 3, 0.5))};
  data.analyses.response =
      Response{.bases = {}, .motions = {shaken}, .band = {10, 800}, .points = 50};
  data.analyses.symmetry = Symmetry::required;
  const Results symmetric = run_silently(data);
  data.analyses.symmetry = Symmetry::off;
  const Results full = run_silently(data);
  const auto& wanted = full.responses.at(0).acceleration;
  ASSERT_EQ(symmetric.responses.at(0).acceleration.rows(), wanted.rows());
  EXPECT_LT((symmetric.responses[0].acceleration - wanted).norm(), 1e-5 * wanted.norm());
}

} // namespace
} // namespace plica::test
