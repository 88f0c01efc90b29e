// Identification of modes: peak picking, circle fit, pLSCF, least squares on the responses; and the
// numbers that compare shapes.
#include "lab/identification/circle_fit.hpp"
#include "lab/identification/identify.hpp"
#include "lab/identification/modal_fit.hpp"
#include "lab/identification/mode_correlation.hpp"
#include "lab/identification/peak_picking.hpp"
#include "lab/identification/stabilisation.hpp"
#include "tests/synthetic_frf.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <tuple>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;
constexpr double two_pi = 2 * std::numbers::pi;

using test::add_noise;
using test::four_dof;
using test::synthetic;
using test::TrueMode;

// Error of (f2 - f1) / (2 f_peak) of a receptance: |H|^2 = 1 / ((1 - r^2)^2 + (2 z r)^2) is half
// its largest at r^2 = 1 - 2 z^2 -+ 2 z sqrt(1 - z^2).
double half_power_bias(double z) {
  const double middle = 1 - 2 * z * z, half = 2 * z * std::sqrt(1 - z * z);
  return (std::sqrt(middle + half) - std::sqrt(middle - half)) / (2 * std::sqrt(middle)) / z - 1;
}

// In closed form, and as the table of percents in peak_picking.hpp says.
TEST(PeakPicking, has_the_bias_of_the_formula) {
  for (const auto& [zeta, percent, digit] :
       {std::tuple{0.01, 0.02, 0.006}, {0.05, 0.50, 0.006}, {0.1, 2.1, 0.06}, {0.2, 9.1, 0.06}}) {
    const FrfSet set =
        synthetic({{40, zeta, VectorXd::Ones(1)}}, FrfQuantity::receptance, 10, 80, 20001, 1);
    const auto peaks = pick_peaks(set.hertz, set.H[0].col(0).cwiseAbs());
    ASSERT_EQ(peaks.size(), 1U);
    EXPECT_NEAR(peaks[0].frequency, 40 * std::sqrt(1 - 2 * zeta * zeta), 1e-4);
    EXPECT_NEAR(peaks[0].damping / zeta - 1, half_power_bias(zeta), 1e-4);
    EXPECT_NEAR(100 * (peaks[0].damping / zeta - 1), percent, digit + 0.01);
  }
}

TEST(PeakPicking, passes_over_ripples) {
  FrfSet set = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 2000, 1);
  add_noise(set, 0.02, 1);
  const auto peaks = pick_peaks(set.hertz, set.H[0].rowwise().norm(), 1.4, 0.05);
  EXPECT_EQ(peaks.size(), 4U);
}

TEST(CircleFit, is_exact_on_its_own_models) {
  const double wn = two_pi * 40, A = 3;
  const VectorXd hertz = VectorXd::LinSpaced(21, 38.5, 41.2);
  for (const DampingModel model : {DampingModel::viscous, DampingModel::structural}) {
    const bool viscous = model == DampingModel::viscous;
    VectorXcd values(hertz.size());
    for (Index f = 0; f < hertz.size(); ++f) {
      const double w = two_pi * hertz[f];
      const Complex below = viscous ? Complex(wn * wn - w * w, 2 * 0.02 * wn * w)
                                    : Complex(wn * wn - w * w, 0.04 * wn * wn);
      values[f] = (viscous ? Complex(0, w) : Complex(1, 0)) * A / below;
      values[f] += Complex(0.2, -0.1) * A / (wn * wn); // other modes
    }
    const CircleFit fit =
        fit_circle(hertz, values, viscous ? FrfQuantity::mobility : FrfQuantity::receptance, model);
    ASSERT_TRUE(fit.good) << fit.reason;
    EXPECT_NEAR(fit.frequency / 40, 1, 1e-10);
    EXPECT_NEAR(fit.damping / 0.02, 1, 1e-9);
    EXPECT_NEAR(std::abs(fit.residue - A), 0, 1e-8);
    EXPECT_NEAR(2 * fit.radius / (viscous ? A / (2 * 0.02 * wn) : A / (0.04 * wn * wn)), 1, 1e-10);
    EXPECT_LT(fit.misfit, 1e-10);
  }
  EXPECT_FALSE(
      fit_circle(hertz.head(4), VectorXcd::Ones(4), FrfQuantity::mobility, DampingModel::viscous)
          .good);
  EXPECT_FALSE(
      fit_circle(hertz, VectorXcd::Ones(21), FrfQuantity::mobility, DampingModel::viscous).good);
}

std::vector<Complex> found_poles(const FrfSet& set, int highest) {
  std::vector<Complex> poles;
  for (const StableGroup& g : stable_groups(stabilisation(lscf(set, highest))))
    poles.push_back(g.pole.lambda);
  return poles;
}

// Noise-free: frequencies to 1e-8, damping to 1e-6; with 1 % noise to 0.05 % and 5 %.
TEST(Lscf, finds_four_degrees_of_freedom) {
  for (const int references : {1, 2}) {
    for (const double noise : {0., 0.01}) {
      FrfSet set = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 1301, references);
      if (noise > 0) add_noise(set, noise, 3);
      const std::vector<Complex> poles = found_poles(set, references == 1 ? 30 : 20);
      ASSERT_EQ(poles.size(), 4U) << references << " references, noise " << noise;
      const ModalFit fit = fit_modes(set, poles);
      EXPECT_TRUE(fit.converged);
      for (std::size_t r = 0; r < 4; ++r) {
        const TrueMode m = four_dof()[r];
        EXPECT_NEAR(fit.modes[r].frequency() / m.frequency, 1, noise > 0 ? 5e-4 : 1e-8);
        EXPECT_NEAR(fit.modes[r].damping() / m.damping, 1, noise > 0 ? 0.05 : 1e-6);
        EXPECT_GT(mac(fit.modes[r].residue.col(0), m.shape.cast<Complex>()),
                  noise > 0 ? 0.999 : 1 - 1e-9);
      }
    }
  }
}

// pLSCF alone, without the fit that follows.
TEST(Lscf, alone_is_close) {
  const FrfSet set = synthetic(four_dof(), FrfQuantity::receptance, 5, 70, 1301, 2);
  const std::vector<Complex> poles = found_poles(set, 20);
  ASSERT_EQ(poles.size(), 4U);
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_NEAR(std::abs(poles[r]) / two_pi / four_dof()[r].frequency, 1, 1e-5);
    EXPECT_NEAR(-poles[r].real() / std::abs(poles[r]) / four_dof()[r].damping, 1, 1e-2);
  }
}

// A band without a mode, and noise alone: no mode, and it says so.
TEST(Identify, finds_nothing_where_nothing_is) {
  FrfSet noise = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 600, 1);
  for (MatrixXcd& H : noise.H) H.setZero();
  add_noise(noise, 0, 1);
  noise.H[0].setConstant({1, -0.5});
  EXPECT_TRUE(identify(noise, {}).modes.empty());
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 1);
  for (Index k = 0; k < noise.H[0].size(); ++k)
    noise.H[0].data()[k] = {normal(random), normal(random)};
  const Identification found = identify(noise, {});
  EXPECT_TRUE(found.modes.empty());
  EXPECT_FALSE(found.warnings.empty());
  const FrfSet between = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 1301, 1);
  for (const IdentifiedMode& mode : identify(between, {.low = 16, .high = 22}).modes) {
    EXPECT_GE(mode.frequency, 16);
    EXPECT_LE(mode.frequency, 22);
  }
}

// Two modes 1 % apart at 0.3 % damping, 1 % noise, two references.
TEST(Lscf, separates_a_close_pair) {
  const std::vector<TrueMode> modes{{100, 0.003, (VectorXd(4) << 1, 0.3, 0.8, -0.5).finished()},
                                    {101, 0.003, (VectorXd(4) << -0.2, 1, 0.5, 0.9).finished()}};
  FrfSet set = synthetic(modes, FrfQuantity::accelerance, 80, 120, 1601, 2);
  add_noise(set, 0.01, 5);
  const std::vector<Complex> poles = found_poles(set, 20);
  ASSERT_EQ(poles.size(), 2U);
  const ModalFit fit = fit_modes(set, poles);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_NEAR(fit.modes[r].frequency() / modes[r].frequency, 1, 5e-4);
    EXPECT_NEAR(fit.modes[r].damping() / 0.003, 1, 0.05);
    const Eigen::JacobiSVD<MatrixXcd> svd(fit.modes[r].residue, Eigen::ComputeThinU);
    EXPECT_GT(mac(svd.matrixU().col(0), modes[r].shape.cast<Complex>()), 0.99);
  }
}

// The stated standard deviations are those of a hundred trials, within 25 %.
TEST(ModalFit, states_its_own_scatter) {
  const std::vector<TrueMode> modes = four_dof();
  std::vector<Complex> start;
  for (const TrueMode& m : modes) {
    const double w = two_pi * m.frequency;
    start.emplace_back(-m.damping * w, w * std::sqrt(1 - m.damping * m.damping));
  }
  const int trials = 100;
  MatrixXd f(trials, 4), z(trials, 4), sf(trials, 4), sz(trials, 4);
  for (int t = 0; t < trials; ++t) {
    FrfSet set = synthetic(modes, FrfQuantity::accelerance, 5, 70, 400, 1);
    add_noise(set, 0.02, 1000 + unsigned(t));
    const ModalFit fit = fit_modes(set, start);
    for (int r = 0; r < 4; ++r) {
      f(t, r) = fit.modes[r].frequency();
      z(t, r) = fit.modes[r].damping();
      sf(t, r) = fit.modes[r].sigma_frequency();
      sz(t, r) = fit.modes[r].sigma_damping();
    }
  }
  for (int r = 0; r < 4; ++r) {
    const auto deviation = [](const VectorXd& x) {
      return std::sqrt((x.array() - x.mean()).square().sum() / double(x.size() - 1));
    };
    EXPECT_NEAR(deviation(f.col(r)) / sf.col(r).mean(), 1, 0.25) << r;
    EXPECT_NEAR(deviation(z.col(r)) / sz.col(r).mean(), 1, 0.25) << r;
    EXPECT_LT(std::abs(f.col(r).mean() - modes[r].frequency), 0.4 * sf.col(r).mean());
  }
}

// A fourth mode at 58 Hz that the band cuts through, or that lies beyond it: 2.5 of the deviations
// that the lines alone give.
TEST(Identify, knows_what_a_missed_mode_at_the_end_of_the_band_does) {
  const std::vector<TrueMode> modes = four_dof();
  for (const double end : {54., 56., 57.5, 58., 58.5}) {
    const Identification found =
        identify(synthetic(modes, FrfQuantity::accelerance, 5, end, 800, 1), {});
    ASSERT_EQ(found.modes.size(), 3U) << end;
    for (std::size_t r = 0; r < 3; ++r) {
      const IdentifiedMode& m = found.modes[r];
      EXPECT_LT(std::abs(m.frequency - modes[r].frequency), 2 * m.sigma_frequency) << end;
      EXPECT_LT(std::abs(m.damping - modes[r].damping), 2 * m.sigma_damping) << end;
    }
  }
}

// Where nothing is missed, the ends of the band add little: a hundred trials, within 25 %.
TEST(Identify, states_its_own_scatter) {
  const std::vector<TrueMode> modes = four_dof();
  constexpr int trials = 100;
  MatrixXd f(trials, 4), z(trials, 4);
  VectorXd stated_f = VectorXd::Zero(4), stated_z = stated_f;
  for (int t = 0; t < trials; ++t) {
    FrfSet set = synthetic(modes, FrfQuantity::accelerance, 5, 70, 400, 1);
    add_noise(set, 0.02, 3000 + unsigned(t));
    const Identification found = identify(set, {});
    ASSERT_EQ(found.modes.size(), 4U) << t;
    for (int r = 0; r < 4; ++r) {
      const IdentifiedMode& m = found.modes[std::size_t(r)];
      f(t, r) = m.frequency;
      z(t, r) = m.damping;
      stated_f[r] += m.sigma_frequency / trials;
      stated_z[r] += m.sigma_damping / trials;
    }
  }
  for (int r = 0; r < 4; ++r) {
    const auto deviation = [](const VectorXd& x) {
      return std::sqrt((x.array() - x.mean()).square().sum() / double(x.size() - 1));
    };
    EXPECT_NEAR(deviation(f.col(r)) / stated_f[r], 1, 0.25) << r;
    EXPECT_NEAR(deviation(z.col(r)) / stated_z[r], 1, 0.25) << r;
  }
}

TEST(ModeCorrelation, follows_its_definitions) {
  VectorXcd a(3), b(3);
  a << 1, Complex(0, 2), -1;
  b << 2, 1, Complex(1, 1);
  // a'b = 2 - 2i - 1 - i = 1 - 3i, |.|^2 = 10; a'a = 6, b'b = 7.
  EXPECT_NEAR(mac(a, b), 10. / 42, 1e-14);
  EXPECT_NEAR(mac(a, Complex(3, -4) * a), 1, 1e-14);
  EXPECT_EQ(mac(a, VectorXcd::Zero(3)), 0);
  MatrixXcd A(3, 2), B(3, 2);
  A << a, b;
  B << b, a;
  const MatrixXd M = mac_matrix(A, A);
  EXPECT_NEAR(M(0, 1), M(1, 0), 1e-15);
  EXPECT_NEAR(M(0, 0), 1, 1e-15);
  // Channel 1: |1 2| + |2 1| = 4 over (1 + 4)(4 + 1).
  EXPECT_NEAR(comac(A, B)[0], 16. / 25, 1e-14);
  EXPECT_NEAR(comac(A, A).minCoeff(), 1, 1e-14);
  EXPECT_NEAR(frac(A, B)[0], 10. / 42, 1e-14);
  // Line 1: channels (1, 2) against (2, 1): 16 / 25; CSF 2 * 4 / 10.
  EXPECT_NEAR(csac(A, B)[0], 16. / 25, 1e-14);
  EXPECT_NEAR(csf(A, B)[0], 0.8, 1e-14);
  EXPECT_NEAR(csac(A, 2 * A).minCoeff(), 1, 1e-14);
  EXPECT_NEAR(csf(A, 2 * A)[0], 0.8, 1e-14); // sees the size
}

TEST(ModeCorrelation, knows_how_real_a_shape_is) {
  VectorXcd real(3);
  real << 1, -2, 0.5;
  EXPECT_NEAR(phase_collinearity(std::polar(3., 1.1) * real), 1, 1e-14);
  const VectorXcd turned = turned_real(std::polar(3., 1.1) * real);
  EXPECT_LT(turned.imag().norm(), 1e-12);
  EXPECT_GT(turned[1].real(), 0); // the largest is positive
  VectorXcd round(2);
  round << 1, Complex(0, 1);
  EXPECT_NEAR(phase_collinearity(round), 0, 1e-14); // a travelling wave
}

} // namespace
} // namespace plica
