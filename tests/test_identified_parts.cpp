// What several inputs say of one mode; peaks that no mode explains; modes as entries of a test.
#include "tests/synthetic_frf.hpp"

#include "lab/identification/identified_measured.hpp"
#include "lab/identification/identify.hpp"
#include "lab/identification/missed_peaks.hpp"
#include "lab/identification/spread.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

std::vector<TrueMode> three_modes() {
  const auto v = [](double a, double b, double c, double d) {
    return (VectorXd(4) << a, b, c, d).finished();
  };
  return {{60, 0.008, v(0.7, 0.5, 0.9, 1)},
          {100, 0.01, v(1, 0.12, -0.6, 0.4)},
          {150, 0.006, v(0.8, -0.6, 0.5, -0.7)}};
}

const IdentifiedMode* near(const Identification& found, double frequency, double reach) {
  const IdentifiedMode* best = nullptr;
  for (const IdentifiedMode& m : found.modes)
    if (std::abs(m.frequency - frequency) < reach &&
        (!best || std::abs(m.frequency - frequency) < std::abs(best->frequency - frequency)))
      best = &m;
  return best;
}

bool warns_of(const Identification& found, const std::string& words) {
  return std::any_of(found.warnings.begin(), found.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

// The second of two inputs hardly drives the mode at 100 Hz and is noisier than it: fitted alone it
// is off by up to a hertz. The mode is right within a hundredth by the first, and says so.
TEST(Inputs, that_do_not_drive_a_mode_do_not_blur_it) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    FrfSet set = synthetic(three_modes(), FrfQuantity::accelerance, 40, 180, 1401, 2);
    FrfSet noise = set;
    for (Eigen::MatrixXcd& H : noise.H) H.setZero();
    noise.H[0].setConstant(1);
    add_noise(noise, 1, seed);
    const double size = set.H[0].norm() / std::sqrt(double(set.H[0].size()));
    noise.H[0].array() -= 1;
    set.H[0] += 0.01 * size * noise.H[0];
    set.H[1] += 3 * size * noise.H[1];
    const Identification found = identify(set, {});
    const IdentifiedMode* m = near(found, 100, 1);
    ASSERT_NE(m, nullptr) << seed;
    EXPECT_NEAR(m->frequency, 100, 0.01) << seed;
    EXPECT_LT(m->sigma_frequency, 0.01) << seed;
    EXPECT_LT(std::abs(m->frequency - 100), 4 * m->sigma_frequency) << seed;
  }
}

// The structure is 2.5 Hz softer under one excitation than under the other. Two poles fit both,
// each to a thousandth; what is known of the mode is the spread.
TEST(Inputs, that_move_a_mode_are_its_uncertainty) {
  std::vector<TrueMode> shifted = three_modes();
  shifted[1].shape[1] = 0.8; // both drive it
  const FrfSet one = synthetic(shifted, FrfQuantity::accelerance, 40, 180, 1401, 2);
  shifted[1].frequency = 102.5;
  FrfSet set = one;
  set.H[1] = synthetic(shifted, FrfQuantity::accelerance, 40, 180, 1401, 2).H[1];
  add_noise(set, 0.001, 3);
  const Identification found = identify(set, {});
  int seen = 0;
  for (const IdentifiedMode& m : found.modes) {
    if (m.frequency < 98 || m.frequency > 104) continue;
    ++seen;
    EXPECT_GT(m.sigma_frequency, 0.8) << m.frequency;
    EXPECT_LT(m.sigma_frequency, 2.5) << m.frequency;
  }
  EXPECT_GE(seen, 1);
  EXPECT_TRUE(warns_of(found, "one at a time they give"));
  const IdentifiedMode* first = near(found, 60, 1);
  ASSERT_NE(first, nullptr);
  EXPECT_LT(first->sigma_frequency, 0.05); // which both inputs have where it is
}

// Two modes 1 % apart of different shapes, one driven by each input, are two.
TEST(Inputs, leave_close_pairs_apart) {
  const std::vector<TrueMode> modes{{100, 0.003, (VectorXd(4) << 1, 0.02, 0.8, -0.5).finished()},
                                    {101, 0.003, (VectorXd(4) << 0.02, 1, -0.5, -0.8).finished()}};
  FrfSet set = synthetic(modes, FrfQuantity::accelerance, 80, 120, 1601, 2);
  add_noise(set, 0.002, 5);
  const Identification found = identify(set, {});
  ASSERT_EQ(found.modes.size(), 2U);
  for (const IdentifiedMode& m : found.modes) EXPECT_LT(m.sigma_frequency, 0.02) << m.frequency;
}

// By hand: weights 1 and 4, deviations 3 and 0 with sigma 1 each: sqrt(1 (9 - 1) / 5).
TEST(Inputs, spread_follows_its_definition) {
  IdentifiedMode mode;
  mode.frequency = 100;
  mode.damping = 0.01;
  mode.sigma_frequency = 0.5;
  mode.shape = VectorXcd::Ones(3);
  const auto part = [](const std::string& name, double f, double size) {
    return PartialIdentification{.name = name,
                                 .modes = {{.frequency = f,
                                            .sigma_frequency = 1,
                                            .damping = 0.01,
                                            .sigma_damping = 1e-3,
                                            .shape = VectorXcd::Ones(3),
                                            .size = size}}};
  };
  std::vector<IdentifiedMode> modes{mode};
  std::vector<std::string> warnings;
  widen_by_parts({part("a", 103, 1), part("b", 100, 2)}, modes, warnings);
  EXPECT_NEAR(modes[0].sigma_frequency, std::hypot(0.5, std::sqrt(8. / 5)), 1e-12);
  modes = {mode};
  widen_by_parts({part("a", 100.9, 1), part("b", 99.5, 2)}, modes, warnings);
  EXPECT_NEAR(modes[0].sigma_frequency, 0.5, 1e-12); // they know it no better than that
}

// A band whose first mode is a thousandth of the last in height: where a fit leaves it out, the
// peak is named; where it has it, nothing is said.
TEST(MissedPeaks, are_named) {
  FrfSet set = synthetic(three_modes(), FrfQuantity::accelerance, 20, 180, 1601, 1);
  add_noise(set, 1e-4, 1);
  Identification found = identify(set, {});
  ASSERT_EQ(found.modes.size(), 3U);
  EXPECT_TRUE(missed_peaks(set, found.modes).empty());
  EXPECT_FALSE(warns_of(found, "no mode was found at the peaks"));
  found.modes.erase(found.modes.begin());
  const std::vector<double> missed = missed_peaks(set, found.modes);
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_NEAR(missed[0], 60, 0.5);
}

// Two poles at most for three peaks: the fit says what it left out.
TEST(MissedPeaks, of_a_fit_of_too_low_order_are_a_warning) {
  FrfSet set = synthetic(three_modes(), FrfQuantity::accelerance, 20, 180, 1601, 1);
  add_noise(set, 1e-4, 1);
  const Identification found = identify(set, {.highest_order = 4});
  ASSERT_LT(found.modes.size(), 3U);
  EXPECT_TRUE(warns_of(found, "no mode was found at the peaks of"));
}

TEST(MissedPeaks, are_none_in_noise) {
  FrfSet noise = synthetic(three_modes(), FrfQuantity::accelerance, 20, 180, 1601, 2);
  for (Eigen::MatrixXcd& H : noise.H) H.setConstant(1e-3);
  add_noise(noise, 1, 7);
  EXPECT_TRUE(missed_peaks(noise, {}).empty());
}

TEST(IdentifiedMeasured, knows_kinds_by_the_axes_of_the_part) {
  MeasuredSensor turned{.name = "a", .axes = {2, 1, 3}}; // its own x along the pipe
  const std::vector<std::string> channels{"a.x", "a.y", "b.y"};
  VectorXcd along(3), across(3), both(3);
  along << 1, 0.1, 0.9;
  across << 0.1, 1, 0.1;
  both << 1, 1, 0;
  EXPECT_EQ(kind_of(along, channels, {turned}).shape, MeasuredShape::axial);
  EXPECT_EQ(kind_of(across, channels, {turned}).shape, MeasuredShape::transverse);
  EXPECT_EQ(kind_of(across, channels, {turned}).direction, Axis::x);
  EXPECT_EQ(kind_of(both, channels, {turned}).shape, MeasuredShape::other);
}

TEST(IdentifiedMeasured, replaces_responses_and_keeps_the_rest) {
  Measured test;
  test.specimen = "pipe";
  test.sensors = {{.name = "p1"}, {.name = "p2"}, {.name = "p3"}, {.name = "p4"}};
  test.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
                 {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  test.weighings = {{.value = 1.7, .sigma = 0.1, .repeats = {}, .state = "before"},
                    {.value = 1.8, .sigma = 0.1, .repeats = {}, .state = "after"}};
  test.modes.resize(2);
  test.modes[0].state = "before";
  test.modes[1].state = "after";
  test.frf.resize(1);
  test.peaks.resize(1);
  test.stiffness.resize(1);
  test.hold_out = {"modes[0]",     "modes[1]", "frf[0]", "peaks[0].frequency[1]",
                   "stiffness[0]", "mass[1]"};
  FrfSet set = synthetic(three_modes(), FrfQuantity::accelerance, 40, 180, 1401, 1);
  set.level = 5;
  const Measured m =
      identified_measured(test, {{.title = "a hit", .found = identify(set, {}), .state = "after"}});
  EXPECT_TRUE(m.frf.empty());
  ASSERT_EQ(m.modes.size(), 4U);
  EXPECT_EQ(m.modes[0].state, "before");
  for (int j = 1; j < 4; ++j) {
    const MeasuredMode& mode = m.modes[std::size_t(j)];
    EXPECT_EQ(mode.state, "after");
    EXPECT_EQ(mode.order, j);
    EXPECT_EQ(mode.shape, MeasuredShape::transverse);
    EXPECT_EQ(mode.drive, "p1.x");
    EXPECT_EQ(mode.force, 5);
    ASSERT_TRUE(mode.vector);
    EXPECT_EQ(mode.vector->channels, set.responses);
    EXPECT_TRUE(mode.sigma && mode.sigma_damping);
  }
  EXPECT_EQ(m.hold_out, (std::vector<std::string>{"modes[0]", "peaks[0].frequency[1]",
                                                  "stiffness[0]", "mass[1]"}));
  EXPECT_EQ(m.weighings.size(), 2U);
  EXPECT_EQ(m.states.size(), 2U);
  EXPECT_EQ(m.caveats.size(), 1U);
}

} // namespace
} // namespace plica::test
