// Decks of cases in their state: what CalculiX makes of the static step, and of the modes around
// it.
#include "model/description/steels.hpp"
#include "run/routes/state_loads.hpp"
#include "tests/calculix_frequencies.hpp"
#include "tests/pipe_case.hpp"
#include "tests/support/refusal.hpp"

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

// A pipe of 0.3 m between two held caps, watched at its middle.
Case held_pipe(double wall) {
  Case data = pipe_of({wall});
  bellows_of(data).material = "1.4301";
  add_known_steels(data.parts, data.materials);
  data.sensors = {{.name = "mid", .at = {0.03, 0.15, 0}}};
  data.analyses.modes = Modes{.count = 4, .band = {}};
  data.state.emplace();
  return data;
}

// Its right cap is a lopsided body on springs.
Case sprung_pipe() {
  Case data = held_pipe(2e-3);
  data.caps[1].mass = 1.5;
  data.caps[1].inertia = {2e-3, 1e-3, 3e-3, 2e-4, 0, 0};
  data.caps[1].offset = {0.01, 0.02, 0};
  data.mount[1] = {
      .cap = "right", .kind = MountKind::springs, .stiffness = {1e6, 2e6, 5e5, 0, 3e3, 0}};
  data.sensors = {{.name = "end", .at = {0.03, 0.3, 0}}};
  return data;
}

std::string deck_in_state(const Case& data) {
  BuiltCase built = build(data);
  StateResult words;
  const StateLoads loads = state_loads(data, built, words);
  return abaqus_model_in_state(data, built, loads);
}

// How far a sensor has moved, as CalculiX prints it at the end of the static step.
Vector3d moved_in(const std::string& printed) {
  const auto at = printed.find("and time  0.1000000E+01");
  if (at == std::string::npos) return Vector3d::Zero();
  std::istringstream fields(printed.substr(printed.find('\n', at)));
  int node = 0;
  Vector3d u;
  fields >> node >> u[0] >> u[1] >> u[2];
  return u;
}

struct Tolerance {
  double moved = 0.01, hertz = 0.005;
};

void expect_like_calculix(const Case& data, const std::string& what, Tolerance within) {
  const Results ours = run_silently(data);
  const std::string printed = calculix_output(deck_in_state(data));
  const std::vector<double> theirs = frequencies_in(printed);
  ASSERT_EQ(theirs.size(), ours.modes.size()) << "CalculiX (ccx) is not installed, or broke off";
  const Vector3d own = ours.state->displacement.row(build(data).sensors.front().node);
  const Vector3d other = moved_in(printed);
  std::printf("| %s | moved by %.5g mm | CalculiX %.5g mm |\n", what.c_str(), 1e3 * own.norm(),
              1e3 * other.norm());
  EXPECT_LT((own - other).norm(), within.moved * own.norm()) << what;
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    std::printf("| %s, mode %zu | Plica %.2f Hz | CalculiX %.2f Hz |\n", what.c_str(), k + 1,
                ours.modes[k].frequency, theirs[k]);
    EXPECT_NEAR(ours.modes[k].frequency / theirs[k], 1, within.hertz) << what << ", " << k;
  }
}

TEST(AbaqusDeckInState, of_held_ends_that_are_moved_and_turned) {
  Case data = held_pipe(2e-3);
  data.state->offset = {
      {.cap = "right", .move = {2e-4, 1e-4, 0}, .turn = {0.2 * pi / 180, 0, 0.3 * pi / 180}}};
  expect_like_calculix(data, "held ends moved and turned", {});
}

TEST(AbaqusDeckInState, hot_between_held_ends) {
  Case data = held_pipe(2e-3);
  data.state->temperature = {{.part = "bellows", .along = {{0, 300}, {0.3, 100}}}};
  expect_like_calculix(data, "300 to 100 degC between held ends", {});
}

TEST(AbaqusDeckInState, hot_with_an_end_on_springs) {
  Case data = sprung_pipe();
  data.state->temperature = {{.part = "bellows", .at = 300}};
  expect_like_calculix(data, "hot, one end on springs", {});
}

TEST(AbaqusDeckInState, of_forces_and_of_ground_that_moves) {
  Case data = sprung_pipe();
  data.state->force = {{.cap = "right", .force = {0, 2e4, 500}, .moment = {100, 0, 0}}};
  data.state->offset = {{.cap = "right", .move = {1e-3, -1e-3, 0}}};
  expect_like_calculix(data, "forces, ground moved", {});
}

TEST(AbaqusDeckInState, of_weight) {
  Case data = sprung_pipe();
  data.state->gravity = {0, 0, -981};
  expect_like_calculix(data, "weight", {.moved = 0.015});
}

// CalculiX presses on the inner face of the wall, we on its middle: of a wall of 0.2 mm the thrust
// on the caps and the hoop stress, which nearly balance along the pipe, differ by 0.7 % of each.
TEST(AbaqusDeckInState, of_pressure_with_its_thrust) {
  Case data = sprung_pipe();
  bellows_of(data).wall.plies = {2e-4};
  data.analyses.modes->count = 2;
  data.state->pressure = 1e5;
  expect_like_calculix(data, "pressure", {.moved = 0.03});
}

std::string refusal(const Case& data) {
  return error_of([&] { deck_in_state(data); });
}

TEST(AbaqusDeckInState, names_what_it_cannot_hold) {
  Case turned = sprung_pipe();
  turned.state->offset = {{.cap = "right", .turn = {0.01, 0, 0}}};
  EXPECT_NE(refusal(turned).find("state.offset.right.turn: is not possible in a deck"),
            std::string::npos)
      << refusal(turned);
  Case followed = held_pipe(2e-3);
  followed.state->follow = true;
  EXPECT_NE(refusal(followed).find("state.follow: is not possible in a deck"), std::string::npos);
  Case jointed = held_pipe(2e-3);
  add_liner(jointed, Attachment::caps);
  auto& liner = std::get<Interlock>(jointed.parts.back().body);
  liner.friction.emplace().axial.emplace().iwan = IwanLaw<false>{1e4, 5, -0.5, 1, 0, 10};
  EXPECT_NE(refusal(jointed).find("joints that have friction"), std::string::npos)
      << refusal(jointed);
}

} // namespace
} // namespace plica::test
