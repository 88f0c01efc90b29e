// The case files of `plica init` are read without a complaint and give what their numbers must.
#include "io/files/files.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/input/starter_case.hpp"
#include "run/analyses/run.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace plica {
namespace {

// As read from the files that `plica init` writes, with a coarse wall.
Case started(Starter kind) {
  const test::TemporaryFolder folder("starter");
  const std::vector<StarterFile> files = starter_files(kind, "my_pipe");
  for (const StarterFile& f : files) write_whole(folder.path / f.name, f.text);
  Case data = read_case((folder.path / files[0].name).string(), "").data;
  data.analyses.error_bars = false;
  for (Part& part : data.parts)
    if (auto* wall = std::get_if<Bellows>(&part.body))
      wall->mesh = {.around = 32, .arc = 2, .wall = 2};
  if (files.size() > 1) read_measured(folder.path / files[1].name);
  return data;
}

TEST(StarterCase, a_bellows_runs) {
  Case data = started(Starter::bellows);
  EXPECT_EQ(data.name, "my_pipe");
  data.analyses.response.reset();
  const Results results = run(data, [](const std::string&) {});
  ASSERT_TRUE(results.statics.has_value());
  // Both ends held, moved across: at most 12 EI / L^3 of a beam with EI = k_a L R^2 / 2, L the
  // length that is convoluted and R its mean radius; shear takes some of it.
  const double most = 6 * results.statics->k_axial * std::pow(0.043 / 0.072, 2);
  EXPECT_LT(results.statics->k_transverse_x, most);
  EXPECT_GT(results.statics->k_transverse_x, most / 2);
  ASSERT_FALSE(results.modes.empty());
  EXPECT_EQ(results.modes.front().shape, "axial");
}

TEST(StarterCase, a_decoupler_between_pipes_follows_its_flange) {
  const Results results = run(started(Starter::decoupler), [](const std::string&) {});
  ASSERT_TRUE(results.reduced);
  ASSERT_EQ(results.responses.size(), 2u);
  EXPECT_EQ(results.responses[0].source, Source::ends);
  EXPECT_NEAR(std::abs(results.responses[0].acceleration(0, 1)), 1, 0.1) << "slowly, along";
  EXPECT_TRUE(results.complex_modes.complete) << results.complex_modes.reason;
}

TEST(StarterCase, a_line_answers_the_orders_of_its_engine) {
  const Results results = run(started(Starter::line), [](const std::string&) {});
  ASSERT_EQ(results.run_ups.size(), 1u);
  EXPECT_GE(results.run_ups[0].crossings.size(), 3u);
  ASSERT_EQ(results.transients.size(), 1u);
  EXPECT_GT(std::abs(results.transients[0].extremes[1].value), 0);
  EXPECT_TRUE(results.verification.passed) << results.verification.reason;
}

// Rayleigh: a cantilever of the mass m_b with a weight m at half its length, f = sqrt(k / m_eff) /
// 2 pi with k = 3 EI / l^3 and m_eff = 0.2427 m_b + (5/16)^2 m.
TEST(StarterCase, a_beam_has_the_frequency_of_the_closed_form) {
  for (const Starter kind : {Starter::beam, Starter::measured}) {
    const Results results = run(started(kind), [](const std::string&) {});
    const double I = 0.025 * std::pow(0.015, 3) / 12, k = 3 * 205e9 * I / std::pow(0.6, 3);
    const double mass = 0.2427 * 7850 * 0.025 * 0.015 * 0.6 + std::pow(5. / 16, 2) * 0.15;
    const double f = std::sqrt(k / mass) / (2 * std::numbers::pi);
    EXPECT_NEAR(results.modes.front().frequency, f, 0.01 * f);
  }
}

} // namespace
} // namespace plica
