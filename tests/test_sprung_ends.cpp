// Ends that hang on springs of their own at their cap.
#include "model/description/steels.hpp"
#include "run/routes/state_loads.hpp"
#include "tests/bolted_plate.hpp"
#include "tests/changed_beam.hpp"
#include "tests/pipe_case.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using namespace changed_beam;
using std::numbers::pi;

constexpr Sextuple rigid{1e11, 1e11, 1e11, 1e9, 1e9, 1e9}; // beside a beam of half a metre

void expect_same(const Case& a, const Case& b, std::size_t count, double tolerance) {
  const Results first = test::run_silently(a), second = test::run_silently(b);
  ASSERT_GE(first.modes.size(), count);
  for (std::size_t j = 0; j < count; ++j)
    EXPECT_NEAR(second.modes[j].frequency / first.modes[j].frequency, 1, tolerance) << j;
}

Case on_end(Case c, const Sextuple& springs) {
  Cap& joint = c.caps.back();
  joint.stiffness.reset();
  joint.ends = {{.end = joint.of.back(), .stiffness = springs}};
  return c;
}

TEST(SprungEnds, of_two_in_one_place_are_the_springs_of_their_cap) {
  const Sextuple springs{2e6, 3e6, 5e6, 4e3, 2e3, 7e3};
  expect_same(two_halves(springs), on_end(two_halves({}), springs), 6, 1e-9);
}

// A beam of 0.6 m that one cap holds at both ends.
Case held_at_both(std::vector<SprungEnd> ends = {}) {
  Case c = beam_of(4, 0.6, 0.025, 0.012, false);
  Cap table;
  table.name = "table";
  table.of = {"beam.start", "beam.end"};
  table.ends = std::move(ends);
  c.caps.push_back(table);
  c.mount.push_back({.cap = "table"});
  return c;
}

// Euler's beam, clamped at one end, its other one held and turning against k, g = EI / (k L):
// g b (sinh b cos b - cosh b sin b) + cosh b cos b = 1. Tables: 4.7300 for g = 0, 3.9266 without a
// spring (Blevins, table 8-1).
double lowest_root(double g) {
  const auto f = [&](double b) {
    return g * b * (std::cos(b) - std::sin(b) / std::tanh(b)) + std::cos(b) / std::tanh(b) -
           1 / std::sinh(b);
  };
  double low = 3.5, high = 4.8;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (f(low) * f(middle) > 0 ? low : high) = middle;
  }
  return low;
}

TEST(SprungEnds, of_a_beam_turn_as_textbooks_have_it) {
  EXPECT_NEAR(lowest_root(0), 4.7300, 1e-4);
  EXPECT_NEAR(lowest_root(1e9), 3.9266, 1e-4);
  constexpr double L = 0.6, width = 0.025, depth = 0.012, E = 200e9, rho = 7850;
  constexpr double EI = E * width * depth * depth * depth / 12;
  for (const double g : {0.05, 0.3, 2.}) {
    Sextuple springs = rigid;
    springs[3] = springs[5] = EI / (g * L);
    const Results results =
        test::run_silently(held_at_both({{.end = "beam.end", .stiffness = springs}}));
    const double b = lowest_root(g);
    const double expected = b * b / (2 * pi * L * L) * std::sqrt(EI / (rho * width * depth));
    EXPECT_NEAR(results.modes.at(0).frequency / expected, 1, 3e-3) << g; // shear, turning inertia
  }
}

// The cap swings on its mount with a body off its middle: its arms to both ends are 0.3 m long.
TEST(SprungEnds, that_are_stiff_hold_as_a_rigid_cap_does) {
  const auto swinging = [](std::vector<SprungEnd> ends) {
    Case c = held_at_both(std::move(ends));
    c.mount = {
        {.cap = "table", .kind = MountKind::springs, .stiffness = {1e5, 2e5, 3e5, 2e3, 500, 1e3}}};
    c.caps[0].mass = 0.3;
    c.caps[0].offset = {0.02, 0.05, -0.03};
    return c;
  };
  expect_same(swinging({}),
              swinging({{.end = "beam.start", .stiffness = rigid},
                        {.end = "beam.end", .stiffness = rigid}}),
              8, 1e-4);
}

// One that is loose is as good as none.
TEST(SprungEnds, of_a_bolt_that_is_loose_do_not_hold) {
  constexpr Sextuple loose{1, 1, 1, 1e-3, 1e-3, 1e-3};
  expect_same(test::bolted_plate(3),
              test::bolted_plate(4, {{.end = "plate.bolt4", .stiffness = loose}}), 6, 1e-4);
  std::vector<SprungEnd> tight;
  for (int i = 1; i <= 4; ++i)
    tight.push_back({.end = "plate.bolt" + std::to_string(i), .stiffness = rigid});
  expect_same(test::bolted_plate(4), test::bolted_plate(4, tight), 6, 1e-4);
}

TEST(SprungEnds, slip_and_damp_as_a_cap_does) {
  const Sextuple springs{2e6, 3e6, 5e6, 4e3, 2e3, 7e3};
  Case of_cap = two_halves(springs), of_end = on_end(two_halves({}), springs);
  JointFriction slip;
  slip.rx.emplace().sliders = {{.stiffness = 1e3, .slip_force = 2}};
  SpringDamping loss;
  loss.loss_factor = 0.02;
  of_cap.caps.back().friction = of_end.caps.back().ends[0].friction = slip;
  of_cap.caps.back().damping = of_end.caps.back().ends[0].damping = loss;
  const BuiltCase cap = build(of_cap), end = build(of_end);
  ASSERT_EQ(cap.joints.size(), 1U);
  ASSERT_EQ(end.joints.size(), 1U);
  EXPECT_EQ(end.joints[0].place, "caps.joint.beam2.start");
  EXPECT_EQ(end.joints[0].dof, cap.joints[0].dof);
  EXPECT_EQ(end.joints[0].law.stiffness, cap.joints[0].law.stiffness);
  EXPECT_EQ(laws_in(of_end, end.joints)->at(0).stiffness,
            laws_in(of_cap, cap.joints)->at(0).stiffness);
  EXPECT_EQ(end.dampers.size(), cap.dampers.size());
  EXPECT_GT(end.dampers.size(), 0U);
  EXPECT_TRUE(has_friction(of_end));
  EXPECT_TRUE(has_damped_springs(of_end));
}

// Two pipes in a row that meet in a clamp.
Case two_pipes(const std::optional<Sextuple>& joint, bool on_ends) {
  Case pipes = test::pipe_of({1e-3});
  test::bellows_of(pipes).material = "1.4301";
  test::bellows_of(pipes).profile[0].length = 0.15;
  test::bellows_of(pipes).profile[0].elements = 12;
  test::bellows_of(pipes).mesh.wall = 12;
  pipes.parts.push_back(pipes.parts[0]);
  pipes.parts[1].name = "second";
  std::get<Bellows>(pipes.parts[1].body).start = test::bellows_of(pipes).start + 0.15;
  add_known_steels(pipes.parts, pipes.materials);
  Cap clamp;
  clamp.name = "clamp";
  clamp.of = {"bellows.right", "second.left"};
  if (on_ends)
    for (const std::string& end : clamp.of)
      clamp.ends.push_back({.end = end, .stiffness = joint.value()});
  else
    clamp.stiffness = joint;
  pipes.caps[1].of = {"second.right"};
  pipes.caps.push_back(clamp);
  pipes.mount.erase(pipes.mount.begin() + 1, pipes.mount.end());
  pipes.analyses.modes = Modes{.count = 4};
  pipes.state.emplace();
  return pipes;
}

// Both hot: what the clamp holds grows with them on either side of its springs.
TEST(SprungEnds, of_hot_pipes_grow_with_these) {
  const auto hot = [](Case pipes) {
    pipes.state->temperature = {{.part = "bellows", .at = 500}, {.part = "second", .at = 500}};
    return pipes;
  };
  expect_same(hot(two_pipes({}, false)), hot(two_pipes(rigid, false)), 4, 1e-4);
  expect_same(hot(two_pipes({}, false)), hot(two_pipes(rigid, true)), 4, 1e-4);
}

// The cap closes both pipes: what presses on it from one side the other one takes back, and the
// springs carry what the wall of the pipe does.
TEST(SprungEnds, of_pipes_under_pressure_leave_the_thrust_on_the_cap) {
  Case pipes = two_pipes(rigid, true);
  pipes.state->pressure = 1e5;
  BuiltCase built = build(pipes);
  StateResult words;
  state_loads(pipes, built, words);
  Eigen::Vector3d both = Eigen::Vector3d::Zero();
  int count = 0;
  for (const PressedEnd& end : built.model.pressed_ends)
    if (end.node == built.cap_nodes.at("clamp")) {
      both += end.area;
      EXPECT_NEAR(std::abs(end.area.y()) / (pi * 0.03 * 0.03), 1, 0.01);
      ++count;
    }
  EXPECT_EQ(count, 2);
  EXPECT_NEAR(both.norm(), 0, 1e-12);
}

} // namespace
} // namespace plica
