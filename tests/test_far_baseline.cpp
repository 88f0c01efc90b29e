// A case whose root is drawn far too stiff, beside a baseline and not fitted to it: what an effect
// changes is then known no better than the model is. Measured is closed form (beam_roots.hpp).
#include "tests/beam_roots.hpp"
#include "tests/changed_beam.hpp"

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
  constexpr std::array anew{0.001, -0.0015, 0.0005, 0.0015, -0.001, 0.0007, -0.0006};
  Measured m;
  m.specimen = "beam";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  const double weight = 7850 * length * width * depth;
  for (const auto& [state, all] : {std::pair{"before", weight}, {"after", weight + mass}}) {
    m.weighings.emplace_back().value = all;
    m.weighings.back().state = state;
  }
  std::size_t k = 0;
  for (Axis axis : {Axis::z, Axis::x}) {
    const std::vector<double> first = frequencies(axis, 0, at),
                              second = frequencies(axis, mass, at);
    for (std::size_t i = 0; i < first.size(); ++i, ++k) {
      m.modes.push_back(bending(axis, int(i) + 1, "before", first[i]));
      m.modes.push_back(bending(axis, int(i) + 1, "after", second[i] * (1 + anew[k])));
    }
  }
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
