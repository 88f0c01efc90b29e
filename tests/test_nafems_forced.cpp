// NAFEMS forced vibration benchmarks (R0016): tests 5, 13 and 21, harmonic and random.
#include "tests/support/fields.hpp"

#include "elements/beam_section.hpp"
#include "lab/signals/peaks.hpp"
#include "solve/frequency_grid.hpp"
#include "solve/frequency_response.hpp"
#include "solve/oscillator.hpp"
#include "solve/random_response.hpp"
#include "solve/stress.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <numbers>

namespace plica::test {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

// Steady response of a model under a load on all DOFs, 2 % of critical in every mode.
struct Swept {
  Peak peak;
  double stress = 0; // at the peak, Pa: largest of the beams, or sigma_x on top of the node
  double density = 0, stress_density = 0; // at the peak, for an input of (load)^2 per Hz
};

Swept sweep(const Model& model, const VectorXd& load, int dof, double low, double high) {
  const System system = assemble(model);
  BaseFactor factor = factor_below_spectrum(system.K, system.M);
  const VectorXd force = gather(system.map, load), X = factor.factor.solve(MatrixXd(force));
  const ModeSet set = plica::find_modes(system.K, system.M, {.count = 16}, factor);
  const ModalBasis basis = add_static_correction(system.K, system.M, set.lambda, set.Phi, X);
  const auto count = basis.lambda.size();
  const ModalModel modal{.lambda = basis.lambda,
                         .zeta = VectorXd::Constant(count, 0.02),
                         .eta = VectorXd::Zero(count),
                         .output = basis.Phi.row(system.map.independent[dof]),
                         .input = basis.Phi.transpose() * force};
  const VectorXd modes = set.lambda.unaryExpr(&frequency);
  const VectorXd hertz =
      frequency_grid(low, high, 200, modes, VectorXd::Constant(modes.size(), 0.02));
  const MatrixXcd H = frequency_response(modal, 0, 2 * pi * hertz);
  const Peak peak = find_peaks(hertz, H.cwiseAbs().col(0)).front();
  // Stress as one more channel of the modal sum.
  const StressField field = recover_stress(model, expand(system.map, basis.Phi));
  ModalModel stress = modal;
  stress.output = model.beams.empty() ? MatrixXd(field.shell.row(2 * (dof - dof % 6) + 6))
                                      : MatrixXd(field.beam);
  const MatrixXcd S = frequency_response(stress, 0, 2 * pi * hertz);
  const SpectralDensity white{{{low, 1}, {high, 1}}};
  return {.peak = peak,
          .stress = S.cwiseAbs().maxCoeff(),
          .density = response_density(one_input(white), hertz, {H}).maxCoeff(),
          .stress_density = response_density(one_input(white), hertz, {S}).maxCoeff()};
}

// What the first displacement and the stress reach under a load that is suddenly there.
struct Stepped {
  double peak = 0, time = 0, stress = 0, settled = 0; // m, s, Pa; settled: at rest under the load
  VectorXd motion = VectorXd::Zero(2001);
};

// 2 % of critical in 24 modes (NAFEMS asks for sixteen, which cuts a pair of the plate in two) and
// the residual vector; `until` s in steps of 1 / 2000.
Stepped step(const Model& model, const VectorXd& load, int dof, double until) {
  const System system = assemble(model);
  BaseFactor factor = factor_below_spectrum(system.K, system.M);
  const VectorXd force = gather(system.map, load), X = factor.factor.solve(MatrixXd(force));
  const ModeSet set = plica::find_modes(system.K, system.M, {.count = 24}, factor);
  const ModalBasis basis = add_static_correction(system.K, system.M, set.lambda, set.Phi, X);
  const VectorXd f = basis.Phi.transpose() * force;
  const StressField field = recover_stress(model, expand(system.map, basis.Phi));
  const MatrixXd fibres = model.beams.empty() ? MatrixXd(field.shell.row(2 * (dof - dof % 6) + 6))
                                              : MatrixXd(field.beam);
  std::vector<Oscillator> oscillators;
  const double dt = until / 2000;
  for (const double lambda : basis.lambda) oscillators.emplace_back(std::sqrt(lambda), 0.02, dt);
  Stepped found{.settled = X[system.map.independent[dof]]};
  for (int i = 1; i <= 2000; ++i) {
    VectorXd q(f.size());
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      Oscillator& o = oscillators[std::size_t(j)];
      o.step(f[j], f[j]);
      q[j] = o.q();
    }
    const double u = basis.Phi.row(system.map.independent[dof]) * q;
    found.motion[i] = u;
    if (u > found.peak) {
      found.peak = u;
      found.time = i * dt;
    }
    found.stress = std::max(found.stress, (fibres * q).cwiseAbs().maxCoeff());
  }
  return found;
}

// Deep beam of FV5, 1 MN/m, sharp resonance near 42.65 Hz: 13.45 mm, 241.9 MPa; random: 180.90
// mm2/Hz. 2 % on the peak (4 % on its square), 0.5 % on the frequency.
struct LoadedBeam {
  Model model;
  VectorXd load;
  int middle = 0; // uy
};
LoadedBeam deep_beam() {
  Model model;
  constexpr int elements = 20;
  const BeamProperties section = rectangle_section({.E = 200e9, .nu = 0.3, .rho = 8000}, 2, 2);
  for (int i = 0; i <= elements; ++i) model.mesh.nodes.emplace_back(10. * i / elements, 0, 0);
  for (int i = 0; i < elements; ++i)
    model.beams.push_back({.node1 = i, .node2 = i + 1, .section = section});
  add_support(model, {0}, {0, 1, 2, 3}, "A");
  add_support(model, {elements}, {1, 2}, "B");
  VectorXd load = no_force(model);
  for (int i = 0; i <= elements; ++i)
    load[6 * i + 1] = 1e6 * 10 / elements * (i == 0 || i == elements ? 0.5 : 1);
  return {std::move(model), std::move(load), 6 * (elements / 2) + 1};
}

TEST(NafemsForced, deep_beam_5h_and_5r) {
  const LoadedBeam beam = deep_beam();
  const Swept s = sweep(beam.model, beam.load, beam.middle, 10, 80);
  expect_ratio(s.peak.height, 13.45e-3, 0.02, "5H");
  expect_ratio(s.peak.frequency, 42.65, 0.005, "5H");
  expect_ratio(s.stress, 241.9e6, 0.02, "5H");
  expect_ratio(s.density, 180.90e-6, 0.04, "5R");
  expect_ratio(s.stress_density, 58516e12, 0.04, "5R");
}

// 1.043 mm after 0.0117 s, 18.76 MPa, 2 %. At rest NAFEMS prints 0.538 mm; held against 5 q L^4 /
// (384 E I) + q L^2 / (8 k G A) = 0.5361 mm with Cowper's k, 0.5 %.
TEST(NafemsForced, deep_beam_5t) {
  const LoadedBeam beam = deep_beam();
  const Stepped s = step(beam.model, beam.load, beam.middle, 0.02);
  expect_ratio(s.peak, 1.043e-3, 0.02, "5T");
  expect_ratio(s.time, 0.0117, 0.02, "5T");
  expect_ratio(s.stress, 18.76e6, 0.02, "5T");
  expect_ratio(s.settled, 0.5361e-3, 0.005, "5T");
}

struct LoadedPlate {
  Model model;
  VectorXd load;
  int middle = 0; // uz
};
LoadedPlate supported_plate(double thickness, double pressure) {
  const ParametricSurface square = [](double a, double b) {
    return SurfacePoint{{10 * a, 10 * b, 0}, {0, 0, 1}};
  };
  Model model =
      shell_model(mesh_surface(square, 16, 16, thickness), {.E = 200e9, .nu = 0.3, .rho = 8000});
  hold(model, "all", {0, 1, 5});
  for (const char* edge : {"a0", "a1"}) hold(model, edge, {2, 3});
  for (const char* edge : {"b0", "b1"}) hold(model, edge, {2, 4});
  VectorXd load = area_load(model, {0, 0, pressure});
  const int middle = 6 * node_at(model.mesh, {5, 5, 0}) + 2;
  return {std::move(model), std::move(load), middle};
}

Swept swept_plate(double thickness, double pressure, double low, double high) {
  const LoadedPlate plate = supported_plate(thickness, pressure);
  return sweep(plate.model, plate.load, plate.middle, low, high);
}

// Plates of tests 13 and 21 under uniform pressure. NAFEMS prints 30.03 MPa for 13H, a misprint:
// its random twin prints 1025.44 = 32.02^2, and Navier's series gives 32.03.
TEST(NafemsForced, thin_plate_13h_and_13r) {
  const Swept s = swept_plate(0.05, 100, 0.5, 4);
  expect_ratio(s.peak.height, 45.42e-3, 0.02, "13H");
  expect_ratio(s.peak.frequency, 2.377, 0.005, "13H");
  expect_ratio(s.stress, 32.03e6, 0.02, "13H");
  expect_ratio(s.density, 2063.20e-6, 0.04, "13R");
  expect_ratio(s.stress_density, 1025.44e12, 0.04, "13R");
}

// First mode of a simply supported Mindlin plate, w = W sin sin, rotations B cos sin and B sin cos:
// response of the centre to a uniform pressure at its frequency.
double mindlin_resonance(double side, double t, double pressure, double zeta) {
  const double E = 200e9, nu = 0.3, rho = 8000, k = pi / side;
  const double shear = 5. / 6 * E / (2 * (1 + nu)) * t, D = E * t * t * t / (12 * (1 - nu * nu));
  Eigen::Matrix2d K, M;
  K << 2 * shear * k * k, -2 * shear * k, -2 * shear * k, 2 * shear + 4 * D * k * k;
  M << rho * t, 0, 0, rho * t * t * t / 6;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(K, M);
  const double W = modes.eigenvectors()(0, 0), lambda = modes.eigenvalues()[0];
  return W * W * 16 / (pi * pi) * pressure / (2 * zeta * lambda);
}

// NAFEMS prints 58.33 mm and 3401.81 mm2/Hz; 58.33 lies 2.7 % below the closed form of Mindlin's
// plate (for the thin plate it meets it to 0.1 %), and another program's first-order quads
// give 60.05 mm (Altair OS-V 0370). Held against the closed form, 1 %; the frequency against
// NAFEMS, 0.5 %.
TEST(NafemsForced, thick_plate_21h_and_21r) {
  expect_ratio(mindlin_resonance(10, 0.05, 100, 0.02), 45.42e-3, 0.002, "closed form, 13H");
  const double exact = mindlin_resonance(10, 1, 1e6, 0.02);
  const Swept s = swept_plate(1, 1e6, 10, 80);
  expect_ratio(s.peak.height, exact, 0.01, "21H");
  expect_ratio(s.peak.frequency, 45.90, 0.005, "21H");
  expect_ratio(s.density, exact * exact, 0.02, "21R");
}

// Middle of a simply supported Mindlin plate under a pressure that is suddenly there, largest in
// time: double sine series, of each term deflection and the rotation along its gradient.
std::pair<double, double> mindlin_step(double side, double t, double pressure, double zeta) {
  const double E = 200e9, nu = 0.3, rho = 8000;
  const double S = 5. / 6 * E / (2 * (1 + nu)) * t, D = E * t * t * t / (12 * (1 - nu * nu));
  struct Term {
    double share, omega;
  };
  std::vector<Term> terms;
  for (int m = 1; m < 24; m += 2)
    for (int n = 1; n < 24; n += 2) {
      const double k = pi / side * std::hypot(m, n);
      Eigen::Matrix2d K, M;
      K << S * k * k, -S * k, -S * k, S + D * k * k;
      M << rho * t, 0, 0, rho * t * t * t / 12;
      const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes{MatrixXd(K), MatrixXd(M)};
      const double sign = ((m + n) / 2) % 2 == 1 ? 1 : -1; // sin(m pi / 2) sin(n pi / 2)
      for (int j = 0; j < 2; ++j) {
        const double W = modes.eigenvectors()(0, j), lambda = modes.eigenvalues()[j];
        terms.push_back(
            {sign * W * W * 16 * pressure / (pi * pi * m * n * lambda), std::sqrt(lambda)});
      }
    }
  std::pair<double, double> peak{0, 0};
  const double half = pi / terms.front().omega;
  for (int i = 0; i <= 4000; ++i) {
    const double time = 1.5 * half * i / 4000;
    double w = 0;
    for (const auto& [share, omega] : terms) {
      const double d = omega * std::sqrt(1 - zeta * zeta);
      w += share * (1 - std::exp(-zeta * omega * time) *
                            (std::cos(d * time) + zeta * omega / d * std::sin(d * time)));
    }
    if (w > peak.first) peak = {w, time};
  }
  return peak;
}

// NAFEMS: 3.523 mm after 0.210 s, at rest 1.817 mm, which is 2.4 % above Navier's 1.774 of the same
// plate: its mesh is coarse. Held against the series, 1 %, and the overshoot against NAFEMS, 1 %.
// The higher modes make the top flat: another program's first-order quads have it at 0.214 s
// (Altair OS-V 0365), so the motion at 0.210 s is held in place of the time, 1 %.
TEST(NafemsForced, thin_plate_13t) {
  const LoadedPlate plate = supported_plate(0.05, 100);
  const Stepped s = step(plate.model, plate.load, plate.middle, 0.3);
  const auto [peak, time] = mindlin_step(10, 0.05, 100, 0.02);
  expect_ratio(s.peak, peak, 0.01, "13T");
  EXPECT_NEAR(time, 0.210, 0.001);
  expect_ratio(s.motion[1400], peak, 0.01, "13T");
  expect_ratio(s.settled, 1.7744e-3, 0.01, "13T");
  expect_ratio(s.peak / s.settled, 3.523 / 1.817, 0.01, "13T");
}

// NAFEMS: 4.524 mm after 0.0108 s, at rest 2.333 mm (as P. Krysl's pub_21TNAFEMS_transient quotes
// them, whose own solids reach 4.795 mm). 4.524 is 2.333 times the overshoot of one mode, 1 +
// exp(-pi zeta): the higher modes, which the series has, add 1.9 % and make the top 3 % earlier.
TEST(NafemsForced, thick_plate_21t) {
  const LoadedPlate plate = supported_plate(1, 1e6);
  const Stepped s = step(plate.model, plate.load, plate.middle, 0.016);
  const auto [peak, time] = mindlin_step(10, 1, 1e6, 0.02);
  expect_ratio(s.peak, peak, 0.01, "21T");
  expect_ratio(s.time, time, 0.02, "21T");
  expect_ratio(s.settled, 2.333e-3, 0.01, "21T");
  EXPECT_NEAR(2.333e-3 * (1 + std::exp(-0.02 * pi)), 4.524e-3, 1e-6);
  expect_ratio(s.peak, 4.524e-3, 0.02, "21T");
  expect_ratio(s.time, 0.0108, 0.04, "21T");
}

} // namespace
} // namespace plica::test
