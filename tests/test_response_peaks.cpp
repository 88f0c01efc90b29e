// What is read of the resonances of a measured response, against responses in closed form.
#include "diagnose/readings/response_peaks.hpp"

#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <random>

namespace plica {
namespace {

using Eigen::VectorXd;
using Complex = std::complex<double>;

TEST(ResponsePeaks, a_noisy_resonance_gives_its_frequency_width_and_height) {
  const double f0 = 200, zeta = 0.012, gain = 1.3;
  VectorXd hertz = VectorXd::LinSpaced(401, 100, 300);
  Eigen::VectorXcd H(hertz.size());
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.01);
  for (Eigen::Index k = 0; k < hertz.size(); ++k) {
    const double r = hertz[k] / f0;
    H[k] = 1. + gain * r * r / Complex(1 - r * r, 2 * zeta * r);
    H[k] *= 1. + Complex(noise(random), noise(random));
  }
  const auto peaks = response_peaks(hertz, H, 0.2);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].frequency / f0, 1, 1e-3);
  EXPECT_NEAR(peaks[0].damping / zeta, 1, 0.03);
  EXPECT_NEAR(peaks[0].amplitude / (gain / (2 * zeta)), 1, 0.02);
}

// The highest line of each sensor came a quarter below its top, so that a bellows with a third of
// its damping seemed to have changed the shape of its mode as well.
TEST(ResponsePeaks, lines_a_bandwidth_apart_do_not_miss_the_tops_of_any_sensor) {
  const double f0 = 754, zeta = 0.0033, step = 5;
  const auto seen_with = [&](const VectorXd& hertz, double gain) {
    Eigen::VectorXcd H(hertz.size());
    for (Eigen::Index k = 0; k < hertz.size(); ++k) {
      const double r = hertz[k] / f0;
      H[k] = 1. + gain * r * r / Complex(1 - r * r, 2 * zeta * r);
    }
    return H;
  };
  for (int phase = 0; phase < 8; ++phase) {
    const double from = 400 + step * phase / 8;
    const VectorXd hertz = VectorXd::LinSpaced(201, from, from + 200 * step);
    const auto peaks = response_peaks(hertz, seen_with(hertz, 1.3), 0.2);
    ASSERT_EQ(peaks.size(), 1U) << phase;
    EXPECT_NEAR(peaks[0].damping / zeta, 1, 1e-3);
    EXPECT_NEAR(peaks[0].amplitude / (1.3 / (2 * zeta)), 1, 0.01);
    for (double gain : {0.6, -0.05})
      EXPECT_NEAR(height_at(peaks[0], hertz, seen_with(hertz, gain)),
                  std::hypot(1, gain / (2 * zeta)), 0.015 * std::abs(gain) / (2 * zeta));
  }
}

// Mounted on springs, a healthy bellows has two such modes; a damping of 2 % was read and 1 %
// foretold.
TEST(ResponsePeaks, two_modes_within_their_widths_are_foretold_as_they_are_read) {
  const auto response = [](const VectorXd& hertz) {
    Eigen::VectorXcd H = Eigen::VectorXcd::Zero(hertz.size());
    for (double f : {1426., 1446.})
      for (Eigen::Index k = 0; k < hertz.size(); ++k) {
        const double r = hertz[k] / f;
        H[k] += 0.5 * r * r / Complex(1 - r * r, 2 * 0.01 * r);
      }
    return H;
  };
  const VectorXd lines = VectorXd::LinSpaced(251, 800, 1800);
  const auto peaks = response_peaks(lines, response(lines), 0.2);
  ASSERT_EQ(peaks.size(), 1U);
  const VectorXd own = 1426 * (1 + fitted_reach * 0.01 * VectorXd::LinSpaced(21, -1, 1).array());
  const double damping = apparent_damping(own, response(own), 1426, 0.01);
  EXPECT_GT(damping, 0.013);
  EXPECT_NEAR(damping / peaks[0].damping, 1, 0.1);
}

} // namespace
} // namespace plica
