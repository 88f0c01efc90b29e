// Two of one effect on one beam, against closed form (beam_roots.hpp).
#include "diagnose/weigh/twins.hpp"
#include "tests/beam_roots.hpp"
#include "tests/before_and_after.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

using namespace changed_beam;

constexpr double twin_length = 0.6, twin_width = 0.03, twin_depth = 0.012, twin_E = 198e9;

// Frequencies in the plane of one axis with masses at these places, m and kg.
std::vector<double> loaded(Axis axis, const std::vector<std::pair<double, double>>& masses) {
  const bool flat = axis == Axis::z;
  beam_roots::BentBeam beam;
  beam.clamped = true;
  beam.stretches = {beam_roots::rectangle(twin_length, flat ? twin_width : twin_depth,
                                          flat ? twin_depth : twin_width, twin_E)};
  for (const auto& [at, mass] : masses) beam.attached.push_back({at, 0, mass, 0});
  return beam_roots::frequencies(beam, 6, 6);
}

// Of the beam of 1.7 kg, hit and weighed before it had these and with them.
Diagnosis diagnosis_with(const std::vector<std::pair<double, double>>& masses) {
  Measured m = before_and_after([](Axis axis) { return loaded(axis, {}); },
                                [&](Axis axis) { return loaded(axis, masses); }, a_percent_off);
  const double own = twin_length * twin_width * twin_depth * 7850;
  double with = own;
  for (const auto& [at, mass] : masses) with += mass;
  weigh(m, own, with);
  return diagnosis_of(beam_of(4, twin_length, twin_width, twin_depth, true), m);
}

// 300 g at 0.247 m and 150 g at 0.553 m. Four numbers ask for twelve readings.
TEST(TwinsSlow, two_masses_on_a_beam_are_named_where_they_are) {
  const std::vector<std::pair<double, double>> masses{{0.247, 0.3}, {0.553, 0.15}};
  const Diagnosis d = diagnosis_with(masses);
  EXPECT_EQ(d.verdict, Verdict::several) << d.headline;
  ASSERT_EQ(d.effects.size(), 2U) << d.headline;
  const bool in_order = d.effects[0].parameters[1].value < d.effects[1].parameters[1].value;
  for (std::size_t k = 0; k < 2; ++k) {
    const NamedEffect& e = d.effects[in_order ? k : 1 - k];
    EXPECT_EQ(e.name, "added_mass") << d.headline;
    EXPECT_EQ(e.place, "beam") << d.headline;
    const auto& [at, mass] = masses[k];
    EXPECT_LE(e.parameters[0].interval[0], mass) << d.headline;
    EXPECT_GE(e.parameters[0].interval[1], mass) << d.headline;
    EXPECT_LE(e.parameters[1].interval[0], at) << d.headline;
    EXPECT_GE(e.parameters[1].interval[1], at) << d.headline;
    EXPECT_NEAR(e.parameters[1].value, at, 0.02) << d.headline;
  }
  // What is said of the fit is of the same places.
  ASSERT_TRUE(d.best.has_value());
  const TriedHypothesis& best = d.tried[*d.best];
  ASSERT_EQ(best.effects.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(best.effects[k].parameters[1].value, d.effects[k].parameters[1].value, 0.01);
  EXPECT_NEAR(best.gap_after, d.gap.after, 1e-9);
  EXPECT_LT(d.gap.after, 0.03 * d.gap.before) << "of percents, a hundredth is left";
}

TEST(Twins, one_mass_on_a_beam_is_no_two) {
  const std::vector<std::pair<double, double>> masses{{0.437, 0.15}};
  const Diagnosis d = diagnosis_with(masses);
  EXPECT_EQ(d.verdict, Verdict::identified) << d.headline;
  ASSERT_EQ(d.effects.size(), 1U) << d.headline;
  EXPECT_EQ(d.effects[0].name, "added_mass") << d.headline;
}

TEST(Twins, keep_the_order_of_their_optimum) {
  Hypothesis mass{.effect = "added_mass", .place = "beam", .way = "", .parameters = {{}, {}}};
  mass.along = {1};
  const Hypothesis other{.effect = "damping", .place = "all", .way = "", .parameters = {{}}};
  HypothesisFit fit;
  fit.together = {&mass, &other, &mass};
  fit.z.resize(5);
  fit.z << 1, -0.5, 9, 2, 0.7;
  Eigen::VectorXd swapped(5);
  swapped << 2.1, 0.6, 9, 1.1, -0.4;
  EXPECT_EQ(in_order_of(fit, swapped), (Eigen::VectorXd(5) << 1.1, -0.4, 9, 2.1, 0.6).finished());
  EXPECT_EQ(in_order_of(fit, fit.z), fit.z);
  EXPECT_TRUE(ends_with_twin(fit.together));
  EXPECT_FALSE(ends_with_twin({&mass, &other}));
  EXPECT_FALSE(may_be_twin(mass, fit.together)) << "two are enough";
  EXPECT_TRUE(may_be_twin(mass, {&mass}));
  EXPECT_FALSE(may_be_twin(other, {&other})) << "nothing tells one from the other";
  EXPECT_EQ(without(fit.together, {&mass}), (Members{&other, &mass}));
}

} // namespace
} // namespace plica
