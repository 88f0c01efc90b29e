// Damping that couples modes, against direct solutions, general eigenvalue solvers and closed
// forms.
#include "model/description/spring_damping.hpp"
#include "solve/dissipation.hpp"
#include "solve/transient_response.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
constexpr Complex imag_unit(0, 1);

// Masses in a row, the first hung to the ground, with springs k_j between them.
struct SpringRow {
  VectorXd m, k; // k[0]: to the ground
  MatrixXd K() const {
    MatrixXd K = MatrixXd::Zero(m.size(), m.size());
    for (Index j = 0; j < k.size(); ++j) K += k[j] * motion(j) * motion(j).transpose();
    return K;
  }
  VectorXd motion(Index spring) const { // of the ends of a spring against each other
    VectorXd t = VectorXd::Zero(m.size());
    t[spring] = 1;
    if (spring > 0) t[spring - 1] = -1;
    return t;
  }
};

SpringRow spring_row(Index n) {
  SpringRow c{VectorXd(n), VectorXd(n)};
  for (Index j = 0; j < n; ++j) {
    c.m[j] = 1 + 0.3 * double(j % 3);
    c.k[j] = 1e4 * (1 + 0.5 * std::sin(1.7 * double(j)));
  }
  return c;
}

// All modes of it; loads: a force on the last mass, then the springs in `damped`.
struct ModesOfRow {
  ModalModel model;
  MatrixXd Phi;
};
ModesOfRow modes_of(const SpringRow& c, double zeta, const std::vector<Index>& damped) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(c.K(), MatrixXd(c.m.asDiagonal()));
  const MatrixXd Phi = eigen.eigenvectors();
  MatrixXd loads(c.m.size(), 1 + Index(damped.size()));
  loads.col(0) = VectorXd::Unit(c.m.size(), c.m.size() - 1);
  for (std::size_t k = 0; k < damped.size(); ++k) loads.col(1 + Index(k)) = c.motion(damped[k]);
  return {{.lambda = eigen.eigenvalues(),
           .zeta = VectorXd::Constant(c.m.size(), zeta),
           .eta = VectorXd::Zero(c.m.size()),
           .output = Phi,
           .input = Phi.transpose() * loads},
          Phi};
}

DampedSpring damped_spring(int column, const SpringDamping& law, double k) {
  return {column, [law, k](Complex s) { return added_stiffness(law, 0, k, s); }};
}

SpringDamping dashpot(double c) {
  SpringDamping d;
  d.dashpot = {c, 0, 0, 0, 0, 0};
  return d;
}

// (K + sum g(i w) t t' + i w C - w^2 M) u = f, with the modal damping as a matrix of its own.
VectorXcd direct_row(const SpringRow& c, const ModesOfRow& m, const Dissipation& d,
                     const MatrixXcd& K_loss, double w) {
  const MatrixXd M = c.m.asDiagonal();
  MatrixXcd A = c.K().cast<Complex>() + K_loss - w * w * M.cast<Complex>();
  const VectorXd viscous = 2 * m.model.zeta.array() * m.model.lambda.array().sqrt();
  A += imag_unit * w * (M * m.Phi * viscous.asDiagonal() * m.Phi.transpose() * M).cast<Complex>();
  for (const DampedSpring& s : d.springs) {
    const VectorXd t = M * m.Phi * m.model.input.col(s.column); // Phi Phi' M = 1
    A += s.added(imag_unit * w) * (t * t.transpose()).cast<Complex>();
  }
  VectorXcd f = VectorXcd::Zero(c.m.size());
  f[c.m.size() - 1] = 1;
  return A.partialPivLu().solve(f);
}

TEST(Dissipation, dashpots_and_springs_over_frequency_meet_the_direct_solution) {
  const SpringRow c = spring_row(6);
  const ModesOfRow m = modes_of(c, 0.01, {0, 2, 5});
  SpringDamping maxwell, fractional;
  maxwell.maxwell = {{0.6, 0.02}, {0.3, 0.001}};
  fractional.springpot = Springpot{0.004, 0.4};
  const Dissipation d{{},
                      {damped_spring(1, dashpot(30), c.k[0]), damped_spring(2, maxwell, c.k[2]),
                       damped_spring(3, fractional, c.k[5])},
                      {},
                      {}};
  const DissipativeResponse response(m.model, d);
  const VectorXd omega = VectorXd::LinSpaced(40, 5, 260);
  const MatrixXcd u = response({{0, 1}}, omega);
  for (Index f = 0; f < omega.size(); ++f) {
    const VectorXcd exact = direct_row(c, m, d, MatrixXcd::Zero(6, 6), omega[f]);
    EXPECT_LT((u.row(f).transpose() - exact).norm(), 1e-11 * exact.norm()) << omega[f];
  }
}

TEST(Dissipation, unequal_loss_of_parts_couples_the_modes_as_complex_stiffness_does) {
  const SpringRow c = spring_row(6);
  const ModesOfRow m = modes_of(c, 0.02, {1});
  MatrixXd K_loss = MatrixXd::Zero(6, 6); // the upper half is rubber
  for (Index j = 3; j < 6; ++j) K_loss += 0.3 * c.k[j] * c.motion(j) * c.motion(j).transpose();
  Dissipation d{
      m.Phi.transpose() * K_loss * m.Phi, {damped_spring(1, dashpot(12), c.k[1])}, {}, {}};
  const VectorXd omega = VectorXd::LinSpaced(40, 5, 260);
  for (int springs : {0, 1}) {
    if (springs == 0) d.springs.clear();
    const MatrixXcd u = DissipativeResponse(m.model, d)({{0, Complex(0.6, 0.8)}}, omega);
    for (Index f = 0; f < omega.size(); ++f) {
      const VectorXcd exact =
          Complex(0.6, 0.8) * direct_row(c, m, d, imag_unit * K_loss.cast<Complex>(), omega[f]);
      EXPECT_LT((u.row(f).transpose() - exact).norm(), 1e-10 * exact.norm()) << omega[f];
    }
    d.springs = {damped_spring(1, dashpot(12), c.k[1])};
  }
}

// The same poles from M, C and K in the coordinates of the masses, as a generalised problem.
TEST(ComplexModes, dashpots_meet_a_general_eigenvalue_solver) {
  const Index n = 8;
  const SpringRow c = spring_row(n);
  const ModesOfRow m = modes_of(c, 0, {0, 3, 7});
  const std::vector<double> coefficients{40, 9, 25};
  MatrixXd C = MatrixXd::Zero(n, n);
  Dissipation d;
  for (std::size_t k = 0; k < 3; ++k) {
    const VectorXd t = c.motion(std::vector<Index>{0, 3, 7}[k]);
    C += coefficients[k] * t * t.transpose();
    d.springs.push_back(damped_spring(int(k) + 1, dashpot(coefficients[k]), 1));
  }
  MatrixXd A = MatrixXd::Zero(2 * n, 2 * n), B = MatrixXd::Identity(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -c.K();
  A.bottomRightCorner(n, n) = -C;
  B.bottomRightCorner(n, n) = c.m.asDiagonal();
  const Eigen::GeneralizedEigenSolver<MatrixXd> eigen(A, B);
  std::vector<Complex> poles;
  for (const Complex s : eigen.eigenvalues())
    if (s.imag() > 0) poles.push_back(s);
  std::sort(poles.begin(), poles.end(),
            [](Complex a, Complex b) { return std::abs(a) < std::abs(b); });
  const ComplexModes found = complex_modes(m.model, d, int(n));
  ASSERT_TRUE(found.complete) << found.reason;
  ASSERT_EQ(found.modes.size(), poles.size());
  for (std::size_t j = 0; j < poles.size(); ++j) {
    EXPECT_LT(std::abs(found.modes[j].s - poles[j]), 1e-9 * std::abs(poles[j])) << j;
    EXPECT_LT(found.modes[j].residual, 1e-10);
  }
}

// A supported beam with a dashpot in the middle (Higham, Mackey, Tisseur and Garvey, Int. J. Numer.
// Meth. Engng 73 (2008) 344-360: half of the eigenvalues are imaginary and those of the beam
// without it). The others solve 1 + c s G = 0 with the receptance of the continuous beam at its
// middle, G = (tan z - tanh z) / (4 EI beta^3), z = beta L / 2, beta^4 = -m s^2 / EI. 120 modes
// leave 1e-6.
TEST(ComplexModes, of_a_beam_with_a_dashpot_in_the_middle) {
  constexpr Index n = 120;
  constexpr double L = 1, EI = 36.46, m = 0.674, c = 5; // aluminium, 50 mm x 5 mm
  ModalModel beam{.lambda = VectorXd(n),
                  .zeta = VectorXd::Zero(n),
                  .eta = VectorXd::Zero(n),
                  .output = MatrixXd(1, n),
                  .input = MatrixXd(n, 1)};
  for (Index j = 0; j < n; ++j) {
    const double k = double(j + 1) * std::numbers::pi / L;
    beam.lambda[j] = std::pow(k, 4) * EI / m;
    beam.input(j, 0) = j % 2 == 0 ? std::sqrt(2 / (m * L)) * (j % 4 == 0 ? 1 : -1) : 0;
  }
  beam.output = beam.input.transpose();
  const auto unbalanced = [&](Complex s) {
    const Complex beta = std::pow(-m * s * s / EI, 0.25), z = beta * L / 2.;
    return 1. + c * s * (std::tan(z) - std::tanh(z)) / (4 * EI * beta * beta * beta);
  };
  const ComplexModes found =
      complex_modes(beam, {{}, {damped_spring(0, dashpot(c), 0)}, {}, {}}, 8);
  ASSERT_TRUE(found.complete) << found.reason;
  ASSERT_GE(found.modes.size(), 8U);
  for (std::size_t j = 0; j < 8; ++j) {
    const Complex s = found.modes[j].s;
    if (j % 2 == 1) {
      EXPECT_LT(std::abs(s - imag_unit * std::sqrt(beam.lambda[Index(j)])), 1e-9 * std::abs(s));
      continue;
    }
    Complex x = s * 1.001, before = s * 1.002; // by the secant
    for (int i = 0; i < 30 && std::abs(x - before) > 1e-13 * std::abs(x); ++i) {
      const Complex f = unbalanced(x), g = unbalanced(before);
      before = std::exchange(x, x - f * (x - before) / (f - g));
    }
    EXPECT_LT(std::abs(s - x), 1e-6 * std::abs(x)) << j;
    EXPECT_LT(x.real(), -0.1) << j;
  }
}

// One mass: m s^2 + k + g(s) = 0.
ModalModel one_mass(double m, double k) {
  return {.lambda = VectorXd::Constant(1, k / m),
          .zeta = VectorXd::Zero(1),
          .eta = VectorXd::Zero(1),
          .output = MatrixXd::Identity(1, 1),
          .input = MatrixXd::Constant(1, 1, 1 / std::sqrt(m))};
}

// Roots of a0 + a1 x + ... by the companion matrix.
VectorXcd roots_of(const std::vector<double>& a) {
  const auto n = Index(a.size()) - 1;
  MatrixXd companion = MatrixXd::Zero(n, n);
  for (Index j = 0; j < n; ++j) {
    if (j > 0) companion(j, j - 1) = 1;
    companion(j, n - 1) = -a[std::size_t(j)] / a.back();
  }
  return companion.eigenvalues();
}

// With the half derivative and p = sqrt(s): m p^4 + k sqrt(tau) p + k = 0.
TEST(ComplexModes, fractional_kelvin_voigt_of_order_one_half_is_a_quartic) {
  constexpr double m = 2, k = 5e4, tau = 2e-4;
  SpringDamping law;
  law.springpot = Springpot{tau, 0.5};
  const ComplexModes found =
      complex_modes(one_mass(m, k), {{}, {damped_spring(0, law, k)}, {}, {}}, 1);
  ASSERT_TRUE(found.complete) << found.reason;
  double nearest = 1e300;
  for (const Complex p : roots_of({k, k * std::sqrt(tau), 0, 0, m}))
    if (p.real() > 0) nearest = std::min(nearest, std::abs(p * p - found.modes[0].s));
  EXPECT_LT(nearest, 1e-9 * std::abs(found.modes[0].s));
  EXPECT_GT(-found.modes[0].s.real() / std::abs(found.modes[0].s), 0.05);
}

// Zener's solid: m s^2 (1 + s tau) + k (1 + s tau) + g k s tau = 0.
TEST(ComplexModes, maxwell_branch_is_a_cubic) {
  constexpr double m = 1.5, k = 8e3, tau = 0.01, g = 0.8;
  SpringDamping law;
  law.maxwell = {{g, tau}};
  const ComplexModes found =
      complex_modes(one_mass(m, k), {{}, {damped_spring(0, law, k)}, {}, {}}, 1);
  ASSERT_TRUE(found.complete) << found.reason;
  double nearest = 1e300;
  for (const Complex s : roots_of({k, k * tau * (1 + g), m, m * tau}))
    nearest = std::min(nearest, std::abs(s - found.modes[0].s));
  EXPECT_LT(nearest, 1e-9 * std::abs(found.modes[0].s));
}

TEST(ComplexModes, what_creeps_is_counted_and_not_called_a_mode) {
  constexpr double m = 1, k = 100; // critical: 2 sqrt(k m) = 20
  const ComplexModes found =
      complex_modes(one_mass(m, k), {{}, {damped_spring(0, dashpot(30), k)}, {}, {}}, 1);
  EXPECT_TRUE(found.modes.empty());
  EXPECT_EQ(found.oscillating, 0);
  EXPECT_EQ(found.overdamped, 1);
  const ComplexModes below =
      complex_modes(one_mass(m, k), {{}, {damped_spring(0, dashpot(12), k)}, {}, {}}, 1);
  ASSERT_TRUE(below.complete);
  EXPECT_NEAR(-below.modes[0].s.real() / std::abs(below.modes[0].s), 0.6, 1e-12);
}

TEST(SpringDamping, laws_at_a_frequency) {
  const double w = 2 * std::numbers::pi * 25;
  SpringDamping d;
  d.loss_factor = 0.2;
  EXPECT_EQ(added_stiffness(d, 1, 1000, imag_unit * w), Complex(0, 200));
  d = dashpot(7);
  EXPECT_NEAR(std::abs(added_stiffness(d, 0, 1000, imag_unit * w) - 7. * imag_unit * w), 0, 1e-12);
  EXPECT_EQ(added_stiffness(d, 1, 1000, imag_unit * w), Complex(0)) << "along another axis";
  d = {};
  d.table = {{{10, 1, 0.1}, {40, 2, 0.3}}};
  const Complex half = 1000. * (1.5 * Complex(1, 0.2) - 1.);
  EXPECT_LT(std::abs(added_stiffness(d, 0, 1000, imag_unit * w) - half), 1e-9);
  EXPECT_LT(std::abs(added_stiffness(d, 0, 1000, imag_unit * 1.) - 1000. * Complex(0, 0.1)), 1e-9);
  d = {};
  d.maxwell = {{0.5, 1e6}}; // hardly relaxes: a spring of half the stiffness beside
  EXPECT_LT(std::abs(added_stiffness(d, 0, 1000, imag_unit * w) - 500.), 1e-4);
}

// Sixty modes, twenty channels, as on a line up to 500 Hz (bench/bench_line.cpp).
ModalModel many_modes() {
  ModalModel m{VectorXd(60), VectorXd::Constant(60, 0.01), VectorXd::Zero(60), MatrixXd(20, 60),
               MatrixXd(60, 1)};
  for (Index j = 0; j < 60; ++j) {
    m.lambda[j] = std::pow(2 * std::numbers::pi * (8 + 9. * double(j)), 2);
    m.input(j, 0) = std::sin(1.3 * double(j));
    for (Index c = 0; c < 20; ++c) m.output(c, j) = std::cos(0.7 * double(j * c + 1));
  }
  return m;
}

double best_seconds(int times, const std::function<void()>& work) {
  double best = 1e9;
  for (int i = 0; i < times; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

TEST(LineSpeedSlow, complex_stiffness_takes_fifty_milliseconds) {
  const ModalModel m = many_modes();
  MatrixXd B(60, 30);
  for (Index i = 0; i < 60; ++i)
    for (Index k = 0; k < 30; ++k) B(i, k) = std::sin(2.1 * double(i * k + i + k));
  const VectorXd w = m.lambda.cwiseSqrt();
  Dissipation coupled;
  coupled.loss = 0.01 * w.asDiagonal() * (B * B.transpose()) * w.asDiagonal();
  const VectorXd omega = 2 * std::numbers::pi * VectorXd::LinSpaced(4901, 10, 500);
  EXPECT_LT(
      best_seconds(20,
                   [&] {
                     ASSERT_TRUE(DissipativeResponse(m, coupled)({{0, 1}}, omega).allFinite());
                   }),
      0.05);
}

TEST(LineSpeedSlow, a_transient_of_100_seconds_at_5_kilohertz_takes_one) {
  const ModalModel m = many_modes();
  MatrixXd signal(500'000, 1);
  for (Index i = 0; i < signal.rows(); ++i) signal(i, 0) = std::sin(0.37 * double(i % 7919));
  EXPECT_LT(
      best_seconds(3, [&] { ASSERT_TRUE(transient_acceleration(m, signal, 2e-4).allFinite()); }),
      1.);
}

} // namespace
} // namespace plica
