// States of cases: pressure, heat, installation, against closed forms and along both routes.
#include "io/tables/summary.hpp"
#include "model/description/ejma.hpp"
#include "model/description/steels.hpp"
#include "run/routes/operating_state.hpp"
#include "run/study/reduce.hpp"
#include "solve/base_state.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/refusal.hpp"
#include "tests/tube_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace plica;
using namespace plica::test;

namespace {

// A plain cylinder between two caps, both held.
Case cylinder(double length, double radius, double wall) {
  Case data;
  data.name = "cylinder";
  data.materials["steel"] = {.E = 200e9, .nu = 0.3, .rho = 7900};
  Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = radius;
  MeridianSection cuff;
  cuff.shape = SectionShape::cuff;
  cuff.length = length;
  bellows.profile = {cuff};
  bellows.wall.plies = {wall};
  bellows.mesh = {.around = 48, .arc = 1, .wall = 120};
  data.parts = {{"bellows", bellows}};
  data.caps = {{.name = "left", .of = {"bellows.left"}},
               {.name = "right", .of = {"bellows.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  return data;
}

Case heated(Case data, const std::string& steel, double temperature) {
  bellows_of(data).material = steel;
  add_known_steels(data.parts, data.materials);
  data.state.emplace();
  data.state->temperature = {{.part = "bellows", .at = temperature}};
  return data;
}

const EndReaction& reaction(const Results& results, const std::string& cap) {
  for (const EndReaction& r : results.state->reactions)
    if (r.cap == cap) return r;
  throw std::out_of_range(cap);
}

// A limit of pressure beside the state, Pa; 0: none of this kind.
double pressure_limit(const Results& results, SquirmKind kind) {
  for (const SquirmResult& squirm : results.state->squirm)
    if (squirm.kind == kind) return squirm.limit;
  return 0;
}

} // namespace

// Of a cylinder of length L whose ends cannot widen: hoop stress falls short of p r / t over 2/beta
// of its length, beta^4 = 3 (1 - nu^2) / (r t)^2 (Timoshenko, Theory of Plates and Shells, sec.
// 114).
struct LongCylinder {
  double L = 1, r = 0.05, t = 1e-3, p = 1e6, E = 200e9, nu = 0.3;
  double edge = 2 * std::sqrt(r * t) / std::pow(3 * (1 - nu * nu), 0.25); // 2 / beta
};

// Held at both ends the wall bears nu times the mean hoop stress along its axis; the caps bear the
// rest of the thrust p pi r^2.
TEST(OperatingState, PressureInACylinderHeldAtBothEnds) {
  const LongCylinder c;
  Case data = cylinder(c.L, c.r, c.t);
  data.state.emplace();
  data.state->pressure = c.p;
  const Results results = run_silently(data);
  const double hoop = c.p * c.r / c.t, thrust = c.p * M_PI * c.r * c.r;
  // s L = nu (hoop L - (hoop - nu s) edge)
  const double s = c.nu * hoop * (1 - c.edge / c.L) / (1 - c.nu * c.nu * c.edge / c.L);
  EXPECT_EQ(results.state->route, "rotational symmetry");
  compare("cylinder under pressure", "thrust on the caps", reaction(results, "right").force[1],
          thrust - 2 * M_PI * c.r * c.t * s, 0.01);
  EXPECT_NEAR(reaction(results, "left").force[1], -reaction(results, "right").force[1],
              1e-6 * thrust);
}

// Its transverse modes are those of a beam that is pressed by the thrust on its caps F: clamped,
// f^2 / f0^2 - 1 = -12.30 F L^2 / (500.6 EI) (Rayleigh's quotient).
TEST(OperatingState, PressureInATubeThatVibrates) {
  const LongCylinder c{.L = 2, .r = 0.026, .t = 1e-3, .p = 5e6};
  Case data = cylinder(c.L, c.r, c.t);
  data.analyses.modes = Modes{.count = 4};
  const auto first = [](const Results& results) {
    for (const ModeResult& m : results.modes)
      if (m.shape == "transverse") return m.frequency;
    throw std::out_of_range("transverse");
  };
  const double at_rest = first(run_silently(data));
  data.state.emplace();
  data.state->pressure = c.p;
  const Results results = run_silently(data);
  const double bending = c.E * M_PI * std::pow(c.r, 3) * c.t;
  const double change =
      -12.30 * reaction(results, "right").force[1] * c.L * c.L / (500.6 * bending);
  EXPECT_LT(change, -0.03);
  compare("tube under pressure, both ends held", "change of its first frequency, squared",
          std::pow(first(results) / at_rest, 2) - 1, change, 0.05);
}

// A closed vessel needs nobody to hold it.
TEST(OperatingState, PressureInAClosedVessel) {
  const LongCylinder c;
  Case data = cylinder(c.L, c.r, c.t);
  data.mount.pop_back();
  data.state.emplace();
  data.state->pressure = c.p;
  const Results results = run_silently(data);
  EXPECT_NEAR(reaction(results, "left").force[1], 0, 1e-3);
  const double along = c.p * c.r / (2 * c.t), hoop = 2 * along;
  compare("closed vessel", "stretch", results.state->displacement.col(1).maxCoeff(),
          (along * c.L - c.nu * (hoop * c.L - (hoop - c.nu * along) * c.edge)) / c.E, 0.01);
}

// Both ends held: the wall is pressed by E alpha dT.
TEST(OperatingState, HeatedBetweenRigidEnds) {
  const Results results = run_silently(heated(cylinder(1, 0.05, 1e-3), "1.4541", 100));
  const double expected = 194e9 * 16e-6 * 80 * 2 * M_PI * 0.05 * 1e-3;
  compare("heated cylinder", "force on the caps", reaction(results, "right").force[1], expected,
          0.02);
}

// Free to grow: no force, alpha dT L, and frequencies by the root of E.
TEST(OperatingState, HeatedAndFreeToGrow) {
  Case data = verification_case("bellows_a", {.around = 24, .arc = 2, .wall = 2}, 4);
  data.mount = {{.cap = "left"}};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  const Case hot = heated(data, "1.4541", 500), cold = heated(data, "1.4541", 20);
  const Results at_500 = run_silently(hot), at_20 = run_silently(cold);
  // Stiffness grows with E and the length, the mass stays.
  const double growth = 1 + 18e-6 * 480;
  EXPECT_NEAR(at_500.modes[0].frequency / at_20.modes[0].frequency, std::sqrt(165. / 200 * growth),
              0.002);
  EXPECT_NEAR(reaction(at_500, "left").force[1], 0, 1e-3);
}

// Clamped at both ends a bellows of bending stiffness EI buckles as a column at
// p A = 4 pi^2 EI / L^2 (Haringx, Philips Res. Rep. 3 (1948) 401); EI = 1.5367 N m2 of a separate
// axisymmetric model, effective radius root + height / 2.
TEST(OperatingState, ColumnSquirm) {
  Case data = without_modes(verification_case("bellows_a", {.around = 32, .arc = 3, .wall = 3}));
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  data.state.emplace();
  data.state->pressure = 1e6;
  data.state->buckling = 2;
  const Results results = run_silently(data);
  ASSERT_GE(results.state->buckling.size(), 2u);
  EXPECT_TRUE(results.state->buckling_proved) << results.state->buckling_reason;
  const double area = M_PI * 0.0305 * 0.0305, span = 0.06;
  compare("bellows A, both ends clamped", "column squirm", results.state->buckling[0].factor * 1e6,
          4 * M_PI * M_PI * 1.5367 / (span * span) / area, 0.05);
  EXPECT_GT(results.state->buckling[0].sideways, 0.3);
  EXPECT_EQ(pressure_limit(results, SquirmKind::elastic_column),
            results.state->buckling[0].factor * 1e6);
  EXPECT_EQ(pressure_limit(results, SquirmKind::elastic_in_plane), 0);
}

// Beyond squirm the state is one of balance all round, and the part falls aside from it: what was
// asked of it first says so.
TEST(OperatingState, BeyondSquirmThereIsNoResult) {
  for (const bool statics : {true, false}) {
    Case data = verification_case("bellows_a", {.around = 12, .arc = 2, .wall = 2}, 4);
    data.mount = {{.cap = "left"}, {.cap = "right"}};
    data.analyses.error_bars = false;
    data.analyses.statics = statics;
    data.state.emplace();
    data.state->pressure = 1e7;
    try {
      run_silently(data);
      FAIL() << "statics: " << statics;
    } catch (const StateError& error) {
      EXPECT_NE(std::string(error.what()).find("it has buckled"), std::string::npos)
          << error.what();
    }
  }
}

// Three convolutions are too short for a column: the lowest load with one wave around tilts them
// against each other, long before Haringx's, and far above EJMA's limit, where the wall yields.
TEST(OperatingState, InPlaneSquirm) {
  const auto squirming = [](int around, int fine) {
    Case data = without_modes(
        verification_case("bellows_a", {.around = around, .arc = fine, .wall = fine}));
    bellows_of(data).profile[0].count = 3;
    data.analyses.statics = false;
    data.analyses.error_bars = false;
    data.state.emplace();
    data.state->pressure = 1e6;
    data.state->buckling = 12;
    data.state->yield = 400e6;
    return run_silently(data);
  };
  const Results results = squirming(40, 3);
  const double limit = pressure_limit(results, SquirmKind::elastic_in_plane);
  const double area = M_PI * 0.0305 * 0.0305, span = 0.018;
  EXPECT_GT(limit, 0);
  EXPECT_LT(limit, 4 * M_PI * M_PI * 1.5367 / (span * span) / area);
  EXPECT_LT(limit, pressure_limit(results, SquirmKind::elastic_column));
  EXPECT_GT(limit, 10 * pressure_limit(results, SquirmKind::in_plane));
  EXPECT_NEAR(pressure_limit(squirming(48, 4), SquirmKind::elastic_in_plane) / limit, 1, 0.02);
}

// Stretched and under pressure: by symmetry and on the full mesh the same.
TEST(OperatingState, BothRoutesAgree) {
  Case data = verification_case("bellows_a", {.around = 12, .arc = 2, .wall = 2}, 6);
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.error_bars = false;
  data.state.emplace();
  data.state->pressure = 2e5;
  data.state->offset = {{.cap = "right", .move = {0, 2e-3, 0}}};
  const Results symmetric = run_silently(data);
  data.analyses.symmetry = Symmetry::off;
  const Results full = run_silently(data);
  EXPECT_EQ(symmetric.state->route, "rotational symmetry");
  EXPECT_EQ(full.state->route, "full mesh");
  for (std::size_t i = 0; i < symmetric.modes.size(); ++i)
    EXPECT_NEAR(symmetric.modes[i].frequency / full.modes[i].frequency, 1, 1e-8);
  EXPECT_NEAR(symmetric.statics->k_axial / full.statics->k_axial, 1, 1e-8);
  EXPECT_NEAR(reaction(symmetric, "right").force[1] / reaction(full, "right").force[1], 1, 1e-8);
}

// Pulled by 1e-4 of its length between its ends, a bar bears EA 1e-4.
TEST(OperatingState, InstalledStretched) {
  Case data = tube(2);
  data.analyses.statics = false;
  data.state.emplace();
  data.state->offset = {{.cap = "right", .move = {0, 1e-4 * L, 0}}};
  const Results results = run_silently(data);
  EXPECT_NEAR(reaction(results, "right").force[1], -EA * 1e-4, 1e-6 * EA * 1e-4);
}

// A state in which nothing acts is the part at rest, to the bit.
TEST(OperatingState, NothingActs) {
  Case data = verification_case("bellows_a", {.around = 12, .arc = 2, .wall = 2}, 4);
  data.analyses.error_bars = false;
  const Results rest = run_silently(data);
  data.state.emplace();
  data.state->offset = {{.cap = "left", .move = {0, 0, 0}}};
  const Results still = run_silently(data);
  ASSERT_TRUE(still.state);
  EXPECT_EQ(still.state->displacement.norm(), 0);
  ASSERT_EQ(still.modes.size(), rest.modes.size());
  for (std::size_t i = 0; i < rest.modes.size(); ++i)
    EXPECT_EQ(still.modes[i].frequency, rest.modes[i].frequency);
}

// Beyond squirm there is no state, and the error says how far it came.
TEST(OperatingState, BeyondBuckling) {
  Case data = tube(2);
  data.analyses.statics = false;
  data.state.emplace();
  const double euler = 4 * M_PI * M_PI * EI / (L * L);
  data.state->offset = {{.cap = "right", .move = {0, -1.3 * euler / EA * L, 0}}};
  try {
    run_silently(data);
    FAIL();
  } catch (const StateError& error) {
    EXPECT_NE(std::string(error.what()).find("loses its stability"), std::string::npos);
  }
}

// A superelement around a state: what rigid rotations raise is what the end forces turned raise,
// and its stiffness and frequencies are those of the part in that state.
TEST(OperatingState, SuperelementAroundAState) {
  Case data = verification_case("bellows_a", {.around = 12, .arc = 2, .wall = 2}, 4);
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.error_bars = false;
  data.state.emplace();
  data.state->pressure = 1e5;
  data.state->offset = {{.cap = "right", .move = {0, 1e-3, 0}}};
  for (const bool by_symmetry : {true, false}) {
    if (!by_symmetry) {
      data.analyses.symmetry = Symmetry::off;
      data.state->offset[0].move = {5e-4, 1e-3, 0};
    }
    const ReducedCase r =
        reduce_case(data, {.cutoff = 3000, .boundary = {}}, [](const std::string&) {});
    EXPECT_TRUE(r.certificate.passed)
        << (r.certificate.failures.empty() ? "" : r.certificate.failures.front());
    EXPECT_TRUE(r.proved) << r.reason;
    EXPECT_TRUE(r.certificate.preloaded);
    EXPECT_LT(r.certificate.statics, 1e-7);
    // The preload is there: a rotation raises forces, far above the rounding of the check.
    const Eigen::MatrixXd raised = r.element.K * rigid_motions(r.element, r.element.nodes.front());
    EXPECT_GT(raised.rightCols(3).cwiseAbs().maxCoeff(), 10);
    // Both ends held, it has the modes of the run around the state.
    const Results run = run_silently(data);
    const Eigen::Index m = r.element.modal();
    const double f = std::sqrt(r.element.K.diagonal().tail(m).minCoeff()) / (2 * M_PI);
    EXPECT_NEAR(f / run.modes[0].frequency, 1, 1e-6);
    EXPECT_NEAR(r.element.nodes[1].y() - r.element.nodes[0].y(), 0.06 + 1e-3, 1e-9);
  }
}

// Weight would turn with the part, and an end held inside has its force within.
TEST(OperatingState, SuperelementRefusesWhatActsInside) {
  Case data = verification_case("bellows_a", {.around = 12, .arc = 1, .wall = 1}, 4);
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.state.emplace();
  data.state->gravity = {0, 0, -9.81};
  const auto quietly = [](const std::string&) {};
  EXPECT_THROW(reduce_case(data, {.cutoff = 500, .boundary = {}}, quietly), InputError);
  data.state->gravity = {};
  EXPECT_THROW(reduce_case(data, {.cutoff = 500, .boundary = {"left"}}, quietly), InputError);
}

// EJMA's column squirm has the margin 0.34 / 2 of the same column; the shells lie beside it.
TEST(OperatingState, SquirmBesideEjma) {
  Case data = without_modes(verification_case("bellows_a", {.around = 24, .arc = 2, .wall = 2}));
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  data.state.emplace();
  data.state->pressure = 1e5;
  data.state->yield = 400e6;
  const Results results = run_silently(data);
  ASSERT_EQ(results.state->squirm.size(), 2u);
  const Bellows& bellows = bellows_of(data);
  const EjmaBellows ejma =
      std::get<EjmaBellows>(ejma_bellows(bellows, data.materials.at(bellows.material)));
  const EjmaFactors factors = ejma_factors(ejma);
  EXPECT_EQ(results.state->squirm[0].kind, SquirmKind::column);
  EXPECT_NEAR(results.state->squirm[0].factor, ejma_column_squirm(ejma, factors) / 1e5, 1e-9);
  EXPECT_EQ(results.state->squirm[1].kind, SquirmKind::in_plane);
  EXPECT_NEAR(results.state->squirm[1].limit, ejma_in_plane_squirm(ejma, factors, 400e6), 1e-3);
}

// Named states: each is the case with that state.
TEST(OperatingState, NamedStates) {
  const Case data =
      read_case(std::string(PLICA_SOURCE_DIR) + "/cases/states_a2/states_a2.yaml").data;
  ASSERT_EQ(data.states.size(), 7u);
  const Case hot = in_state(data, "hot");
  ASSERT_TRUE(hot.state);
  EXPECT_EQ(hot.state->name, "hot");
  EXPECT_EQ(hot.state->temperature.at(0).at, 450);
  EXPECT_TRUE(hot.states.empty());
  EXPECT_NE(test::error_of([&] { in_state(data, "hott"); }).find("did you mean 'hot'"),
            std::string::npos);
}

// The summary puts their headline beside that at rest, with its change.
TEST(OperatingState, StatesBesideOneAnother) {
  Results results;
  results.model.mass = 2;
  results.statics.emplace();
  results.statics->k_axial = 50e3;
  VariantResult hot{.name = "hot",
                    .set = {},
                    .headline = {{"k_axial", 40e3}, {"mass", 2}},
                    .comparison = {},
                    .state = StateResult{}};
  hot.state->name = "hot";
  hot.state->loads = {"bellows at 450 degC"};
  results.variants = {hot};
  const std::string text = summary_text(results, {});
  EXPECT_NE(text.find("States, their change"), std::string::npos) << text;
  EXPECT_NE(text.find("-20.00"), std::string::npos) << text;
  EXPECT_NE(text.find("bellows at 450 degC"), std::string::npos) << text;
}

// Poisson's ratio over the temperature: a plate that carries along one axis does not feel it, a
// cylinder under pressure between rigid ends does: nu p r / t pulls at them.
TEST(OperatingState, PoissonsRatioOverTemperature) {
  const LongCylinder c;
  Case data = cylinder(c.L, c.r, c.t);
  Material& steel = data.materials["steel"];
  steel.E_over_temperature = {{0, 200e9}, {600, 200e9}};
  steel.expansion = {{0, 0}, {600, 0}};
  steel.nu_over_temperature = {{20, 0.3}, {520, 0.2}};
  data.state.emplace();
  data.state->pressure = c.p;
  data.state->temperature = {{.part = "bellows", .at = 520}};
  const Results results = run_silently(data);
  const double nu = 0.2, hoop = c.p * c.r / c.t, thrust = c.p * M_PI * c.r * c.r;
  const double edge = 2 * std::sqrt(c.r * c.t) / std::pow(3 * (1 - nu * nu), 0.25);
  const double s = nu * hoop * (1 - edge / c.L) / (1 - nu * nu * edge / c.L);
  EXPECT_NEAR(reaction(results, "right").force[1] / (thrust - 2 * M_PI * c.r * c.t * s), 1, 0.01);
}
