// Simulation and test side by side, and what levels, harmonics and reciprocity say of linearity.
#include "compare/correlate.hpp"
#include "lab/identification/linearity.hpp"
#include "tests/synthetic_frf.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

using Eigen::Index;

TestData side(const std::vector<double>& frequencies,
              const std::vector<std::vector<double>>& shapes,
              const std::vector<std::string>& channels) {
  TestData data;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    MeasuredMode& m = data.data.modes.emplace_back();
    m.frequency = frequencies[i];
    m.damping = 0.01;
    m.vector = MeasuredVector{.channels = channels, .real = shapes[i], .imaginary = {}};
  }
  return data;
}

const std::vector<std::string> three{"a.x", "b.x", "c.x"};
const std::vector<std::vector<double>> orthogonal{{1, 1, 0}, {1, -1, 0}, {0, 0, 1}};

// Shapes pair the modes though two have changed places in frequency.
TEST(Correlate, pairs_by_shape_across_a_swap) {
  TestData a = side({100, 110, 300}, orthogonal, three);
  TestData b = side({112, 101, 290}, orthogonal, three);
  b.data.modes[0].sigma = 2;
  const Correlation c = correlate(a, b);
  ASSERT_EQ(c.pairs.size(), 3U);
  for (const PairedMode& p : c.pairs) {
    EXPECT_EQ(p.simulated, p.measured);
    EXPECT_EQ(p.by, "shape");
    EXPECT_NEAR(*p.mac, 1, 1e-14);
  }
  EXPECT_NEAR(c.pairs[0].frequency_error, 100. / 112 - 1, 1e-14);
  EXPECT_NEAR(*c.pairs[0].frequency_sigmas, -6, 1e-12);
  EXPECT_FALSE(c.pairs[1].frequency_sigmas);
  EXPECT_NEAR(c.comac.minCoeff(), 1, 1e-14);
}

// A model that is 40 % too stiff has the right modes all the same.
TEST(Correlate, pairs_by_shape_though_all_frequencies_are_far_off) {
  const std::vector<double> measured{100, 150, 225};
  std::vector<double> computed;
  for (double f : measured) computed.push_back(1.4 * f);
  const Correlation c =
      correlate(side(computed, orthogonal, three), side(measured, orthogonal, three));
  ASSERT_EQ(c.pairs.size(), 3U);
  for (const PairedMode& p : c.pairs) EXPECT_EQ(p.simulated, p.measured);
}

TEST(Correlate, leaves_over_what_has_no_partner) {
  const TestData a = side({100, 110}, {{1, 1, 0}, {1, -1, 0}}, three);
  const TestData b = side({101, 290}, {{1, 1, 0}, {0, 0, 1}}, three);
  const Correlation c = correlate(a, b);
  EXPECT_EQ(c.pairs.size(), 1U);
  EXPECT_EQ(c.unpaired_measured, std::vector<int>{1});
  EXPECT_EQ(c.unpaired_simulated, std::vector<int>{1});
}

TEST(Correlate, pairs_by_name_without_shapes_and_says_so) {
  TestData a, b;
  for (TestData* s : {&a, &b}) {
    s->data.modes.resize(2);
    s->data.modes[0].shape = MeasuredShape::axial;
    s->data.modes[1].shape = MeasuredShape::transverse;
    s->data.modes[1].direction = Axis::x;
    s->data.modes[0].frequency = s == &a ? 112 : 116;
    s->data.modes[1].frequency = s == &a ? 160 : 178;
  }
  b.data.modes[1].direction.reset(); // not known from the test
  const Correlation c = correlate(a, b);
  ASSERT_EQ(c.pairs.size(), 2U);
  EXPECT_EQ(c.pairs[1].by, "name");
  ASSERT_FALSE(c.limits.empty());
  EXPECT_NE(c.limits[0].find("by their names alone"), std::string::npos);
}

// A mode seen by other sensors does not spoil the shapes of the rest.
TEST(Correlate, takes_the_channels_of_each_pair) {
  const TestData a = side({100, 110, 300}, orthogonal, three);
  TestData b = side({101, 112, 290}, orthogonal, three);
  b.data.modes[2].vector =
      MeasuredVector{.channels = {"q.x", "q.z"}, .real = {1, 2}, .imaginary = {}};
  const Correlation c = correlate(a, b);
  ASSERT_EQ(c.pairs.size(), 2U);
  EXPECT_NEAR(*c.pairs[0].mac, 1, 1e-14);
  EXPECT_EQ(correlate(b, b).pairs.size(), 3U);
}

// One accelerometer with three axes: the data say what they cannot tell.
TEST(Correlate, knows_the_limits_of_a_single_sensor) {
  const std::vector<std::string> one{"mid.x", "mid.y", "mid.z"};
  const TestData a = side({100, 200}, {{0, 1, 0}, {0, 1, 0}}, one), b = a;
  const Correlation c = correlate(a, b);
  std::string all;
  for (const std::string& l : c.limits) all += l + "\n";
  EXPECT_NE(all.find("one sensor (mid)"), std::string::npos) << all;
  EXPECT_NE(all.find("100 and 200 Hz"), std::string::npos) << all;
  // Frequencies decide where shapes cannot.
  for (const PairedMode& p : c.pairs) EXPECT_EQ(p.simulated, p.measured);
}

// A simulation 4 % low in all frequencies: FRAC is low, and the stretch that mends it is 4 %.
TEST(Correlate, finds_the_stretch_of_the_frequencies) {
  std::vector<TrueMode> modes = four_dof();
  TestData b;
  b.responses = {{synthetic(modes, FrfQuantity::accelerance, 5, 70, 1301, 1)}};
  for (TrueMode& m : modes) m.frequency /= 1.04;
  TestData a;
  a.responses = {{synthetic(modes, FrfQuantity::accelerance, 4, 75, 1501, 1)}};
  const Correlation c = correlate(a, b);
  ASSERT_EQ(c.responses.size(), 4U);
  for (const ComparedResponse& r : c.responses) {
    EXPECT_LT(r.frac, 0.5);
    EXPECT_GT(r.best_frac, 0.95);
    EXPECT_NEAR(r.stretch, 0.04, 0.003);
  }
  ASSERT_EQ(c.lines.size(), 1U);
  EXPECT_LT(c.lines[0].csf.mean(), c.lines[0].csac.mean() + 1e-12);
}

TEST(Correlate, compares_mass_and_stiffness) {
  TestData a, b;
  a.data.weighings.emplace_back().value = 1.712;
  b.data.weighings.emplace_back().value = 1.7096;
  b.data.weighings[0].sigma = 0.0005;
  a.data.statics.resize(1);
  a.data.statics[0].value = 65540;
  b.data.statics.resize(2);
  b.data.statics[0].direction = StaticDirection::torsion;
  b.data.statics[0].value = 1;
  b.data.statics[1].value = 54365;
  b.data.statics[1].sigma = 900;
  const Correlation c = correlate(a, b);
  ASSERT_EQ(c.numbers.size(), 2U);
  EXPECT_EQ(c.numbers[1].quantity, "axial stiffness");
  EXPECT_EQ(*c.numbers[1].sigma, 900);
}

// A run names no state: it stands beside each weighing; another test where it weighed the same.
TEST(Correlate, compares_weighings_by_their_state) {
  TestData a, b;
  const auto weighing = [](double value, const char* state) {
    return MeasuredMass{.value = value, .sigma = {}, .repeats = {}, .state = state};
  };
  a.data.weighings = {weighing(1.2, "")};
  b.data.weighings = {weighing(1.21, "delivered"), weighing(1.22, "mounted")};
  const Correlation of_run = correlate(a, b);
  ASSERT_EQ(of_run.numbers.size(), 2U);
  EXPECT_EQ(of_run.numbers[1].quantity, "mass, mounted");
  EXPECT_EQ(of_run.numbers[1].simulated, 1.2);
  EXPECT_EQ(of_run.numbers[1].measured, 1.22);
  const Correlation of_itself = correlate(b, b);
  for (const ComparedNumber& n : of_itself.numbers) EXPECT_EQ(n.simulated, n.measured);
}

// Table 6.5 of the thesis: hose B softens.
TEST(Linearity, hose_b_is_amplitude_dependent) {
  const std::vector<double> level{5, 10, 15, 20, 25, 30, 35, 40, 45, 50};
  const LevelVerdict v =
      level_verdict("y", level, {198, 185, 159, 147, 136, 130, 97, 87, 87, 78}, 4);
  EXPECT_FALSE(v.linear);
  EXPECT_NEAR(v.frequency_slope.change, 78. / 198 - 1, 1e-12);
  EXPECT_NE(v.verdict.find("the frequency falls by 61 % from 5 to 50"), std::string::npos)
      << v.verdict;
  EXPECT_NE(v.verdict.find("softening"), std::string::npos);
}

TEST(Linearity, scatter_is_no_dependence) {
  const LevelVerdict v =
      level_verdict("y", {5, 10, 20, 40}, {100.2, 99.9, 100.1, 99.8}, 0, {30, 31, 29.5, 30.2});
  EXPECT_TRUE(v.linear);
  EXPECT_NE(v.verdict.find("linear within 0.4 %"), std::string::npos) << v.verdict;
}

// A power law is found with its exponent, and a stated sigma decides whether it matters.
TEST(Linearity, finds_the_exponent) {
  std::vector<double> level{1, 2, 4, 8}, frequency;
  for (double l : level) frequency.push_back(100 * std::pow(l, -0.1));
  EXPECT_NEAR(level_verdict("y", level, frequency, 0.5).frequency_slope.slope, -0.1, 1e-12);
  EXPECT_FALSE(level_verdict("y", level, frequency, 0.5).linear);
  EXPECT_TRUE(level_verdict("y", level, frequency, 60).linear);
}

TEST(Linearity, reciprocity_of_a_linear_structure_is_one) {
  FrfSet set = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 500, 3);
  auto pairs = reciprocity(set);
  ASSERT_EQ(pairs.size(), 3U);
  for (const Reciprocity& r : pairs) {
    EXPECT_NEAR(r.frac, 1, 1e-12);
    EXPECT_LT(r.difference, 1e-12);
  }
  set.H[1].col(0) *= 1.2; // a gain
  pairs = reciprocity(set);
  EXPECT_NEAR(pairs[0].difference, 0.2 / std::sqrt((1 + 1.44) / 2), 1e-9);
}

TEST(Linearity, homogeneity_sees_a_change_with_level) {
  FrfSet low = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 500, 1), high = low;
  low.level = 5;
  high.level = 20;
  EXPECT_NEAR(homogeneity({low, high})[0].frac, 1, 1e-12);
  std::vector<TrueMode> soft = four_dof();
  for (TrueMode& m : soft) m.frequency *= 0.95;
  high.H = synthetic(soft, FrfQuantity::accelerance, 5, 70, 500, 1).H;
  EXPECT_LT(homogeneity({low, high})[0].frac, 0.5);
  const auto verdicts = level_verdicts({}, {low, high});
  ASSERT_EQ(verdicts.size(), 4U);
}

TEST(Linearity, coherence_is_watched_at_peaks_alone) {
  const FrfSet set = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 1301, 1);
  Eigen::MatrixXd coherence = Eigen::MatrixXd::Ones(1301, 4);
  coherence.topRows(40).setConstant(0.1); // 5 to 7 Hz: no peak there
  EXPECT_TRUE(coherence_drops(set, coherence).empty());
  coherence.middleRows(130, 20).setConstant(0.7); // 11.5 to 12.5 Hz
  const auto drops = coherence_drops(set, coherence);
  ASSERT_FALSE(drops.empty());
  EXPECT_NEAR(drops[0].frequency, 12, 0.1);
}

} // namespace
} // namespace plica::test
