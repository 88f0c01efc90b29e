// A case whose root is drawn far too stiff, beside a baseline and not fitted to it: what an effect
// changes is then known no better than the model is. Measured is closed form (beam_roots.hpp).
#include "tests/beam_roots.hpp"
#include "tests/before_and_after.hpp"

#include <gtest/gtest.h>

namespace plica::far_baseline {
namespace {

using namespace changed_beam;

constexpr double length = 0.6, width = 0.03, depth = 0.012;

// On a root that turns in a spring of 4 kNm/rad, with a mass at a place.
std::vector<double> frequencies(Axis axis, double mass, double at) {
  const bool flat = axis == Axis::z;
  beam_roots::BentBeam beam;
  beam.stretches = {
      beam_roots::rectangle(length, flat ? width : depth, flat ? depth : width, 190e9)};
  beam.attached = {{0, 1e9, 0, 4e3}, {at, 0, mass, 0}};
  return beam_roots::frequencies(beam, 5, flat ? 4 : 3);
}

Measured with_a_mass(double mass, double at) {
  Measured m = before_and_after([&](Axis axis) { return frequencies(axis, 0, at); },
                                [&](Axis axis) { return frequencies(axis, mass, at); }, {});
  const double weight = 7850 * length * width * depth;
  weigh(m, weight, weight + mass);
  return m;
}

// Its root at 100 kNm/rad.
Case drawn() {
  Case c = beam_of(4, length, width, depth, true);
  c.mount[0].kind = MountKind::springs;
  c.mount[0].stiffness = {1e9, 1e9, 1e9, 1e5, 1e5, 1e5};
  return c;
}

class FarBaseline : public testing::TestWithParam<double> {};

TEST_P(FarBaseline, makes_nothing_sure_of_a_place_that_the_model_cannot_know) {
  const double at = GetParam();
  const Diagnosis d = diagnosis_of(drawn(), with_a_mass(0.2, at));
  EXPECT_TRUE(std::any_of(d.warnings.begin(), d.warnings.end(), [](const std::string& w) {
    return w.find("from those of the baseline") != std::string::npos;
  }));
  const auto mass = std::find_if(d.effects.begin(), d.effects.end(),
                                 [](const NamedEffect& e) { return e.name == "added_mass"; });
  ASSERT_NE(mass, d.effects.end()) << d.headline;
  if (d.verdict == Verdict::ambiguous) return;
  EXPECT_EQ(d.verdict, Verdict::identified) << d.headline;
  const EstimatedParameter& place = mass->parameters.back();
  ASSERT_EQ(place.name, "at");
  EXPECT_LE(place.interval[0], at) << d.headline;
  EXPECT_GE(place.interval[1], at) << d.headline;
}

INSTANTIATE_TEST_SUITE_P(FarBaseline, FarBaseline, testing::Values(0.237, 0.337, 0.47));

} // namespace
} // namespace plica::far_baseline
