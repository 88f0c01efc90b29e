// Heat conducted along walls, against closed forms.
#include "mesh/plate.hpp"
#include "run/routes/operating_state.hpp"
#include "solve/heat_conduction.hpp"
#include "tests/bellows_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace plica;
using namespace plica::test;

namespace {

using Eigen::Vector3d;

// A strip along x, as a model.
Model strip(double length, double thickness, int along) {
  Model model;
  model.components = {"strip"};
  model.mesh = mesh_plate(
      {Vector3d(0, 0, 0), Vector3d(length, 0, 0), Vector3d(length, 0.02, 0), Vector3d(0, 0.02, 0)},
      along, 2, thickness);
  model.shells.push_back({{.E = 2e11, .nu = 0.3, .rho = 8000}, MembraneStrain::displacement, 0});
  return model;
}

std::map<int, double> at_x(const Model& model, double x, double temperature) {
  std::map<int, double> held;
  for (int n = 0; n < int(model.mesh.nodes.size()); ++n)
    if (std::abs(model.mesh.nodes[std::size_t(n)].x() - x) < 1e-9) held[n] = temperature;
  return held;
}

} // namespace

// k = k0 (1 + b T): the integral of k is linear along the bar, k0 (T + b T^2 / 2).
TEST(HeatConduction, BarWhoseConductivityChanges) {
  const Model model = strip(0.1, 1e-3, 40);
  const double k0 = 15, b = 1e-3;
  HeatLoads loads;
  loads.held = at_x(model, 0, 500);
  loads.held.merge(at_x(model, 0.1, 100));
  const WallTemperature wall = conducted_temperature(
      model, 0, [&](double T) { return k0 * (1 + b * T); }, loads);
  const auto potential = [&](double T) { return k0 * (T + b * T * T / 2); };
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    const double x = model.mesh.nodes[n].x() / 0.1;
    EXPECT_NEAR(potential(wall.at[Eigen::Index(n)]),
                potential(500) + x * (potential(100) - potential(500)), 1e-4 * potential(500));
  }
  const double area = 0.02 * 1e-3;
  EXPECT_NEAR(wall.through, area * (potential(500) - potential(100)) / 0.1, 1e-4 * wall.through);
  EXPECT_EQ(wall.across, 0);
}

// A fin with an insulated end: T = T_gas + (T_0 - T_gas) cosh(m (L - x)) / cosh(m L),
// m^2 = U / (k t), U = 1 / (1/h + t/(2 k)) on one side; heat sqrt(U k t) b tanh(m L) (T_0 - T_gas).
TEST(HeatConduction, Fin) {
  const double L = 0.1, t = 1e-3, k = 16, h = 40, gas = 30, root = 400;
  const Model model = strip(L, t, 80);
  HeatLoads loads;
  loads.held = at_x(model, 0, root);
  loads.above = {gas, h};
  const WallTemperature wall = conducted_temperature(
      model, 0, [&](double) { return k; }, loads);
  const double U = 1 / (1 / h + t / (2 * k)), m = std::sqrt(U / (k * t));
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
    EXPECT_NEAR(wall.at[Eigen::Index(n)],
                gas +
                    (root - gas) * std::cosh(m * (L - model.mesh.nodes[n].x())) / std::cosh(m * L),
                1e-3 * (root - gas));
  EXPECT_NEAR(wall.through, 0.02 * std::sqrt(U * k * t) * std::tanh(m * L) * (root - gas),
              1e-3 * wall.through);
}

// Gas on both sides: through the wall flows q = (T_in - T_out) / (1/h_in + t/k + 1/h_out), and its
// faces differ by q t / k.
TEST(HeatConduction, ThroughTheWall) {
  const double t = 2e-3, k = 15, in = 600, out = 50, h_in = 300, h_out = 80;
  const Model model = strip(0.05, t, 4);
  HeatLoads loads;
  loads.below = {in, h_in};
  loads.above = {out, h_out};
  const WallTemperature wall = conducted_temperature(
      model, 0, [&](double) { return k; }, loads);
  const double q = (in - out) / (1 / h_in + t / k + 1 / h_out);
  EXPECT_NEAR(wall.at[0], in - q * (1 / h_in + t / (2 * k)), 1e-6 * in);
  EXPECT_NEAR(wall.across, q * t / k, 1e-6 * in);
  EXPECT_NEAR(wall.through, q * 0.05 * 0.02, 1e-6 * wall.through);
}

// A wall that nothing warms has no temperature.
TEST(HeatConduction, NothingGiven) {
  EXPECT_THROW(conducted_temperature(strip(0.1, 1e-3, 2), 0, [](double) { return 15; }, {}),
               std::runtime_error);
}

// A cylinder held hot at one end and cool at the other, free to grow there: its stretch is the
// integral of the strain, by symmetry as on the full mesh.
TEST(HeatConduction, CylinderGrowsByIt) {
  Case data;
  data.name = "cylinder";
  data.materials["steel"] = {.E = 200e9,
                             .nu = 0.3,
                             .rho = 7900,
                             .E_over_temperature = {{0, 200e9}, {600, 200e9}},
                             .expansion = {{0, 17e-6}, {600, 17e-6}},
                             .conductivity = {{0, 15}, {600, 15}}};
  Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = 0.05;
  MeridianSection cuff;
  cuff.shape = SectionShape::cuff;
  cuff.length = 0.5;
  bellows.profile = {cuff};
  bellows.wall.plies = {1e-3};
  bellows.mesh = {.around = 24, .arc = 1, .wall = 60};
  data.parts = {{"pipe", bellows}};
  data.caps = {{.name = "left", .of = {"pipe.left"}}, {.name = "right", .of = {"pipe.right"}}};
  data.mount = {{.cap = "left"}};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  data.state.emplace();
  data.state->temperature = {{.part = "pipe", .held = {{"pipe.left", 520}, {"pipe.right", 120}}}};
  const Results results = run_silently(data);
  ASSERT_EQ(results.state->heat.size(), 1u);
  EXPECT_NEAR(results.state->heat[0].highest, 520, 1e-9);
  EXPECT_EQ(results.state->route, "rotational symmetry");
  const double expected = 17e-6 * ((520 + 120) / 2. - 20) * 0.5;
  EXPECT_NEAR(results.state->displacement.col(1).maxCoeff() / expected, 1, 0.005);
  data.analyses.symmetry = Symmetry::off;
  const Results full = run_silently(data);
  EXPECT_NEAR(full.state->displacement.col(1).maxCoeff() /
                  results.state->displacement.col(1).maxCoeff(),
              1, 1e-7);
}
