// Steady and random response to base motion and to forces: static limit, reciprocity, a direct
// solution, and Miles.
#include "tests/support/direct_response.hpp"
#include "tests/support/fields.hpp"

#include "lab/signals/peaks.hpp"
#include "solve/base_motion.hpp"
#include "solve/frequency_grid.hpp"
#include "solve/frequency_response.hpp"
#include "solve/random_response.hpp"
#include "solve/statics.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace plica::test {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

// A bent cantilever plate of steel, held along one edge; free DOFs apart from the held ones.
struct Rig {
  Model model;
  System system;
  std::vector<int> free;
  SparseMatrix K, M;
  BaseMotion base;
  std::vector<int> tips; // four DOFs among the free ones: ux uy uz at one corner, uz at the other
};

Rig bent_plate() {
  const ParametricSurface sheet = [](double a, double b) {
    const double angle = 1.2 * a;
    const Vector3d n(std::sin(angle), 0, std::cos(angle));
    return SurfacePoint{0.2 * n + 0.15 * b * Vector3d::UnitY(), n};
  };
  Rig rig;
  rig.model = shell_model(mesh_surface(sheet, 12, 8, 2e-3), {.E = 210e9, .nu = 0.3, .rho = 7850});
  rig.system = assemble(rig.model);
  std::vector<int> held;
  for (int node : rig.model.mesh.sets["a0"])
    for (int dof = 0; dof < 6; ++dof) held.push_back(rig.system.map.independent[6 * node + dof]);
  std::sort(held.begin(), held.end());
  rig.free = complement(rig.system.map.size(), held);
  rig.K = restrict_to(rig.system.K, rig.free);
  rig.M = restrict_to(rig.system.M, rig.free);
  rig.base = base_motion(rig.model, rig.system, rig.free, {0, 0, 0});
  const auto number = [&](const Vector3d& at, int dof) {
    const int all = rig.system.map.independent[6 * node_at(rig.model.mesh, at) + dof];
    return int(std::lower_bound(rig.free.begin(), rig.free.end(), all) - rig.free.begin());
  };
  const Vector3d tip = sheet(1, 0).position, other = sheet(1, 1).position;
  for (int dof : {0, 1, 2}) rig.tips.push_back(number(tip, dof));
  rig.tips.push_back(number(other, 2));
  return rig;
}

MatrixXd static_solution(const Rig& rig, const MatrixXd& force) {
  SparseFactor factor(rig.K);
  EXPECT_TRUE(factor.factorise(rig.K).ok);
  return factor.solve(force);
}

// `corrected`: with residual vectors of the loads.
ModalModel modal_model(const Rig& rig, int modes, const MatrixXd& force, double eta,
                       bool corrected = true) {
  BaseFactor factor = factor_below_spectrum(rig.K, rig.M);
  const ModeSet set = plica::find_modes(rig.K, rig.M, {.count = modes}, factor);
  EXPECT_TRUE(set.proof.passed);
  const MatrixXd X = corrected ? static_solution(rig, force) : MatrixXd(rig.K.rows(), 0);
  const ModalBasis basis = add_static_correction(rig.K, rig.M, set.lambda, set.Phi, X);
  const auto count = basis.lambda.size();
  return {.lambda = basis.lambda,
          .zeta = VectorXd::Zero(count),
          .eta = VectorXd::Constant(count, eta),
          .output = basis.Phi(rig.tips, Eigen::all),
          .input = basis.Phi.transpose() * force};
}

TEST(StaticCorrection, makes_the_limit_of_low_frequency_exact) {
  const Rig rig = bent_plate();
  const MatrixXd force = rig.base.force;
  const MatrixXd exact = static_solution(rig, force)(rig.tips, Eigen::all);
  const ModalModel with = modal_model(rig, 8, force, 0),
                   without = modal_model(rig, 8, force, 0, false);
  const VectorXd slow = VectorXd::Constant(1, 1e-4); // rad/s
  double truncation = 0;
  for (int direction = 0; direction < 6; ++direction) {
    const double largest = exact.col(direction).cwiseAbs().maxCoeff();
    const auto error = [&](const ModalModel& m) {
      return (frequency_response(m, direction, slow).row(0).transpose() - exact.col(direction))
                 .cwiseAbs()
                 .maxCoeff() /
             largest;
    };
    EXPECT_LT(error(with), 1e-10) << direction;
    truncation = std::max(truncation, error(without));
  }
  EXPECT_GT(truncation, 1e-3) << "eight modes alone must show their truncation";
}

TEST(StaticCorrection, keeps_the_basis_orthogonal_and_drops_what_the_modes_hold) {
  const Rig rig = bent_plate();
  BaseFactor factor = factor_below_spectrum(rig.K, rig.M);
  const ModeSet set = plica::find_modes(rig.K, rig.M, {.count = 6}, factor);
  MatrixXd X(rig.K.rows(), 8);
  X << static_solution(rig, rig.base.force), set.Phi.leftCols(2);
  const ModalBasis basis = add_static_correction(rig.K, rig.M, set.lambda, set.Phi, X);
  EXPECT_EQ(basis.modes, 6);
  EXPECT_EQ(basis.lambda.size(), 12);
  const MatrixXd m = basis.Phi.transpose() * symmetric_product(rig.M, basis.Phi);
  EXPECT_LT((m - MatrixXd::Identity(12, 12)).cwiseAbs().maxCoeff(), 1e-10);
  const MatrixXd k = basis.Phi.transpose() * symmetric_product(rig.K, basis.Phi);
  const MatrixXd diagonal = basis.lambda.asDiagonal();
  EXPECT_LT((k - diagonal).cwiseAbs().maxCoeff(), 1e-8 * basis.lambda.maxCoeff());
}

TEST(FrequencyResponse, is_reciprocal) {
  const Rig rig = bent_plate();
  MatrixXd force = MatrixXd::Zero(rig.K.rows(), 4);
  for (int i = 0; i < 4; ++i) force(rig.tips[i], i) = 1;
  const ModalModel model = modal_model(rig, 10, force, 0.02);
  const VectorXd omega = VectorXd::LinSpaced(50, 10, 6000);
  std::array<MatrixXcd, 4> H;
  for (int load = 0; load < 4; ++load) H[load] = frequency_response(model, load, omega);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < a; ++b)
      EXPECT_LT((H[a].col(b) - H[b].col(a)).norm(), 1e-10 * H[a].col(b).norm());
}

TEST(FrequencyResponse, of_corrected_modes_equals_the_direct_solution) {
  const Rig rig = bent_plate();
  constexpr double eta = 0.03;
  const MatrixXd force = rig.base.force.leftCols<3>();
  const ModalModel model = modal_model(rig, 20, force, eta);
  const double highest = std::sqrt(model.lambda[14]);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.01 * highest, highest);
  VectorXd omega(20);
  for (double& w : omega) w = anywhere(random);
  for (int direction = 0; direction < 3; ++direction) {
    const MatrixXcd modal = frequency_response(model, direction, omega);
    const MatrixXcd direct =
        direct_response(rig.K, rig.M, eta, force.col(direction), omega)(rig.tips, Eigen::all)
            .transpose();
    const VectorXd largest = direct.cwiseAbs().colwise().maxCoeff();
    for (Eigen::Index channel = 0; channel < 4; ++channel)
      EXPECT_LT((modal - direct).col(channel).cwiseAbs().maxCoeff(), 0.005 * largest[channel])
          << "direction " << direction << ", channel " << channel;
  }
}

TEST(BaseMotion, of_a_rigid_body_strains_nothing) {
  const Rig rig = bent_plate();
  const MatrixXd elastic = symmetric_product(rig.system.K, rig.base.r);
  EXPECT_LT(elastic.cwiseAbs().maxCoeff(), 1e-6 * 210e9 * 2e-3);
  // Sum of all inertia forces of free and held = mass.
  const MatrixXd whole = rig.base.r.transpose() * symmetric_product(rig.system.M, rig.base.r);
  const double mass = 7850 * 2e-3 * 0.15 * 0.2 * 1.2;
  EXPECT_NEAR(whole(0, 0) / mass, 1, 1e-3);
}

// One mass on a spring on a shaken base: absolute acceleration per unit base acceleration.
MatrixXcd one_dof(const VectorXd& hertz, double f, double zeta) {
  const double w0 = 2 * pi * f;
  const ModalModel model{.lambda = VectorXd::Constant(1, w0 * w0),
                         .zeta = VectorXd::Constant(1, zeta),
                         .eta = VectorXd::Zero(1),
                         .output = MatrixXd::Ones(1, 1),
                         .input = -MatrixXd::Ones(1, 1)};
  const VectorXd omega = 2 * pi * hertz;
  const MatrixXcd relative = frequency_response(model, 0, omega);
  MatrixXcd absolute = MatrixXcd::Ones(hertz.size(), 1);
  absolute -= omega.cwiseAbs2().asDiagonal() * relative;
  return absolute;
}

// RMS^2 = pi/2 f Q S (1 + 4 zeta^2) for white noise on the base (Miles, J. Aeronaut. Sci. 21 (1954)
// 753-762; the bracket for the damper's path).
TEST(RandomResponse, of_one_dof_is_that_of_miles_on_any_grid) {
  constexpr double f = 100, S = 0.01, high = 1e5;
  for (double zeta : {0.005, 0.02, 0.1}) {
    const double miles =
        std::sqrt(pi / 2 * f / (2 * zeta) * S * (1 + 4 * zeta * zeta)); // up to infinity
    // Above f the response falls to S (2 zeta f / nu)^2: what the band leaves out.
    const double beyond = S * 4 * zeta * zeta * f * f / high;
    double first = 0;
    for (int points : {50, 500, 5000}) {
      const VectorXd hertz =
          frequency_grid(0.01, high, points, VectorXd::Constant(1, f), VectorXd::Constant(1, zeta));
      const SpectralDensity white{{{1e-3, S}, {high, S}}};
      const MatrixXd density = response_density(one_input(white), hertz, {one_dof(hertz, f, zeta)});
      const double value = rms(hertz, density.col(0), 0.01, high);
      EXPECT_NEAR(value / std::sqrt(miles * miles - beyond), 1, 2e-3) << zeta << ", " << points;
      if (first == 0) first = value;
      EXPECT_NEAR(value / first, 1, 1e-3) << zeta << ", " << points;
    }
  }
}

TEST(RandomResponse, input_table_runs_straight_in_a_log_log_plot) {
  const SpectralDensity table{{{10, 1e-3}, {100, 1e-1}, {1000, 1e-1}}};
  EXPECT_NEAR(density_at(table, std::sqrt(1000.)), 1e-2, 1e-14);
  EXPECT_NEAR(density_at(table, 400), 1e-1, 1e-14);
  EXPECT_EQ(density_at(table, 9), 0);
  EXPECT_EQ(density_at(table, 1001), 0);
  const VectorXd hertz = (VectorXd(3) << 10, 100, 1000).finished();
  const VectorXd S = hertz.unaryExpr([&](double f) { return density_at(table, f); });
  const double area = 1e-5 / 3 * (1e6 - 1e3) + 0.1 * 900; // 1e-5 f^2, then constant
  EXPECT_NEAR(rms(hertz, S, 10, 1000) / std::sqrt(area), 1, 1e-12);
  EXPECT_NEAR(rms(hertz, S, 200, 300) / std::sqrt(10.), 1, 1e-12);
}

TEST(RandomResponse, cross_density_of_a_channel_with_itself_is_its_density) {
  const VectorXd hertz = VectorXd::LinSpaced(20, 10, 200);
  MatrixXcd H(20, 2);
  H << one_dof(hertz, 50, 0.05), one_dof(hertz, 120, 0.02);
  const SpectralDensity table{{{10, 1}, {200, 3}}};
  const MatrixXd density = response_density(one_input(table), hertz, {H});
  EXPECT_LT((cross_density(one_input(table), hertz, {H}, 1, 1).real() - density.col(1)).norm(),
            1e-12);
  const auto ab = cross_density(one_input(table), hertz, {H}, 0, 1);
  const VectorXd coherence =
      ab.cwiseAbs2().cwiseQuotient(density.col(0).cwiseProduct(density.col(1)));
  EXPECT_LT((coherence.array() - 1).abs().maxCoeff(), 1e-12) << "one input";
}

TEST(Peaks, half_power_damping_of_light_damping_is_that_of_the_mode) {
  for (double zeta : {0.002, 0.01, 0.03}) {
    const VectorXd hertz =
        frequency_grid(10, 500, 491, VectorXd::Constant(1, 116.3), VectorXd::Constant(1, zeta));
    const auto peaks = find_peaks(hertz, one_dof(hertz, 116.3, zeta).cwiseAbs().col(0));
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_NEAR(peaks[0].damping / zeta, 1, 0.01);
    EXPECT_NEAR(peaks[0].frequency / 116.3, 1, 2 * zeta * zeta + 1e-5);
    EXPECT_NEAR(peaks[0].height * 2 * zeta, 1, 4 * zeta * zeta + 1e-4);
  }
}

TEST(FrequencyGrid, holds_every_eigenfrequency_and_grows) {
  const VectorXd modes = (VectorXd(4) << 5, 112.76, 160.83, 160.83).finished();
  const VectorXd grid = frequency_grid(10, 500, 100, modes, VectorXd::Constant(4, 0.01));
  for (double f : {10., 112.76, 160.83, 500.})
    EXPECT_LT((grid.array() - f).abs().minCoeff(), 1e-9) << f;
  for (Eigen::Index i = 1; i < grid.size(); ++i) ASSERT_GT(grid[i], grid[i - 1]);
  EXPECT_GE(grid.minCoeff(), 10);
}

} // namespace
} // namespace plica::test
