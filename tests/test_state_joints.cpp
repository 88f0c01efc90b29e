// Joints with friction, clearance and nonlinear springs in a state: what takes up the state, and
// vibration around it.
#include "compare/compare_stiffness.hpp"
#include "run/study/part_stiffness.hpp"
#include "solve/harmonic_balance.hpp"
#include "tests/bellows_case.hpp"
#include "tests/sliding_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

constexpr double g = 9.80665;

Case chain_pulled_by(double stretch) {
  Case data = sliding_chain();
  data.sensors = {{.name = "mid", .at = {0, 0.1, 0}}};
  data.analyses.error_bars = false;
  data.analyses.modes = Modes{.count = 3};
  data.analyses.damping.modal = 0.01;
  if (stretch == 0) return data;
  data.state.emplace();
  data.state->offset = {{.cap = "right", .move = {0, stretch, 0}}};
  return data;
}

double frequency(const Results& results, const std::string& shape) {
  for (const ModeResult& m : results.modes)
    if (m.shape == shape) return m.frequency;
  throw std::out_of_range(shape);
}

// Each of two elements goes half the way: 20 kN/m of it and the 3 N of its slider.
TEST(StateJoints, friction_bears_its_slip_force_beside_the_spring) {
  const Results results = run_silently(chain_pulled_by(4e-4));
  const StateResult& state = *results.state;
  EXPECT_NEAR(std::abs(state.reactions[1].force[1]), 2e4 * 2e-4 + 3, 1e-6);
  ASSERT_EQ(state.joints.size(), 2);
  for (const StateJointResult& j : state.joints) {
    EXPECT_NEAR(j.motion, 2e-4, 1e-10);
    EXPECT_NEAR(j.force, 3, 1e-9);
    EXPECT_EQ(j.slipped, 1);
  }
  // Small motion sticks again, wherever the joint is; a rig slips.
  EXPECT_NEAR(frequency(results, "axial") / (std::sqrt(2 * 8e4 / 0.5) / (2 * pi)), 1, 1e-6);
  EXPECT_NEAR(results.statics->k_axial / 1e4, 1, 1e-6);
  EXPECT_NEAR(results.slipping->k_axial_stuck / 4e4, 1, 1e-6);
}

TEST(StateJoints, friction_that_sticks_bears_as_a_spring) {
  const StateResult state = *run_silently(chain_pulled_by(8e-5)).state;
  EXPECT_NEAR(std::abs(state.reactions[1].force[1]), 8e4 * 4e-5, 1e-6);
  EXPECT_EQ(state.joints[0].slipped, 0);
}

// Pulled on, sliders that have slipped go on slipping; pushed back, they stick over twice their
// slip displacement of 0.05 mm.
TEST(StateJoints, the_stroke_from_the_state_is_not_the_same_both_ways) {
  const Results results = run_silently(chain_pulled_by(4e-4));
  ASSERT_FALSE(results.strokes.empty());
  const auto force = [&](double by) {
    const auto& p = results.strokes[0].points;
    const auto above =
        std::find_if(p.begin(), p.end(), [&](const auto& point) { return point[0] >= by; });
    const auto &a = *(above - 1), &b = *above;
    return a[1] + (by - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
  };
  EXPECT_NEAR(force(1e-4) / 1e-4, 1e4, 20);
  EXPECT_NEAR(force(-1e-4) / -1e-4, 4e4, 100);
  EXPECT_NEAR(force(-4e-4), -(1e4 * 4e-4 + 6), 0.02); // both have slipped the other way
}

// The mass moves against both sliders, which are at their slip force in the same direction: by
// Masing's rule the loops are those of the chain at rest, and so are the responses.
TEST(StateJoints, levels_of_sliders_are_those_at_rest) {
  Levels levels;
  levels.bases = {1};
  levels.levels = {2, 8};
  levels.band = {20, 120};
  levels.harmonics = 5;
  levels.backbones = 0;
  Case at_rest = chain_pulled_by(0), pulled = chain_pulled_by(4e-4);
  at_rest.analyses.levels = pulled.analyses.levels = levels;
  const Results a = run_silently(at_rest), b = run_silently(pulled);
  for (std::size_t k = 0; k < 2; ++k) {
    const LevelPeak &p = a.level_responses[0].curves[k].peaks_up.at(0),
                    &q = b.level_responses[0].curves[k].peaks_up.at(0);
    EXPECT_NEAR(q.frequency / p.frequency, 1, 1e-4) << k;
    EXPECT_NEAR(q.amplitude / p.amplitude, 1, 1e-3) << k;
  }
  for (const RefereeCheck& r : b.level_responses[0].referee) {
    EXPECT_TRUE(r.settled);
    EXPECT_LT(r.difference, 0.01);
  }
}

// A stiff rod of 1 kg upright on a mount of 10 kN/m along y.
Case rod_on(const FrictionLaw<false>& law, double gravity) {
  ConnectorChain rod;
  rod.length = 0.1;
  rod.count = 1;
  rod.spring = {.axial = 1e9, .transverse = 1e9, .bending = 1e7, .torsion = 1e7};
  rod.mass = 1;
  Case data;
  data.name = "rod";
  data.parts.push_back({"rod", rod});
  data.caps = {{.name = "foot", .of = {"rod.left"}}, {.name = "head", .of = {"rod.right"}}};
  JointFriction friction;
  friction.y = law;
  data.mount = {{.cap = "foot",
                 .kind = MountKind::springs,
                 .stiffness = {1e8, 1e4, 1e8, 1e6, 1e6, 1e6},
                 .friction = friction}};
  data.sensors = {{.name = "head", .at = {0, 0.1, 0}}};
  data.analyses.error_bars = false;
  data.analyses.statics = false;
  data.analyses.modes = Modes{.count = 1};
  data.analyses.damping.modal = 0.02;
  data.state.emplace();
  data.state->gravity = {0, -gravity, 0};
  return data;
}

// 40 kN/m beyond half a millimetre.
const FrictionLaw<false> clearance = [] {
  FrictionLaw<false> law;
  law.clearance = {.gap = 5e-4, .stiffness = 4e4};
  return law;
}();

TEST(StateJoints, weight_takes_up_a_clearance) {
  const Results light = run_silently(rod_on(clearance, g / 10)),
                heavy = run_silently(rod_on(clearance, g));
  EXPECT_NEAR(light.modes[0].frequency / (std::sqrt(1e4) / (2 * pi)), 1, 1e-4);
  EXPECT_NEAR(heavy.modes[0].frequency / (std::sqrt(5e4) / (2 * pi)), 1, 1e-4);
  const double down = (g + 4e4 * 5e-4) / 5e4;
  EXPECT_NEAR(heavy.state->joints.at(0).motion / -down, 1, 1e-6);
  EXPECT_NEAR(heavy.state->joints.at(0).force / (-4e4 * (down - 5e-4)), 1, 1e-6);
  EXPECT_NEAR(heavy.state->reactions.at(0).force[1] / -g, 1, 1e-6);
}

// k x + c x^3 = m g; f by k + 3 c x^2.
TEST(StateJoints, weight_stiffens_a_cubic_spring) {
  const double c = 2e10;
  FrictionLaw<false> law;
  law.cubic = c;
  const Results results = run_silently(rod_on(law, g));
  double x = 0;
  for (int k = 0; k < 50; ++k) x -= (1e4 * x + c * x * x * x - g) / (1e4 + 3 * c * x * x);
  EXPECT_NEAR(results.state->joints.at(0).motion / -x, 1, 1e-6);
  EXPECT_NEAR(results.modes[0].frequency / (std::sqrt(1e4 + 3 * c * x * x) / (2 * pi)), 1, 1e-4);
}

// x'' + 2 zeta w0 x' + 10^4 x + F(x) = -g + a cos(w t) over many periods, by Runge and Kutta:
// mean and first harmonic of the motion around the static place.
struct Motion {
  double mean = 0;
  std::complex<double> first;
};
Motion in_time(double at_rest, double damping, double a, double omega) {
  constexpr int steps = 4000, periods = 400;
  const double h = 2 * pi / omega / steps;
  double x = at_rest, v = 0;
  const auto acceleration = [&](double t, double x_now, double v_now) {
    const double beyond = std::abs(x_now) > 5e-4 ? 4e4 * (std::abs(x_now) - 5e-4) : 0;
    return -g + a * std::cos(omega * t) - damping * v_now - 1e4 * x_now -
           std::copysign(beyond, x_now);
  };
  Motion m;
  for (int p = 0; p < periods; ++p) {
    m = {};
    for (int k = 0; k < steps; ++k) {
      const double t = (p * steps + k) * h;
      m.mean += (x - at_rest) / steps;
      m.first += 2. * (x - at_rest) / steps * std::polar(1., -2 * pi * k / steps);
      const double k1 = v, l1 = acceleration(t, x, v);
      const double k2 = v + h / 2 * l1, l2 = acceleration(t + h / 2, x + h / 2 * k1, k2);
      const double k3 = v + h / 2 * l2, l3 = acceleration(t + h / 2, x + h / 2 * k2, k3);
      const double k4 = v + h * l3, l4 = acceleration(t + h, x + h * k3, k4);
      x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
  }
  return m;
}

// The mass leaves the stop in part of the period: the motion has a mean, which is an unknown.
TEST(StateJoints, harmonic_balance_around_the_state_has_a_mean) {
  const double down = -(g + 20) / 5e4, w0 = std::sqrt(5e4), zeta = 0.02;
  JointedStructure s{.lambda = VectorXd::Constant(1, 5e4),
                     .zeta = VectorXd::Constant(1, zeta),
                     .eta = VectorXd::Zero(1),
                     .joints = Eigen::MatrixXd::Ones(1, 1),
                     .input = VectorXd::Ones(1),
                     .laws = {{.stiffness = -4e4,
                               .curve = {{-2e-3, -60}, {-5e-4, 0}, {5e-4, 0}, {2e-3, 60}},
                               .offset = down}}};
  HarmonicSettings settings{.harmonics = 12, .samples = 1024};
  for (const auto& [share, level] : {std::pair{0.5, 8.}, {0.6, 5.}, {1.3, 12.}}) {
    const double omega = share * w0;
    settings.from = settings.to = omega;
    const PeriodicSolution found = periodic_response(s, omega, level, settings);
    ASSERT_TRUE(found.converged) << share;
    EXPECT_EQ(found.orders.front(), 0);
    const Motion m = in_time(down, 2 * zeta * w0, level, omega);
    const std::complex<double> first = found.point.joints(1, 0);
    EXPECT_LT(std::abs(first - m.first), 2e-3 * std::abs(m.first)) << share;
    EXPECT_NEAR(found.point.joints(0, 0).real(), m.mean, 2e-3 * std::abs(m.first)) << share;
    EXPECT_GT(std::abs(m.mean), 0.01 * std::abs(m.first)) << share;
  }
}

// The same through a case, with integration in time as its referee.
TEST(StateJoints, levels_around_a_taken_up_clearance) {
  Case data = rod_on(clearance, g);
  Levels levels;
  levels.forces.push_back(
      {.name = "push", .at = "rod.right", .direction = 1, .levels = {0.01, 0.25}});
  levels.band = {25, 45};
  levels.harmonics = 9;
  levels.backbones = 0;
  data.analyses.levels = levels;
  const Results results = run_silently(data);
  const LevelResponses& r = results.level_responses.at(0);
  ASSERT_EQ(r.curves.size(), 2);
  for (const LevelCurve& c : r.curves) EXPECT_TRUE(c.complete) << c.reason;
  ASSERT_FALSE(r.referee.empty());
  for (const RefereeCheck& check : r.referee) {
    EXPECT_TRUE(check.settled);
    EXPECT_LT(check.difference, 0.01);
  }
  // In small motion the rod stays on its stop; at 0.25 N its peak would lie at 0.13 mm, 0.03 mm
  // beyond it: it leaves, and its mean and frequency fall.
  EXPECT_GT(r.curves[1].joints.at(0).mean, 0);
  EXPECT_LT(r.curves[1].peaks_up.at(0).frequency, 0.99 * r.curves[0].peaks_up.at(0).frequency);
  EXPECT_LT(std::abs(r.curves[0].joints.at(0).mean), 1e-6 * r.curves[0].joints.at(0).motion);
}

// A bellows stretched over a liner that slips: by symmetry as on the whole mesh.
TEST(StateJoints, do_not_depend_on_the_route) {
  Case data = verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2}, 4);
  Interlock liner;
  liner.along = "bellows";
  liner.attachment = Attachment::caps;
  liner.EA = liner.EI = liner.GJ = 100;
  liner.mass = 0.05;
  liner.radius = 0.01;
  liner.friction.emplace();
  liner.friction->axial.emplace().sliders = {{2e5, 2}};
  liner.friction->bending.emplace().sliders = {{20, 0.1}};
  data.parts.push_back({"interlock", liner});
  data.mount = {{.cap = data.caps[0].name}, {.cap = data.caps[1].name}};
  data.analyses.error_bars = false;
  data.state.emplace();
  data.state->offset = {{.cap = data.caps[1].name, .move = {0, 1e-3, 0}}};
  data.analyses.symmetry = Symmetry::off;
  const Results full = run_silently(data);
  data.analyses.symmetry = Symmetry::required;
  const Results cyclic = run_silently(data);
  ASSERT_EQ(cyclic.state->route, "rotational symmetry");
  for (std::size_t k = 0; k < full.modes.size(); ++k)
    EXPECT_NEAR(cyclic.modes[k].frequency / full.modes[k].frequency, 1, 1e-6) << k;
  EXPECT_NEAR(cyclic.statics->k_axial / full.statics->k_axial, 1, 1e-6);
  ASSERT_EQ(cyclic.state->joints.size(), full.state->joints.size());
  for (std::size_t j = 0; j < full.state->joints.size(); ++j)
    EXPECT_NEAR(cyclic.state->joints[j].motion, full.state->joints[j].motion, 1e-9) << j;
}

// Offsets of a part with a clearance: at rest the rod is free in its gap, moved by 0.6 mm it
// bears.
TEST(StateJoints, dynamic_stiffness_has_the_slope_at_the_offset) {
  Case data = sliding_chain();
  auto& chain = std::get<ConnectorChain>(data.parts[0].body);
  chain.friction.emplace().axial.emplace() = clearance;
  StiffnessRequest request;
  request.hertz = VectorXd::Zero(1);
  request.shifts = {{}, {.direction = 1, .value = -1.2e-3}};
  request.levels = {{.translation = 1e-5}};
  const EndDynamicStiffness s = part_stiffness(data, request, [](const std::string&) {});
  ASSERT_EQ(s.states.size(), 2);
  for (std::size_t level : {0, 1}) {
    EXPECT_NEAR(transfer_stiffness(s.states[0].over.at[level][0], 1).real() / 1e4, 1, 1e-6);
    EXPECT_NEAR(transfer_stiffness(s.states[1].over.at[level][0], 1).real() / 3e4, 1, 1e-6);
  }
}

// The axes of a joint turn with its first node: a chain turned as a whole has the modes it had.
TEST(StateJoints, turn_with_the_part) {
  Case data = chain_pulled_by(4e-4);
  const Results straight = run_silently(data);
  data.state->offset[0].turn = {0, 0, 0};
  const double angle = 0.5; // about x through the left end: the right goes along the circle
  const double L = 0.2 + 4e-4;
  data.state->offset = {{.cap = "right",
                         .move = {0, L * std::cos(angle) - 0.2, L * std::sin(angle)},
                         .turn = {angle, 0, 0}},
                        {.cap = "left", .move = {0, 0, 0}, .turn = {angle, 0, 0}}};
  const Results turned = run_silently(data);
  for (std::size_t k = 0; k < straight.modes.size(); ++k)
    EXPECT_NEAR(turned.modes[k].frequency / straight.modes[k].frequency, 1, 1e-6) << k;
  for (std::size_t j = 0; j < 2; ++j)
    EXPECT_NEAR(turned.state->joints[j].motion, straight.state->joints[j].motion, 1e-9);
}

} // namespace
} // namespace plica::test
