// Equivalent pipes and chains of connectors against closed forms: uniform rod, shaft, beam with
// rotary inertia, springs in series.
#include "compare/compare.hpp"
#include "model/description/connector_curve.hpp"
#include "model/description/pipe_model.hpp"
#include "model/shape/build.hpp"
#include "run/analyses/run.hpp"
#include "tests/bellows_case.hpp"

#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

namespace plica {
namespace {

Case held(const std::variant<EquivalentPipe, ConnectorChain>& part, int modes) {
  Case data;
  data.name = "pipe";
  data.materials["steel"] = {.E = 193e9, .nu = 0.3, .rho = 8000};
  std::visit([&](const auto& body) { data.parts.push_back({"pipe", body}); }, part);
  data.caps = {{.name = "left", .of = {"pipe.left"}}, {.name = "right", .of = {"pipe.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.modes = Modes{.count = modes};
  data.analyses.error_bars = false;
  return data;
}

// A convoluted pipe without straight ends.
EquivalentPipe plain() {
  EquivalentPipe p;
  p.material = "steel";
  p.length = p.convoluted = 0.4;
  p.outer = {.radius = 0.05, .wall = 0.001, .axial = 5e4, .torsion = 2e5};
  p.end_radius = 0.05;
  p.end_wall = 0.0005;
  p.elements = 60;
  return p;
}

double first_mode(const Results& results, const std::string& shape) {
  for (const ModeResult& m : results.modes)
    if (m.shape == shape) return m.frequency;
  return 0;
}

// Clamped rod 1/(2L) sqrt(EA / m'), shaft 1/(2L) sqrt(GJ / J'): 0.1 %.
TEST(EquivalentPipe, is_a_rod_and_a_shaft) {
  EquivalentPipe p = plain();
  p.outer.torsion = 100; // so soft that its mode is among the first
  const Results r = test::run_silently(held(p, 12));
  const double mass = 2 * std::numbers::pi * 0.05 * 0.001 * 8000 * 0.4;
  EXPECT_NEAR(first_mode(r, "axial") / (0.5 * std::sqrt(5e4 / mass)), 1, 1e-3);
  EXPECT_NEAR(r.statics->k_axial / 5e4, 1, 1e-9);
  EXPECT_NEAR(first_mode(r, "torsion") / (0.5 * std::sqrt(100 / (mass * 0.05 * 0.05))), 1, 1e-3);
  EXPECT_NEAR(r.statics->k_torsion / 100, 1, 1e-9);
  EXPECT_NEAR(r.statics->k_transverse_x / (12 * 5e4 * 0.4 * 0.05 * 0.05 / 2 / std::pow(0.4, 3) * 1),
              1, 1e-6);
  EXPECT_NEAR(r.model.mass / mass, 1, 1e-9);
}

// First frequency of a clamped beam of Timoshenko, from w' = phi + Q/GA, phi' = M/EI, M' = -Q -
// J w^2 phi, Q' = -m w^2 w: zero of the determinant that joins M and Q at one end with w and phi at
// the other. 1/GA = 0 is Rayleigh's beam, J = 0 besides Euler's.
double clamped_beam(double EI, double shear_compliance, double mass, double J, double L) {
  const auto determinant = [&](double w) {
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero(); // of w, phi, M, Q
    A(0, 1) = 1;
    A(0, 3) = shear_compliance;
    A(1, 2) = 1 / EI;
    A(2, 1) = -J * w * w;
    A(2, 3) = -1;
    A(3, 0) = -mass * w * w;
    return Eigen::Matrix4d((A * L).exp()).block<2, 2>(0, 2).determinant();
  };
  const double euler = std::pow(4.73004 / L, 2) * std::sqrt(EI / mass);
  double low = 0.3 * euler, high = 1.01 * euler;
  EXPECT_LT(determinant(low) * determinant(high), 0);
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (determinant(low) * determinant(middle) > 0 ? low : high) = middle;
  }
  return low / (2 * std::numbers::pi);
}

// 0.1 % with and without rotary inertia and shear.
TEST(EquivalentPipe, bends_as_a_beam_with_rotary_inertia_and_shear) {
  EquivalentPipe p = plain();
  p.outer.torsion = 1500; // soft enough for shear to count
  const double mass = 2 * std::numbers::pi * 0.05 * 0.001 * 8000;
  const double EI = 5e4 * 0.4 * 0.05 * 0.05 / 2, GA = 0.53 * 1500 * 0.4 / (0.05 * 0.05);
  const double euler = std::pow(4.73004 / 0.4, 2) * std::sqrt(EI / mass) / (2 * std::numbers::pi);
  EXPECT_NEAR(clamped_beam(EI, 0, mass, 0, 0.4) / euler, 1, 1e-5);
  for (const bool ring : {false, true})
    for (const PipeShear shear : {PipeShear::rigid, PipeShear::elastic}) {
      p.rotary_inertia = ring;
      p.shear = shear;
      const double exact = clamped_beam(EI, shear == PipeShear::elastic ? 1 / GA : 0, mass,
                                        ring ? mass * 0.05 * 0.05 / 2 : 0, 0.4);
      EXPECT_NEAR(first_mode(test::run_silently(held(p, 8)), "transverse") / exact, 1, 1e-3);
      if (ring || shear == PipeShear::elastic) {
        EXPECT_LT(exact, 0.98 * euler);
      }
    }
}

// Bellows A, B, C of the reference as a pipe of their axial stiffness, mass and mean radius, rigid
// in shear, beside an axisymmetric-harmonic shell: bending within 2 and 5 % (B, of four
// convolutions, 3 and 10 %), axial modes within 2 and 3 %.
struct ReferenceBellows {
  const char* name;
  double inner, height, pitch;
  int count;
  double mass, k, axial1, axial2, bending1, bending2, quotient, first, second;
};

class PipeBesideShell : public testing::TestWithParam<ReferenceBellows> {};

TEST_P(PipeBesideShell, meets_its_modes) {
  const ReferenceBellows& b = GetParam();
  EquivalentPipe p = plain();
  p.length = p.convoluted = b.pitch * b.count;
  const double radius = b.inner + b.height / 2;
  p.outer = {.radius = radius,
             .wall = b.mass / (2 * std::numbers::pi * radius * 8000 * p.length),
             .axial = b.k,
             .torsion = 1e6};
  const Results r = test::run_silently(held(p, 16));
  const auto mode = [&](const std::string& shape, int order) {
    for (const ModeResult& m : r.modes)
      if (m.shape == shape && m.order == order) return m.frequency;
    return 0.;
  };
  const double L = p.length, EI = b.k * L * radius * radius / 2;
  const double euler =
      std::pow(4.73004 / L, 2) * std::sqrt(EI * L / b.mass) / (2 * std::numbers::pi);
  const double quotient = euler / std::sqrt(1 + 12.30 * radius * radius / (2 * L * L));
  EXPECT_NEAR(quotient / b.quotient, 1, 1e-3);
  EXPECT_GT(quotient, mode("transverse", 1));
  EXPECT_LT(quotient, 1.007 * mode("transverse", 1));
  EXPECT_NEAR(r.model.mass / b.mass, 1, 1e-6);
  EXPECT_NEAR(mode("axial", 1) / b.axial1, 1, 0.02);
  EXPECT_NEAR(mode("axial", 2) / b.axial2, 1, 0.03);
  EXPECT_NEAR(mode("transverse", 1) / b.bending1, 1, b.first);
  EXPECT_NEAR(mode("transverse", 2) / b.bending2, 1, b.second);
  std::printf("%s: axial %+.2f %+.2f %%, bending %+.2f %+.2f %%\n", b.name,
              100 * (mode("axial", 1) / b.axial1 - 1), 100 * (mode("axial", 2) / b.axial2 - 1),
              100 * (mode("transverse", 1) / b.bending1 - 1),
              100 * (mode("transverse", 2) / b.bending2 - 1));
}

INSTANTIATE_TEST_SUITE_P(
    Bellows, PipeBesideShell,
    testing::Values(ReferenceBellows{"A", 0.026, 0.009, 0.006, 10, 0.09731, 5.418e4, 376.5, 754.8,
                                     598.1, 995.7, 593.5, 0.02, 0.05},
                    ReferenceBellows{"B", 0.0449072, 0.0371856, 0.03175, 4, 0.89152, 1.2849e5,
                                     191.4, 383.2, 293.7, 465.1, 300.0, 0.03, 0.10},
                    ReferenceBellows{"C", 0.05, 0.012, 0.012, 8, 0.34082, 2.3710e5, 423.6, 851.8,
                                     708.9, 1144.4, 696.6, 0.025, 0.05}),
    [](const auto& b) { return std::string(b.param.name); });

// Two layers add; a modulus made for the whole length but used on a part is stiffer by their ratio.
TEST(EquivalentPipe, adds_layers_and_knows_its_lengths) {
  EquivalentPipe p = plain();
  p.inner = PipeLayer{.radius = 0.04, .mass = 0.3, .axial = 3e4, .torsion = 1e5};
  EXPECT_NEAR(test::run_silently(held(p, 2)).statics->k_axial / 8e4, 1, 1e-9);
  p.length = 0.5; // straight ends of 50 mm, as good as rigid
  p.end_cap = 0.2;
  const Results convoluted = test::run_silently(held(p, 2));
  EXPECT_NEAR(convoluted.statics->k_axial / 8e4, 1, 1e-3);
  p.modulus_over = PipeLength::whole;
  const Results whole = test::run_silently(held(p, 2));
  EXPECT_NEAR(whole.statics->k_axial / (8e4 * 0.5 / 0.4), 1, 1e-3);
  double axial = 0, torsion = 0; // compliances: layers side by side, stretches in series
  for (const PipeStretch& s : pipe_stretches(p, {.E = 193e9, .nu = 0.3, .rho = 8000})) {
    double EA = 0, GJ = 0;
    for (const BeamProperties& layer : s.layers) EA += layer.EA, GJ += layer.GJ;
    axial += (s.to - s.from) / EA;
    torsion += (s.to - s.from) / GJ;
  }
  EXPECT_NEAR(whole.statics->k_axial * axial, 1, 1e-9);
  EXPECT_NEAR(whole.statics->k_torsion * torsion, 1, 1e-9);
  const double tubes = 2 * std::numbers::pi * 8000 * (0.05 * 0.001 * 0.4 + 0.05 * 0.0005 * 0.1);
  EXPECT_NEAR(whole.model.mass / (tubes + 0.3 + 0.4), 1, 1e-9);
}

// Springs in series (thesis, eq. 7.1): n elements of n k. Across it holds where bending is rigid.
TEST(ConnectorChain, has_the_stiffness_of_springs_in_series) {
  ConnectorChain c;
  c.length = 0.182;
  c.count = 20;
  c.spring = {
      .axial = 20 * 42100., .transverse = 20 * 58900., .bending = 1e12, .torsion = 20 * 55900.};
  c.mass = 1.7168;
  const Results r = test::run_silently(held(c, 3));
  EXPECT_NEAR(r.statics->k_axial / 42100, 1, 1e-9);
  EXPECT_NEAR(r.statics->k_torsion / 55900, 1, 1e-9);
  EXPECT_NEAR(r.statics->k_transverse_x / 58900, 1, 1e-6);
  EXPECT_NEAR(r.model.mass / 1.7168, 1, 1e-12);
  // Discrete chain between walls: 2 sqrt(k_1 / m_1) sin(pi / 2n) / 2 pi.
  const double exact =
      std::sqrt(20 * 42100. / (1.7168 / 20)) / std::numbers::pi * std::sin(std::numbers::pi / 40);
  EXPECT_NEAR(first_mode(r, "axial") / exact, 1, 1e-6);
}

// Tabulated springs: at rest their slope; over a stroke 20 of them in series, and across beside the
// bending of the elements, which is linear.
TEST(ConnectorChain, follows_tabulated_forces_over_a_stroke) {
  ConnectorChain c;
  c.length = 0.2;
  c.count = 20;
  c.spring = {.bending = 2000, .torsion = 1e6};
  c.spring.axial_curve = {{-1e-3, -400}, {-1e-4, -100}, {0, 0}, {1e-4, 100}, {1e-3, 400}};
  c.spring.transverse_curve = {{-1e-3, -1e4}, {0, 0}, {1e-3, 1e4}};
  c.mass = 1;
  Case data = held(c, 3);
  const Results r = test::run_silently(data);
  EXPECT_NEAR(r.statics->k_axial, 1e6 / 20, 1e-3);
  ASSERT_EQ(r.strokes.size(), 2U);
  // 300 N: 20 (0.1 mm + 0.6 mm).
  EXPECT_NEAR(force_at(r.strokes[0].points, 0.014), 300, 1e-9);
  EXPECT_NEAR(force_at(r.strokes[0].points, 0.038), 700, 1e-9); // beyond the table, straight on
  // A straight curve is the linear answer of the assembled chain.
  EXPECT_NEAR(force_at(r.strokes[1].points, 1e-3) / 1e-3 / r.statics->k_transverse_x, 1, 1e-9);
  Measured measured;
  measured.statics.resize(2);
  measured.statics[0].stroke = 0.014;
  const auto rows = compare(r, measured);
  EXPECT_NEAR(rows[0].computed, 300 / 0.014, 1e-6);
  EXPECT_NEAR(rows[1].computed, 5e4, 1e-3);
}

// A diagonal matrix is the four stiffnesses; a coupling term is passed on from element to element.
TEST(ConnectorChain, takes_a_full_matrix) {
  ConnectorChain c;
  c.length = 0.2;
  c.count = 10;
  c.spring = {.axial = 1e6, .transverse = 4e8, .bending = 2000, .torsion = 1e6};
  c.mass = 1;
  c.radius = 0.06;
  const Results plain = test::run_silently(held(c, 8));
  ConnectorChain full = c;
  full.spring = {};
  full.spring.matrix.assign(6, {});
  const std::array<double, 6> diagonal{4e8, 1e6, 4e8, 2000, 1e6, 2000};
  for (std::size_t i = 0; i < 6; ++i) full.spring.matrix[i][i] = diagonal[i];
  const Results same = test::run_silently(held(full, 8));
  EXPECT_NEAR(same.modes[0].frequency / plain.modes[0].frequency, 1, 1e-12);
  full.spring.matrix[1][4] = full.spring.matrix[4][1] = 2e5; // stretch turns: a coil spring
  const Results coupled = test::run_silently(held(full, 8));
  // Ends kept from turning: the axial stiffness is unchanged, and the stretch gives a torque.
  EXPECT_NEAR(coupled.statics->k_axial / (1e6 / 10), 1, 1e-9);
  EXPECT_NEAR(coupled.statics->end_stiffness(7, 10) / (2e5 / 10), 1, 1e-9);
}

// The thesis's connectors of A1, n_c = 20 (table 8.2), beside its 139 and 167 Hz (table 8.3).
TEST(ConnectorChain, of_the_thesis_for_a1) {
  ConnectorChain c;
  c.length = 0.182;
  c.count = 20;
  c.spring = {.axial = 2674000, .transverse = 3664000, .bending = 9800020, .torsion = 2080000};
  c.mass = 1.7168;
  const Results r = test::run_silently(held(c, 6));
  std::printf("A1, 20 connectors: axial %.1f Hz (139), transverse %.1f Hz (167)\n",
              first_mode(r, "axial"), first_mode(r, "transverse"));
  EXPECT_NEAR(first_mode(r, "axial") / 139, 1, 0.03);
  EXPECT_NEAR(first_mode(r, "transverse") / 167, 1, 0.03);
}

} // namespace
} // namespace plica
