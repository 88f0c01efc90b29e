// Fatigue from spectral densities.
//
// Sources: closed form of the narrow band; the lives that the test of FLife (ladisk, version 2.2.2,
// tests/test_basic.py, k = 6, C = 1.8e19) states for one measured signal; rainflow counting of a
// Gaussian signal of a known density.
#include "life/miner.hpp"
#include "life/spectral.hpp"
#include "tests/support/verification_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace plica::test {
namespace {

using Method = SpectralMethod;
using std::numbers::pi;

// Two flat bands, [low, high, density].
struct Band {
  double low, high, density;
};

SpectralMoments moments_of(const std::vector<Band>& bands) {
  SpectralMoments m;
  for (const Band& band : bands) {
    const auto add = [&](double& moment, double n) {
      moment += band.density * (std::pow(band.high, n + 1) - std::pow(band.low, n + 1)) / (n + 1);
    };
    add(m.m0, 0), add(m.m075, 0.75), add(m.m1, 1), add(m.m15, 1.5), add(m.m2, 2), add(m.m4, 4);
  }
  return m;
}

const std::vector<Band> two_bands{{20, 60, 5. / 40}, {100, 120, 2. / 20}};

// The lives of one signal by four methods fix its three shape parameters: a075 from the ratio of
// alpha 0.75 to the narrow band, a2 from Tovo and Benasciutti's third method (b from a075 and a2),
// a1 from their first (b = (a1 - a2) / (1 - a1)). The other two lives are then predictions.
struct FlifeCase {
  double narrow_band = 1064.200649, alpha_075 = 1625.785759; // s
  double tovo_1 = 1099.438159, tovo_3 = 1842.281870;         // s
  double tovo_2 = 1657.218508, dirlik = 1595.031603;         // s, to be found
  double k = 6, C = 1.8e19;
};

double bisect(double low, double high, const std::function<double(double)>& f) {
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) > 0) == (f(low) > 0) ? low : high) = middle;
  }
  return low;
}

SpectralMoments flife_moments(const FlifeCase& c) {
  const double a075_squared = c.narrow_band / c.alpha_075;
  const double a2 = bisect(0.01, 0.8, [&](double a) {
    const double b = (a075_squared - a * a) / (1 - a * a);
    return b + (1 - b) * std::pow(a, c.k - 1) - c.narrow_band / c.tovo_3;
  });
  const double p = std::pow(a2, c.k - 1), b = (c.narrow_band / c.tovo_1 - p) / (1 - p);
  const double a1 = (b + a2) / (1 + b);
  // Any scale of frequency: nu0 = 1 Hz, and the variance from the life of the narrow band.
  const double m0 = std::pow(c.C / c.narrow_band / std::tgamma(1 + c.k / 2), 2 / c.k) / 2;
  return {.m0 = m0,
          .m075 = std::sqrt(a075_squared * m0),
          .m1 = a1 * m0,
          .m15 = 1,
          .m2 = m0,
          .m4 = m0 / (a2 * a2)};
}

TEST(LifeSpectral, lives_are_those_that_flife_states) {
  const FlifeCase c;
  const SpectralMoments m = flife_moments(c);
  const auto life_by = [&](Method method) { return c.C / power_rate(method, m, c.k); };
  EXPECT_NEAR(life_by(Method::narrow_band) / c.narrow_band, 1, 1e-9);
  EXPECT_NEAR(life_by(Method::alpha_075) / c.alpha_075, 1, 1e-9);
  EXPECT_NEAR(life_by(Method::tovo_benasciutti) / c.tovo_2, 1, 1e-7);
  EXPECT_NEAR(life_by(Method::dirlik) / c.dirlik, 1, 1e-7);
}

// The bimodal density of "FLife Showcase" (notebook in FLife's repository): 1 from 100 to 150 Hz,
// 1/5 from 500 to 600 Hz on lines of 1 Hz, scaled to an RMS of 100; C = 1.8e19, k = 6. Its printed
// lives are from a density that Welch's method found again in a signal of 100 s, to whole seconds.
TEST(LifeSpectral, lives_of_a_bimodal_density_are_those_that_flife_prints) {
  const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(1000, 0, 999);
  const auto in = [](double x, double low, double high) { return x >= low && x <= high; };
  Eigen::VectorXd G = f.unaryExpr([&](double x) {
    return in(x, 100, 150) ? 1. : in(x, 500, 600) ? 0.2 : 0.;
  });
  G *= 1e4 / spectral_moments(f, G).m0;
  const SpectralMoments m = spectral_moments(f, G);
  EXPECT_NEAR(m.rms(), 100, 1e-9);
  for (const auto& [method, seconds] : {std::pair(Method::narrow_band, 1204.),
                                        {Method::alpha_075, 1618.},
                                        {Method::tovo_benasciutti, 1873.},
                                        {Method::dirlik, 1753.}}) {
    const double life = 1.8e19 / power_rate(method, m, 6);
    print_for_table("bimodal density, life beside FLife, s", life, seconds, 0.01);
    EXPECT_NEAR(life / seconds, 1, 0.01);
  }
}

TEST(LifeSpectral, moments_of_straight_lines_are_exact) {
  Eigen::VectorXd f(4), G(4);
  f << 0, 10, 30, 40;
  G << 0, 2, 2, 0;
  const SpectralMoments m = spectral_moments(f, G);
  EXPECT_NEAR(m.m0, 10 + 40 + 10, 1e-12);
  EXPECT_NEAR(m.m1, 20 * m.m0, 1e-9); // symmetric about 20 Hz
  const SpectralMoments flat = moments_of({{20, 60, 3}});
  f.resize(3), G.resize(3);
  f << 20, 33, 60;
  G << 3, 3, 3;
  const SpectralMoments lines = spectral_moments(f, G);
  for (const auto& [a, b] : {std::pair{lines.m075, flat.m075},
                             {lines.m15, flat.m15},
                             {lines.m2, flat.m2},
                             {lines.m4, flat.m4}})
    EXPECT_NEAR(a / b, 1, 1e-12);
  f[1] = 10;
  EXPECT_THROW(spectral_moments(f, G), std::invalid_argument);
  EXPECT_THROW(spectral_moments(Eigen::VectorXd::LinSpaced(3, 0, 1), Eigen::VectorXd::Zero(3)),
               std::invalid_argument);
}

TEST(LifeSpectral, the_narrow_band_has_its_closed_form) {
  const SpectralMoments m = moments_of(two_bands);
  for (const double k : {3., 5., 7.3})
    EXPECT_NEAR(power_rate(Method::narrow_band, m, k) /
                    (std::sqrt(m.m2 / m.m0) * std::pow(2 * m.m0, k / 2) * std::tgamma(1 + k / 2)),
                1, 1e-13);
}

// One line of a spectrum is a narrow band for every method.
TEST(LifeSpectral, all_methods_meet_in_the_narrow_band) {
  const SpectralMoments m = moments_of({{99.9, 100.1, 1}});
  const double narrow = power_rate(Method::narrow_band, m, 5);
  for (const Method method : {Method::dirlik, Method::tovo_benasciutti, Method::alpha_075})
    EXPECT_NEAR(power_rate(method, m, 5) / narrow, 1, 0.01);
  SpectralMoments line{.m0 = 1, .m075 = 1, .m1 = 1, .m15 = 1, .m2 = 1, .m4 = 1};
  for (const Method method : {Method::dirlik, Method::tovo_benasciutti, Method::alpha_075})
    EXPECT_NEAR(power_rate(method, line, 5) / power_rate(Method::narrow_band, line, 5), 1, 1e-9);
}

TEST(LifeSpectral, integration_over_a_power_law_is_the_closed_form) {
  SpectralMoments m = moments_of(two_bands);
  for (double* moment : {&m.m0, &m.m075, &m.m1, &m.m15, &m.m2, &m.m4}) *moment *= 1e12;
  const StressLifeCurve law{
      .knee_amplitude = 1e6, .knee_cycles = 1e6, .slope = 5, .second_slope = 5};
  const FatigueCurve curve{.name = "", .source = "", .law = law};
  for (const Method method :
       {Method::narrow_band, Method::dirlik, Method::tovo_benasciutti, Method::alpha_075})
    EXPECT_NEAR(damage_rate(method, m, curve).per_second /
                    (power_rate(method, m, 5) / (1e6 * std::pow(1e6, 5))),
                1, 1e-6);
}

TEST(LifeSpectral, a_limit_and_the_end_of_a_curve_are_heeded) {
  SpectralMoments m = moments_of(two_bands);
  for (double* moment : {&m.m0, &m.m075, &m.m1, &m.m15, &m.m2, &m.m4}) *moment *= 1e14;
  StressLifeCurve law{.knee_amplitude = 80e6, .knee_cycles = 1e6, .slope = 5, .second_slope = 5};
  FatigueCurve curve{.name = "", .source = "", .law = law};
  const double without = damage_rate(Method::dirlik, m, curve).per_second;
  law.second_slope.reset();
  curve.law = law;
  const double with = damage_rate(Method::dirlik, m, curve).per_second;
  EXPECT_LT(with, without);
  EXPECT_GT(with, 0);
  const SpectralDamage bellows =
      damage_rate(Method::dirlik, m, {.name = "", .source = "", .law = BellowsCurve{}});
  EXPECT_TRUE(bellows.at_most);
  EXPECT_FALSE(bellows.at_least);
}

// A sum of sines with random phases, counted; Dirlik made his formula for such.
TEST(LifeSpectral, dirlik_is_near_the_rainflow_count_of_a_gaussian_signal) {
  const SpectralMoments m = moments_of(two_bands);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<std::array<double, 3>> sines; // amplitude, w, phase
  for (const Band& band : two_bands)
    for (int i = 0; i < 60; ++i)
      sines.push_back({std::sqrt(2 * band.density * (band.high - band.low) / 60),
                       2 * pi * (band.low + (band.high - band.low) * (i + uniform(random)) / 60),
                       2 * pi * uniform(random)});
  constexpr double rate = 2500, seconds = 200, k = 5;
  double sum = 0;
  Rainflow counter([&](const RainflowCycle& c) { sum += c.count * std::pow(c.range / 2, k); });
  for (int i = 0; i < int(rate * seconds); ++i) {
    double x = 0;
    for (const auto& [a, w, phase] : sines) x += a * std::cos(w * i / rate + phase);
    counter.add(x);
  }
  counter.finish();
  EXPECT_NEAR(power_rate(Method::dirlik, m, k) / (sum / seconds), 1, 0.12);
  EXPECT_NEAR(power_rate(Method::tovo_benasciutti, m, k) / (sum / seconds), 1, 0.12);
  EXPECT_GT(power_rate(Method::narrow_band, m, k), sum / seconds);
}

// Davenport: g = 3.72 + 0.155 for 1000 crossings.
TEST(LifeSpectral, the_expected_peak_in_a_duration) {
  const SpectralMoments m{.m0 = 4, .m075 = 0, .m1 = 0, .m15 = 0, .m2 = 400, .m4 = 1};
  EXPECT_DOUBLE_EQ(m.up_crossings(), 10);
  EXPECT_NEAR(expected_peak(m, 100), 2 * (3.7169 + 0.1553), 2e-3);
  EXPECT_DOUBLE_EQ(three_sigma(m), 6);
  EXPECT_THROW(expected_peak(m, 0.1), std::invalid_argument);
}

} // namespace
} // namespace plica::test
