// What a run makes besides the case itself, and in which order.
#include "compare/whole_run.hpp"
#include "run/study/refine.hpp"
#include "tests/bellows_case.hpp"
#include "words/input_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

struct RoundBar {
  double E = 200e9, rho = 7850, radius = 5e-3, length = 1;

  // First bending of it, clamped at one end, by Euler and Bernoulli, which shear does not reach
  // here; 7.06 Hz.
  double first_bending() const {
    constexpr double root = 1.875104;
    return root * root / (2 * std::numbers::pi * length * length) * std::sqrt(E / rho) * radius / 2;
  }
};
constexpr RoundBar round_bar;

// Along y, clamped at its start.
Case clamped_bar(double modulus = round_bar.E) {
  Case data;
  data.name = "bar";
  data.materials["steel"] = {modulus, 0.3, round_bar.rho};
  BeamPart bar;
  bar.points = {{0, 0, 0}, {0, round_bar.length, 0}};
  bar.elements = 20;
  bar.section.shape = BeamShape::solid;
  bar.section.material = "steel";
  bar.section.radius = round_bar.radius;
  data.parts.push_back({"bar", bar});
  data.supports.push_back({"bar.start", {0, 1, 2, 3, 4, 5}});
  data.analyses.modes = Modes{.count = 2};
  data.analyses.error_bars = false;
  return data;
}

// The bar with a variant of twice its modulus and one that is held where it has nothing.
WholeRunRequest bar_and_variants() {
  WholeRunRequest request{.data = clamped_bar()};
  request.data.variants = {{"stiffer", {{"materials.steel.E", "400 GPa"}}},
                           {"held nowhere", {{"supports[0].set", "bar.nowhere"}}}};
  request.variants = {clamped_bar(2 * round_bar.E), clamped_bar()};
  request.variants[1].supports[0].set = "bar.nowhere";
  return request;
}

// Wide and shallow: an accuracy this coarse gives a mesh too coarse around for the waves of its
// lowest modes.
Case wide_bellows() {
  Case data = test::verification_case("bellows_a", {}, 10);
  Bellows& bellows = test::bellows_of(data);
  MeridianSection convolutions;
  convolutions.count = 5;
  convolutions.height = 5e-3;
  convolutions.pitch = 15e-3;
  bellows.root_radius = 0.1;
  bellows.profile = {convolutions};
  bellows.wall.plies = {1e-3};
  bellows.mesh = {.accuracy = 0.2};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  return data;
}

bool has_warning(const Results& results, const std::string& words) {
  return std::any_of(results.warnings.begin(), results.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

TEST(WholeRun, gives_the_case_and_its_variants_and_leaves_out_with_a_warning_what_fails) {
  const WholeRun whole = whole_run(bar_and_variants());
  ASSERT_FALSE(whole.results.modes.empty());
  const double f = round_bar.first_bending();
  EXPECT_NEAR(whole.results.modes.front().frequency, f, 2e-3 * f);
  ASSERT_EQ(whole.results.variants.size(), 1U);
  const VariantResult& stiffer = whole.results.variants.front();
  EXPECT_EQ(stiffer.name, "stiffer");
  EXPECT_EQ(stiffer.set, (decltype(stiffer.set){{"materials.steel.E", "400 GPa"}}));
  EXPECT_NEAR(stiffer.headline.at("f_transverse"), std::sqrt(2.) * f, 2e-3 * f);
  EXPECT_TRUE(has_warning(whole.results, "variant 'held nowhere' left out: "));
  EXPECT_TRUE(whole.states_found);
  EXPECT_FALSE(whole.stopped);
}

TEST(WholeRun, says_an_error_in_the_words_of_who_asks) {
  WholeRunRequest request = bar_and_variants();
  request.words = [](const std::exception_ptr& error) -> std::string {
    try {
      std::rethrow_exception(error);
    } catch (const InputError& found) {
      return "bar.yaml: " + found.problems().front().key;
    }
  };
  EXPECT_TRUE(has_warning(whole_run(request).results,
                          "variant 'held nowhere' left out: bar.yaml: supports[0]"));
}

TEST(WholeRun, puts_the_state_aside_and_the_test_beside_every_run) {
  WholeRunRequest request{.data = clamped_bar(), .assumptions = {"modulus guessed"}};
  request.data.states = {{.name = "hanging", .gravity = {0, 9.81, 0}}};
  request.data.state.emplace();
  request.data.state->gravity = {0, -9.81, 0};
  TestData test;
  test.data.modes.emplace_back();
  test.data.modes[0].frequency = 7;
  test.data.modes[0].shape = MeasuredShape::transverse;
  test.data.caveats = {"one hit"};
  request.test = &test;
  const Results results = whole_run(request).results;
  EXPECT_EQ(results.assumptions,
            (std::vector<std::string>{"modulus guessed", "Measurement: one hit"}));
  ASSERT_EQ(results.comparison.size(), 1U);
  // Pressed by its weight it is softer, drawn by it stiffer than at rest.
  ASSERT_EQ(results.variants.size(), 2U);
  EXPECT_EQ(results.variants[0].name, variant_at_rest);
  EXPECT_FALSE(results.variants[0].state);
  EXPECT_EQ(results.variants[1].name, "hanging");
  ASSERT_TRUE(results.variants[1].state);
  const double pressed = results.comparison[0].computed;
  for (const VariantResult& v : results.variants) ASSERT_EQ(v.comparison.size(), 1U) << v.name;
  EXPECT_LT(pressed, results.variants[0].comparison[0].computed);
  EXPECT_LT(results.variants[0].comparison[0].computed, results.variants[1].comparison[0].computed);
}

TEST(WholeRun, tells_of_what_runs_with_shares_that_do_not_fall) {
  std::vector<std::string> of;
  double share = 0;
  const WholeRun whole = whole_run(bar_and_variants(), [&](const RunStep& step) {
    if (of.empty() || of.back() != step.of) of.push_back(step.of);
    EXPECT_GE(step.done, share) << std::string(step.stage);
    share = step.done;
  });
  EXPECT_EQ(of, (std::vector<std::string>{"bar", "bar, stiffer", "bar, held nowhere"}));
  EXPECT_LT(share, whole.done);
  EXPECT_LT(whole.done, 1);
}

// The case begins anew on a finer mesh, on which twice the modulus is the root of two of a
// frequency; on the one before the first axial frequency is 0.6 % higher.
TEST(WholeRun, refines_once_for_the_waves_of_its_modes_and_its_variants_with_it) {
  WholeRunRequest request{.data = wide_bellows(), .shapes = Shapes::left_out};
  request.data.variants = {{"stiffer", {{"materials.steel.E", "386 GPa"}}}};
  request.variants = {wide_bellows()};
  request.variants[0].materials["steel"].E *= 2;
  double share = 0;
  int meshes = 0;
  const WholeRun whole = whole_run(request, [&](const RunStep& step) {
    EXPECT_GE(step.done, share) << step.of << ": " << std::string(step.stage);
    share = step.done;
    if (step.of == request.data.name && step.stage.kind == stages::mesh) ++meshes;
  });
  EXPECT_EQ(meshes, 2);
  EXPECT_LT(share, whole.done);
  const Results& results = whole.results;
  EXPECT_TRUE(results.mesh_choice.starts_with("refined around for modes of "))
      << results.mesh_choice;
  EXPECT_GT(unresolved_waves(request.data, results), 1) << "on the mesh before";
  ASSERT_EQ(results.variants.size(), 1U);
  const double ratio = results.variants[0].headline.at("f_axial") / headline(results).at("f_axial");
  EXPECT_NEAR(ratio, std::sqrt(2.), 1e-6);
}

TEST(WholeRun, keeps_what_was_finished_where_it_is_stopped_behind_the_case_itself) {
  const auto stopped_in = [](const std::string& name) {
    return whole_run(bar_and_variants(), [&](const RunStep& step) {
      if (step.of == name) throw Interrupted{step.of};
    });
  };
  const WholeRun whole = stopped_in("bar, held nowhere");
  ASSERT_TRUE(whole.stopped);
  EXPECT_EQ(whole.stopped->stage, "bar, held nowhere");
  EXPECT_EQ(whole.results.variants.size(), 1U);
  EXPECT_THROW(stopped_in("bar"), Interrupted);
}

TEST(WholeRun, throws_what_is_wrong_with_the_case_itself) {
  WholeRunRequest request = bar_and_variants();
  request.data.supports[0].set = "bar.nowhere";
  EXPECT_THROW(whole_run(request), InputError);
  request = bar_and_variants();
  request.variants.pop_back();
  EXPECT_THROW(whole_run(request), std::invalid_argument);
  request.others = false;
  EXPECT_TRUE(whole_run(request).results.variants.empty()) << "they are not asked for";
}

} // namespace
} // namespace plica
