// Rings clamped round a wall: rigid, soft, absent.
#include "diagnose/predict/nominal.hpp"
#include "io/files/files.hpp"
#include "io/input/case_file.hpp"
#include "run/analyses/run.hpp"
#include "tests/steel_plate.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/input_error.hpp"
#include "words/mode_kinds.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

// A bellows of two convolutions with a ring on its middle root.
Case ringed(const std::string& ring) {
  const std::string text = R"(
case: ringed
materials: {steel: {E: 193 GPa, nu: 0.3, rho: 8000}}
parts:
  bellows:
    type: bellows
    material: steel
    root_radius: 40 mm
    profile: [{shape: U, count: 2, height: 6 mm, pitch: 6 mm}]
    wall: {plies: [0.4 mm]}
    mesh: {around: 24, arc: 3, wall: 2}
)" + ring + R"(
caps: {left: {of: bellows.left}, right: {of: bellows.right}}
mount: {left: rigid, right: rigid}
analyses: {modes: {count: 40}}
)";
  const TemporaryFolder folder("ringed");
  write_whole(folder.path / "ringed.yaml", text);
  return read_case((folder.path / "ringed.yaml").string()).data;
}

constexpr const char* heavy = "  ring: {type: mass, at: 'bellows.root[2]', mass: 0.2 kg";

// The lowest frequency of a kind, of so many waves around; 0 = none was found.
double lowest(const Results& results, const std::string& shape, int harmonic) {
  for (const ModeResult& mode : results.modes)
    if (mode.shape == shape && mode.harmonic == harmonic) return mode.frequency;
  return 0;
}

// The mean motion of a circle is nil where it goes out of round by two waves: a soft ring leaves
// these modes as they are, exactly, and a rigid one holds the root. Along the axis both weigh, and
// the rigid one holds the wall besides: no constraint makes a frequency lower (Rayleigh).
TEST(Rings, a_soft_one_lets_the_wall_go_out_of_round_and_a_rigid_one_does_not) {
  const auto run_of = [](const std::string& ring) {
    return run(ringed(ring), [](const std::string&) {});
  };
  const Results bare = run_of(""), soft = run_of(std::string(heavy) + ", soft: true}"),
                rigid = run_of(std::string(heavy) + "}");
  const double out_of_round = lowest(bare, mode_kind::shell, 2);
  ASSERT_GT(out_of_round, 0);
  EXPECT_NEAR(lowest(soft, mode_kind::shell, 2) / out_of_round, 1, 1e-7);
  const double held = lowest(rigid, mode_kind::shell, 2);
  EXPECT_TRUE(held == 0 || held > 1.1 * out_of_round) << held << " and " << out_of_round;
  const double axial = lowest(bare, mode_kind::axial, 0);
  EXPECT_LT(lowest(soft, mode_kind::axial, 0), lowest(rigid, mode_kind::axial, 0));
  EXPECT_LT(lowest(rigid, mode_kind::axial, 0), 0.8 * axial);
}

// In a state of a test that sets its mass to nothing the ring is not there.
TEST(Rings, one_without_mass_is_not_there) {
  const Case with = ringed(std::string(heavy) + "}");
  Measured m;
  m.specimen = "ringed";
  m.states.emplace_back().name = "bare";
  m.states.front().numbers = {{"parts.ring.mass", 0}};
  const Nominal nominal = nominal_of(with, m), without = nominal_of(ringed(""), {});
  const auto& own = nominal.state("bare").model->lambda();
  const auto& bare = without.state("").model->lambda();
  constexpr int compared = 8;
  for (int k = 0; k < compared; ++k) EXPECT_NEAR(own[k] / bare[k], 1, 1e-8) << k;
  EXPECT_LT(nominal.state("").model->lambda()[0] / bare[0], 0.9);
}

Case plate_with_bar(double mass, bool soft) {
  Case c = steel_plate({{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}, {0, 0.2, 0}}}, {4, 4});
  PointMass bar;
  bar.at = "plate.edge2";
  bar.mass = mass;
  bar.soft = soft;
  c.parts.push_back({"bar", bar});
  return c;
}

// Nodes on a line have no mean turning.
TEST(Rings, a_bar_on_an_edge_may_be_absent_and_cannot_be_soft) {
  const BuiltCase with = build(plate_with_bar(0.1, false)),
                  without = build(plate_with_bar(0, true));
  EXPECT_EQ(with.model.mesh.nodes.size(), without.model.mesh.nodes.size());
  EXPECT_EQ(with.mass_nodes.at("bar"), without.mass_nodes.at("bar"));
  EXPECT_LT(without.model.constraints.size(), with.model.constraints.size());
  try {
    build(plate_with_bar(0.1, true));
    FAIL() << "a line is no circle";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("parts.bar.soft"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace plica::test
