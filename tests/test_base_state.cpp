// States of equilibrium, the vibration around them and their buckling, against closed forms and
// published tables.
#include "mesh/plate.hpp"
#include "solve/base_state.hpp"
#include "solve/buckling.hpp"
#include "solve/couplings.hpp"
#include "solve/modes.hpp"
#include "solve/statics.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace plica;

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double pi = M_PI;
const std::function<void(const StateIteration&)> quietly = [](const StateIteration&) {};

BaseState state_of(const Model& model, const StateLoads& loads) {
  std::vector<int> holds;
  for (const MovedHold& h : loads.holds) holds.push_back(h.node);
  return find_state(model, loads, full_state_solver(holds), quietly);
}

// A beam along x of `elements`, square section, held by what the tests add.
struct Strut {
  double L = 1, side = 0.01, E = 2e11, rho = 7800;
  double EI = E * std::pow(side, 4) / 12, EA = E * side * side, m = rho * side * side;
  Model model;

  explicit Strut(int elements, bool shear_rigid = true) {
    model.components = {"strut"};
    BeamProperties section = rectangle_section({.E = E, .nu = 0.3, .rho = rho}, side, side);
    if (shear_rigid) {
      section.GA_y = section.GA_z = std::numeric_limits<double>::infinity();
      section.inertia_y = section.inertia_z = 0;
    }
    for (int i = 0; i <= elements; ++i) add_node(model, {L * i / elements, 0, 0});
    for (int i = 0; i < elements; ++i)
      model.beams.push_back({.node1 = i, .node2 = i + 1, .section = section});
  }
  int last() const { return int(model.mesh.nodes.size()) - 1; }
  void pin_both() {
    add_support(model, {0}, {0, 1, 2, 3}, "pin");
    add_support(model, {last()}, {1, 2, 3}, "slide");
  }
  StateLoads pulled(double force) const {
    StateLoads loads;
    loads.force = VectorXd::Zero(dof_count(model));
    loads.force[6 * last()] = force;
    return loads;
  }
};

// Frequencies of the free DOFs, Hz.
VectorXd frequencies(const Model& model, int count) {
  const System s = assemble(model);
  BaseFactor base = factor_below_spectrum(s.K, s.M);
  const ModeSet set = find_modes(s.K, s.M, {.count = count, .band = {}, .proof = true}, base);
  EXPECT_TRUE(set.proof.passed);
  return set.lambda.array().sqrt() / (2 * pi);
}

} // namespace

// Euler-Bernoulli, pinned: f = n^2 pi / (2 L^2) sqrt(EI/m) sqrt(1 + N L^2 / (n^2 pi^2 EI)).
TEST(BaseState, BeamUnderAxialLoad) {
  for (double share : {-0.8, -0.3, 0.5, 4.}) {
    Strut strut(16);
    strut.pin_both();
    const double euler = pi * pi * strut.EI / (strut.L * strut.L);
    const BaseState state = state_of(strut.model, strut.pulled(share * euler));
    EXPECT_EQ(state.load_steps, 1);
    const VectorXd f = frequencies(state.model, 4);
    for (int n : {1, 2}) {
      const double expected = n * n * pi / (2 * strut.L * strut.L) * std::sqrt(strut.EI / strut.m) *
                              std::sqrt(1 + share / (n * n));
      EXPECT_NEAR(f[2 * n - 2] / expected, 1, 1e-3) << "N = " << share << " Euler, mode " << n;
    }
  }
}

// Euler's loads n^2 pi^2 EI / L^2 of a pinned strut, twice each.
TEST(BaseState, EulerLoads) {
  Strut strut(16);
  strut.pin_both();
  const double euler = pi * pi * strut.EI / (strut.L * strut.L);
  const BaseState state = state_of(strut.model, strut.pulled(-0.1 * euler));
  Model by_stress = state.model;
  by_stress.rest = std::make_shared<Rest>(
      Rest{state.model.rest->nodes, state.model.rest->turned, StiffnessPart::by_stress});
  const BucklingLoads loads =
      buckling_loads(assemble(strut.model).K, assemble(by_stress).K, 4, 1000);
  ASSERT_EQ(loads.factor.size(), 4);
  EXPECT_TRUE(loads.proved) << loads.reason;
  EXPECT_NEAR(loads.factor[0], 10, 0.02);
  EXPECT_NEAR(loads.factor[1], 10, 0.02);
  EXPECT_NEAR(loads.factor[2], 40, 0.2);
  EXPECT_NEAR(loads.factor[3], 40, 0.2);
}

// Beyond Euler's load the straight strut has no stable state.
TEST(BaseState, SaysWhereItBuckles) {
  Strut strut(16);
  strut.pin_both();
  const double euler = pi * pi * strut.EI / (strut.L * strut.L);
  try {
    state_of(strut.model, strut.pulled(-1.2 * euler));
    FAIL() << "a state beyond buckling";
  } catch (const StateError& error) {
    EXPECT_NE(std::string(error.what()).find("beyond 0.8"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("loses its stability"), std::string::npos);
  }
}

// A cantilever under an end moment 2 pi EI / L closes to a circle: its end comes back to its root.
// In its plane; across it a moment of constant axis is no conservative load.
TEST(BaseState, CantileverOfBeamsRolledToACircle) {
  Strut strut(80);
  for (int n = 1; n <= strut.last(); ++n) add_support(strut.model, {n}, {1, 3, 5}, "plane");
  StateLoads loads;
  loads.holds.push_back({.node = 0});
  loads.force = VectorXd::Zero(dof_count(strut.model));
  loads.force[6 * strut.last() + 4] = -2 * pi * strut.EI / strut.L;
  const BaseState state = state_of(strut.model, loads);
  const Vector3d end = state.model.mesh.nodes[std::size_t(strut.last())];
  EXPECT_LT(end.norm(), 0.01 * strut.L);
  double height = 0;
  for (const Vector3d& x : state.model.mesh.nodes) height = std::max(height, std::abs(x.z()));
  EXPECT_NEAR(height, strut.L / pi, 0.01 * strut.L / pi);
}

// The same of shells, MITC4 with each membrane: Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004)
// 1551-1569, sec. 3.2: L = 12, b = 1, h = 0.1, E = 1.2e6, nu = 0, M_max = 50 pi / 3. An
// element that turns by t is softer by sin(t)/t, its directors running straight between corners.
// U = L (1 - sin(a)/a), W = L (1 - cos(a))/a.
TEST(BaseState, CantileverOfShellsRolledToACircle) {
  for (MembraneStrain membrane :
       {MembraneStrain::displacement, MembraneStrain::mitc4_plus, MembraneStrain::incompatible})
    for (double share : {0.25, 1.}) {
      const int elements = share < 1 ? 16 : 40;
      Model model;
      model.components = {"strip"};
      model.mesh =
          mesh_plate({Vector3d(0, 0, 0), Vector3d(12, 0, 0), Vector3d(12, 1, 0), Vector3d(0, 1, 0)},
                     elements, 1, 0.1);
      model.shells.push_back({{.E = 1.2e6, .nu = 0, .rho = 1}, membrane, 0});
      StateLoads loads;
      std::vector<int> tip;
      for (int n = 0; n < int(model.mesh.nodes.size()); ++n) {
        if (model.mesh.nodes[std::size_t(n)].x() < 1e-9) loads.holds.push_back({.node = n});
        if (model.mesh.nodes[std::size_t(n)].x() > 12 - 1e-9) tip.push_back(n);
      }
      const int end = add_node(model, {12, 0.5, 0});
      add_kinematic_coupling(model, end, tip, {0, 1, 2, 3, 4, 5}, "end");
      add_support(model, {end}, {1, 3, 5}, "plane");
      loads.force = VectorXd::Zero(dof_count(model));
      loads.force[6 * end + 4] = -share * 50 * pi / 3;
      const BaseState state = state_of(model, loads);
      const Vector3d x = state.model.mesh.nodes[std::size_t(end)];
      const double a = 2 * pi * share;
      EXPECT_NEAR(12 - x.x(), 12 * (1 - std::sin(a) / a), 0.12);
      EXPECT_NEAR(std::abs(x.z()), 12 * (1 - std::cos(a)) / a, 0.12);
    }
}

// Shear force at the end: Sze, Liu & Lo, sec. 3.1, table 1: L = 10, b = 1, h = 0.1, E = 1.2e6,
// nu = 0, P = 4: W = 6.698 at P = 4, U = 3.286.
TEST(BaseState, CantileverUnderEndShear) {
  Model model;
  model.components = {"strip"};
  model.mesh = mesh_plate(
      {Vector3d(0, 0, 0), Vector3d(10, 0, 0), Vector3d(10, 1, 0), Vector3d(0, 1, 0)}, 16, 1, 0.1);
  model.shells.push_back({{.E = 1.2e6, .nu = 0, .rho = 1}, MembraneStrain::incompatible, 0});
  StateLoads loads;
  loads.force = VectorXd::Zero(dof_count(model));
  int tip = 0;
  for (int n = 0; n < int(model.mesh.nodes.size()); ++n) {
    if (model.mesh.nodes[std::size_t(n)].x() < 1e-9) loads.holds.push_back({.node = n});
    if (model.mesh.nodes[std::size_t(n)].x() > 10 - 1e-9) loads.force[6 * (tip = n) + 2] = 2;
  }
  const BaseState state = state_of(model, loads);
  const Vector3d end = state.model.mesh.nodes[std::size_t(tip)];
  EXPECT_NEAR(end.z() / 6.698, 1, 0.01);
  EXPECT_NEAR((10 - end.x()) / 3.286, 1, 0.01);
  EXPECT_GT(state.linear_error, 0.5);
}

// Held at both ends, a heated bar presses by E A strain, which costs it frequency.
TEST(BaseState, BarHeldAndHeated) {
  Strut strut(16);
  const double strain = 5e-5;
  for (BeamElement& b : strut.model.beams) b.section.thermal_strain = strain;
  add_support(strut.model, {0}, {0, 1, 2, 3}, "pin");
  add_support(strut.model, {strut.last()}, {0, 1, 2, 3}, "pin");
  const BaseState state = state_of(strut.model, {});
  EXPECT_NEAR(state.lacking[0], strut.EA * strain, 1e-6 * strut.EA * strain);
  const double euler = pi * pi * strut.EI / (strut.L * strut.L);
  const double expected = pi / 2 / (strut.L * strut.L) * std::sqrt(strut.EI / strut.m) *
                          std::sqrt(1 - strut.EA * strain / euler);
  EXPECT_NEAR(frequencies(state.model, 1)[0] / expected, 1, 1e-3);
}

TEST(BaseState, NothingActsNothingMoves) {
  Strut strut(4);
  strut.pin_both();
  const BaseState state = state_of(strut.model, {});
  EXPECT_EQ(state.largest_displacement, 0);
  const Eigen::MatrixXd difference =
      Eigen::MatrixXd(assemble(state.model).K) - Eigen::MatrixXd(assemble(strut.model).K);
  EXPECT_LT(difference.norm(), 1e-9 * Eigen::MatrixXd(assemble(strut.model).K).norm());
}
