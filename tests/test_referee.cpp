// The response held against a direct solution of the whole mesh: every damping, every route; and
// that it speaks up.
#include "tests/tube_case.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

double worst(const Results& results) {
  double largest = 0;
  for (const ResponseResult& r : results.responses) {
    EXPECT_FALSE(r.direct.empty()) << r.excitation;
    for (const DirectCheck& check : r.direct) largest = std::max(largest, check.difference);
  }
  return largest;
}

Case line() {
  Case data = mass_between(4e4, 1e4, 2, 0.01);
  data.analyses.modes = Modes{.count = 12};
  Response r{.bases = {1, 2, 3}, .band = {2, 120}, .points = 60};
  Motion ahead = motion_of("right", 2, 0.5, 1.2);
  ahead.name = "both";
  ahead.with = {end_of(motion_of("left", 2))};
  r.motions = {motion_of("left", 1), ahead};
  r.forces = {{.name = "tap", .at = "tube.point[2]", .direction = 2, .amplitude = 7, .random = {}}};
  r.together = {{.name = "sum",
                 .inputs = {{"y", 1, 0}, {"tap", 0.5, 1.2}},
                 .correlation = InputCorrelation::none,
                 .coherence = {},
                 .spectra = {}}};
  r.referee = 8;
  data.analyses.response = r;
  return data;
}

TEST(Referee, agrees_on_modal_damping) {
  Case data = line();
  data.analyses.damping.loss_factors = {{"tube", 0.02}, {"mount.left", 0.1}};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 7u);
  EXPECT_EQ(results.responses[0].direct.size(), 8u);
  EXPECT_LT(worst(results), 2e-3);
}

TEST(Referee, agrees_on_dashpots_laws_over_frequency_and_coupled_loss_factors) {
  Case data = line();
  data.analyses.damping.modal = 0.002;
  data.analyses.damping.loss_factors = {{"tube", 0.1}, {"mount.right", 0.3}};
  data.analyses.damping.coupled = true;
  data.mount[0].damping.emplace();
  data.mount[0].damping->dashpot = {20, 120, 30, 0, 1, 0};
  data.mount[0].damping->maxwell = {{0.8, 0.01}};
  data.mount[1].damping.emplace();
  data.mount[1].damping->springpot = Springpot{1e-3, 0.4};
  EXPECT_LT(worst(run_silently(data)), 2e-3);
}

// By rotational symmetry and with superelements; the direct solution is that of the whole mesh.
TEST(Referee, agrees_on_every_route) {
  Case data = verification_case("bellows_a", {.around = 16, .arc = 1, .wall = 1});
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.sensors = {{.name = "mid", .at = {0.035, 0.03, 0}, .reach = 0.1}};
  data.analyses.modes = Modes{.count = 12};
  data.analyses.damping.modal = 0.02;
  data.analyses.response =
      Response{.bases = {0}, .motions = {motion_of("right", 0)}, .band = {10, 400}, .points = 40};
  data.analyses.response->referee = 2;
  data.analyses.symmetry = Symmetry::required;
  EXPECT_LT(worst(run_silently(data)), 1e-2);
  data.analyses.symmetry = Symmetry::off;
  EXPECT_LT(worst(run_silently(data)), 1e-2);
}

// With three modes for a band that holds more, the static part stands for the others: it is seen.
TEST(Referee, says_where_modes_are_missing) {
  Case data = tube(3);
  data.sensors = {{.name = "mid", .at = {0, L / 4, 0}}};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  data.analyses.damping.modal = 0.01;
  data.analyses.modes = Modes{.count = 2};
  data.analyses.response = Response{.bases = {2}, .band = {10, 600}, .points = 60};
  data.analyses.response->referee = 6;
  const Results few = run_silently(data);
  EXPECT_GT(worst(few), 0.05);
  const auto said = [](const std::string& w) { return w.find("direct solution") < w.size(); };
  EXPECT_TRUE(std::any_of(few.warnings.begin(), few.warnings.end(), said));
  data.analyses.modes = Modes{.count = 16};
  const Results many = run_silently(data);
  EXPECT_LT(worst(many), 1e-2);
  EXPECT_FALSE(std::any_of(many.warnings.begin(), many.warnings.end(), said));
}

} // namespace
} // namespace plica::test
