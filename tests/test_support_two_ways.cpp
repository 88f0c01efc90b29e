// Something that touches a clamped beam in two directions at once, between nodes of the case:
// against closed form (beam_roots.hpp).
#include "tests/beam_roots.hpp"
#include "tests/before_and_after.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

using namespace changed_beam;

constexpr double touched_length = 0.6, touched_at = 0.237; // nodes every 25 mm

// Frequencies of the beam with a spring of k where it is touched, in the plane of one axis.
std::vector<double> touched_frequencies(Axis axis, double k) {
  constexpr double E = 198e9, width = 0.03, depth = 0.012;
  const bool flat = axis == Axis::z;
  beam_roots::BentBeam beam;
  beam.clamped = true;
  beam.stretches = {
      beam_roots::rectangle(touched_length, flat ? width : depth, flat ? depth : width, E)};
  beam.attached = {{touched_at, k, 0, 0}};
  return beam_roots::frequencies(beam, 5, flat ? 4 : 3);
}

// Before it was touched and after, by springs along z and x.
Measured touched(double along_z, double along_x) {
  return before_and_after(
      [](Axis axis) { return touched_frequencies(axis, 0); },
      [&](Axis axis) { return touched_frequencies(axis, axis == Axis::z ? along_z : along_x); },
      a_percent_off);
}

void expect_touch(const Diagnosis& d, const std::string& way, double k) {
  EXPECT_EQ(d.verdict, Verdict::identified) << d.headline;
  ASSERT_EQ(d.effects.size(), 1U) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "extra_support") << d.headline;
  EXPECT_EQ(e.place, "beam") << d.headline;
  EXPECT_EQ(e.way, way) << d.headline;
  const EstimatedParameter &stiffness = e.parameters.front(), &place = e.parameters.back();
  ASSERT_EQ(stiffness.name, "k");
  EXPECT_LE(stiffness.interval[0], k) << d.headline;
  EXPECT_GE(stiffness.interval[1], k) << d.headline;
  ASSERT_EQ(place.name, "at");
  EXPECT_NEAR(place.value, touched_at, 0.01) << d.headline;
  EXPECT_LE(place.interval[0], touched_at) << d.headline;
  EXPECT_GE(place.interval[1], touched_at) << d.headline;
}

// Some 1.5 and 1/4 of what the beam itself has there in z and in x.
TEST(SupportTwoWays, a_spring_across_a_beam_in_both_directions_is_named_with_them) {
  const Case nominal = beam_of(4, touched_length, 0.03, 0.012, true);
  expect_touch(diagnosis_of(nominal, touched(1e5, 1e5)), "all round", 1e5);
}

TEST(SupportTwoWays, nearly_a_pin_in_both_directions_is_named_with_them) {
  const Case nominal = beam_of(4, touched_length, 0.03, 0.012, true);
  expect_touch(diagnosis_of(nominal, touched(3e6, 3e6)), "all round", 3e6);
}

// The same modes, of which those in x stay where they were.
TEST(SupportTwoWays, one_in_one_direction_is_not_said_to_hold_the_other) {
  const Case nominal = beam_of(4, touched_length, 0.03, 0.012, true);
  expect_touch(diagnosis_of(nominal, touched(1e5, 0)), "z", 1e5);
}

// Four times as stiff along x as along z: neither one direction nor one stiffness says so.
TEST(SupportTwoWaysSlow, two_stiffnesses_at_one_place_are_named_as_two) {
  const Case nominal = beam_of(4, touched_length, 0.03, 0.012, true);
  const Diagnosis d = diagnosis_of(nominal, touched(1e5, 4e5));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "extra_support") << d.headline;
  EXPECT_EQ(e.way, "x and z") << d.headline;
  ASSERT_EQ(e.parameters.size(), 3U);
  for (const auto& [k, truth] : {std::pair{0, 4e5}, {1, touched_at}, {2, 0.25}}) {
    const EstimatedParameter& p = e.parameters[std::size_t(k)];
    EXPECT_LE(p.interval[0], truth) << p.name << ": " << d.headline;
    EXPECT_GE(p.interval[1], truth) << p.name << ": " << d.headline;
  }
}

} // namespace
} // namespace plica
