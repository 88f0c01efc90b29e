// Estimators of spectra and frequency responses against their definitions and their statistics
// (Bendat and Piersol, Random Data; Welch 1967).
#include "lab/signals/fourier.hpp"
#include "lab/signals/frf_estimate.hpp"
#include "lab/signals/sine_tracking.hpp"
#include "lab/signals/spectrum.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double two_pi = 2 * std::numbers::pi;

VectorXd noise(Index n, double sigma, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, sigma);
  return VectorXd::NullaryExpr(n, [&] { return normal(random); });
}

TEST(Window, hann_has_its_constants) {
  const VectorXd w = window_samples(Window::hann, 1024);
  EXPECT_NEAR(noise_bandwidth(w), 1.5, 1e-12);
  EXPECT_NEAR(w.mean(), 0.5, 1e-12);
}

// A flat top reads the amplitude of a sine between two lines to 0.01 dB (ISO 18431-2), Hann loses
// up to 1.5 dB.
TEST(Window, flat_top_reads_a_sine_between_lines) {
  const int n = 1024;
  const VectorXd x =
      VectorXd::NullaryExpr(n, [](Index i) { return std::cos(two_pi * 100.5 * double(i) / 1024); });
  for (const auto& [window, loss] : {std::pair{Window::flat_top, 0.00116}, {Window::hann, 0.16}}) {
    const VectorXd w = window_samples(window, n);
    const double read = 2 / w.sum() * Fourier(n).forward(x.cwiseProduct(w)).cwiseAbs().maxCoeff();
    EXPECT_NEAR(read, 1, loss);
  }
}

TEST(Fourier, comes_back_and_keeps_the_energy) {
  for (int n : {8, 15, 1000}) {
    const VectorXd x = noise(n, 1, 1);
    Fourier f(n);
    const Eigen::VectorXcd X = f.forward(x);
    EXPECT_LT((f.inverse(X) - x).norm(), 1e-13 * x.norm());
    double energy = X.squaredNorm() * 2 - std::norm(X[0]); // Parseval
    if (n % 2 == 0) energy -= std::norm(X[n / 2]);
    EXPECT_NEAR(energy / n, x.squaredNorm(), 1e-10 * x.squaredNorm());
  }
  EXPECT_THROW(Fourier(0), std::invalid_argument);
}

// 0.947 K for large K: 9.52, 19.00, 94.79 (own calculation of the reference values).
TEST(Welch, hann_half_overlap_has_its_effective_averages) {
  const WelchSettings s{.block = 1024, .overlap = 0.5, .window = Window::hann};
  EXPECT_NEAR(effective_averages(10, s), 9.52, 0.01);
  EXPECT_NEAR(effective_averages(20, s), 19.00, 0.01);
  EXPECT_NEAR(effective_averages(100, s), 94.79, 0.01);
}

// The area under the density of white noise is its variance; random error 2 / sqrt(n_d).
TEST(Welch, area_is_the_variance_of_white_noise) {
  const WelchSettings s{.block = 512};
  for (const Window window : {Window::rectangular, Window::hann, Window::flat_top}) {
    WelchSettings t = s;
    t.window = window;
    const MatrixXd x = noise(100000, 3, 7);
    const Spectra g = welch(x, 1000, {0}, {0}, t);
    const double variance = std::pow(band_rms(g.hertz, g.yy, 0, 500)[0], 2);
    EXPECT_NEAR(variance / 9, 1, 2 / std::sqrt(g.averages));
    // Of this very record, but for the means that the blocks lose.
    EXPECT_NEAR(variance / (x.squaredNorm() / 1e5), 1, g.resolution / 500);
    EXPECT_NEAR(g.yy.col(0).segment(5, 240).mean() / (9. / 500), 1, 0.02);
  }
}

// A sine of amplitude a has the RMS a / sqrt 2 in its band, whatever the window.
TEST(Welch, sine_has_its_power_in_its_band) {
  const double rate = 2048;
  const MatrixXd x = VectorXd::NullaryExpr(
      20480, [&](Index i) { return 5 * std::sin(two_pi * 200.3 * double(i) / rate); });
  const Spectra g = welch(x, rate, {0}, {0}, {.block = 2048, .window = Window::flat_top});
  EXPECT_NEAR(band_rms(g.hertz, g.yy, 190, 210)[0], 5 / std::numbers::sqrt2, 1e-3);
  EXPECT_LT(band_rms(g.hertz, g.yy, 300, 900)[0], 5 * 1e-4); // side lobes below -80 dB
}

TEST(Welch, names_what_is_wrong) {
  const MatrixXd x = noise(100, 1, 1);
  EXPECT_THROW(welch(x, 1000, {0}, {0}, {.block = 200}), std::invalid_argument);
  EXPECT_THROW(welch(x, 1000, {0}, {1}, {.block = 32}), std::invalid_argument);
  EXPECT_THROW(welch(x, 0, {0}, {0}, {.block = 32}), std::invalid_argument);
  EXPECT_THROW(welch(x, 1000, {0}, {0}, {.block = 32, .overlap = 1}), std::invalid_argument);
}

// y = 2 x with noise of a tenth of the power at the output: H1 unbiased, H2 = H (1 + 1/s), and the
// other way round at the input.
TEST(FrfEstimate, bias_is_as_the_theory_says) {
  const Index n = 400000;
  const VectorXd x = noise(n, 1, 3);
  for (const bool at_output : {true, false}) {
    MatrixXd samples(n, 2);
    samples.col(0) = x;
    samples.col(1) = 2 * x;
    if (at_output) samples.col(1) += noise(n, 2 * std::sqrt(0.1), 4);
    if (!at_output) samples.col(0) += noise(n, std::sqrt(0.1), 4);
    const Spectra g = welch(samples, 1000, {0}, {1}, {.block = 256});
    const auto mean = [&](FrfEstimator e) {
      return estimate_frf(g, e).H[0].col(0).segment(3, 120).real().mean();
    };
    EXPECT_NEAR(mean(FrfEstimator::H1), at_output ? 2 : 2 / 1.1, 0.005);
    EXPECT_NEAR(mean(FrfEstimator::H2), at_output ? 2.2 : 2, 0.005);
    const FrfEstimate H1 = estimate_frf(g, FrfEstimator::H1),
                      H2 = estimate_frf(g, FrfEstimator::H2),
                      Hv = estimate_frf(g, FrfEstimator::Hv);
    for (Index f = 3; f < 120; ++f) {
      EXPECT_LE(std::abs(H1.H[0](f, 0)), std::abs(Hv.H[0](f, 0)) * (1 + 1e-12));
      EXPECT_LE(std::abs(Hv.H[0](f, 0)), std::abs(H2.H[0](f, 0)) * (1 + 1e-12));
      // gamma^2 = H1 / H2
      EXPECT_NEAR(H1.coherence(f, 0), std::abs(H1.H[0](f, 0) / H2.H[0](f, 0)), 1e-12);
    }
  }
}

// n_d = 100, gamma^2 = 0.9: 2.36 %.
TEST(FrfEstimate, random_error_is_that_of_the_formula_and_of_trials) {
  EXPECT_NEAR(frf_random_error(0.9, 100), 0.02357, 1e-5);
  // Trials: blocks without overlap, rectangular window, so that n_d is their number.
  std::vector<double> found;
  for (unsigned trial = 0; trial < 40; ++trial) {
    const Index n = 100 * 64;
    MatrixXd samples(n, 2);
    samples.col(0) = noise(n, 1, 100 + trial);
    samples.col(1) = samples.col(0) + noise(n, std::sqrt(1 / 9.), 500 + trial); // gamma^2 = 0.9
    const Spectra g =
        welch(samples, 64, {0}, {1}, {.block = 64, .overlap = 0, .window = Window::rectangular});
    const FrfEstimate e = estimate_frf(g, FrfEstimator::H1);
    for (Index f = 2; f < 30; ++f) found.push_back(std::abs(e.H[0](f, 0)));
  }
  double mean = 0, square = 0;
  for (double h : found) mean += h / double(found.size());
  for (double h : found) square += (h - mean) * (h - mean) / double(found.size() - 1);
  EXPECT_NEAR(std::sqrt(square) / 0.02357, 1, 0.1); // 1120 values: 2 % on their deviation
}

// Two uncorrelated inputs at once: H1 separates them, H2 is refused.
TEST(FrfEstimate, separates_two_inputs) {
  const Index n = 200000;
  MatrixXd samples(n, 3);
  samples.col(0) = noise(n, 1, 11);
  samples.col(1) = noise(n, 1, 12) + 0.5 * samples.col(0); // partly correlated
  samples.col(2) = 3 * samples.col(0) - 2 * samples.col(1) + noise(n, 0.1, 13);
  const Spectra g = welch(samples, 1000, {0, 1}, {2}, {.block = 256});
  const FrfEstimate e = estimate_frf(g, FrfEstimator::H1);
  EXPECT_NEAR(e.H[0].col(0).segment(3, 120).real().mean(), 3, 0.01);
  EXPECT_NEAR(e.H[1].col(0).segment(3, 120).real().mean(), -2, 0.01);
  EXPECT_GT(e.coherence.col(0).segment(3, 120).minCoeff(), 0.99);
  EXPECT_THROW(estimate_frf(g, FrfEstimator::H2), std::invalid_argument);
}

TEST(SineFit, is_exact_for_any_part_of_a_period) {
  const double rate = 1000, hertz = 7.3;
  MatrixXd x(400, 1);
  for (Index i = 0; i < 400; ++i) {
    const double p = two_pi * hertz * double(i) / rate;
    x(i, 0) = 4 + 2 * std::cos(p + 0.3) + 0.2 * std::cos(3 * p - 1);
  }
  const SineLine line = fit_sine(x, rate, hertz, 5);
  EXPECT_NEAR(std::abs(line.amplitude(0, 0) - std::polar(2., 0.3)), 0, 1e-10);
  EXPECT_NEAR(std::abs(line.amplitude(2, 0) - std::polar(0.2, -1.)), 0, 1e-10);
  EXPECT_NEAR(line.distortion[0], 0.1, 1e-10);
  EXPECT_LT(line.residual[0], 1e-10);
  EXPECT_THROW(fit_sine(x, rate, 120, 5), std::invalid_argument);
}

// Steps that dwell: one line each, from the settled half.
TEST(SineTracking, takes_one_line_per_step) {
  const double rate = 2000, fn = 40, zeta = 0.02, dwell = 3;
  const Index each = Index(dwell * rate);
  const std::vector<double> steps{30, 34, 37, 39, 40, 41, 43, 46, 50};
  MatrixXd x(each * Index(steps.size()), 2);
  double phase = 0;
  for (Index i = 0; i < x.rows(); ++i) {
    const double f = steps[std::size_t(i / each)], r = f / fn;
    const std::complex<double> h = 1. / std::complex<double>(1 - r * r, 2 * zeta * r);
    phase += two_pi * f / rate;
    const double settled = 1 - std::exp(-two_pi * zeta * fn * double(i % each) / rate);
    x(i, 0) = 2 * std::cos(phase);
    x(i, 1) = 2 * settled * (h * std::polar(1., phase)).real();
  }
  const auto lines = track_sine(x, rate, 0, {.harmonics = 2});
  ASSERT_EQ(lines.size(), steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double r = steps[k] / fn;
    const std::complex<double> h = 1. / std::complex<double>(1 - r * r, 2 * zeta * r);
    EXPECT_NEAR(lines[k].hertz / steps[k], 1, 1e-4);
    EXPECT_NEAR(std::abs(lines[k].amplitude(0, 1) / lines[k].amplitude(0, 0) / h), 1, 0.01) << k;
    EXPECT_EQ(lines[k].sweep_rate, 0);
  }
}

// A slow logarithmic sweep through a linear oscillator with a second harmonic of 5 % added to its
// response: the fundamental is the frequency response, the harmonic its 5 %.
TEST(SineTracking, follows_a_sweep) {
  const double rate = 4000, seconds = 120, f0 = 10, f1 = 100, fn = 40, zeta = 0.05;
  const Index n = Index(seconds * rate);
  MatrixXd x(n, 2);
  const double k = std::log(f1 / f0) / seconds;
  const auto response = [&](double f) {
    const double r = f / fn;
    return 1. / std::complex<double>(1 - r * r, 2 * zeta * r);
  };
  for (Index i = 0; i < n; ++i) {
    const double t = double(i) / rate, f = f0 * std::exp(k * t);
    const double phase = two_pi * f0 * std::expm1(k * t) / k;
    const std::complex<double> h = response(f); // quasi-stationary
    x(i, 0) = 3 * std::cos(phase);
    x(i, 1) = (3. * h * std::polar(1., phase)).real() + 0.15 * std::abs(h) * std::cos(2 * phase);
  }
  const auto lines = track_sine(x, rate, 0, {.harmonics = 3, .cycles = 12, .low = 15, .high = 80});
  ASSERT_GT(lines.size(), 390U);
  for (const SineLine& line : lines) {
    const std::complex<double> h = line.amplitude(0, 1) / line.amplitude(0, 0);
    EXPECT_NEAR(std::abs(h / response(line.hertz)), 1, 0.01) << line.hertz;
    EXPECT_NEAR(line.distortion[1], 0.05, 0.002) << line.hertz;
    EXPECT_LT(line.distortion[0], 0.002);
  }
  EXPECT_THROW(track_sine(x, rate, 2, {}), std::invalid_argument);
}

} // namespace
} // namespace plica
