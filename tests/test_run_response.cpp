// Response, damping and stress of a whole run, against closed forms.
#include "tests/tube_case.hpp"

#include "words/input_error.hpp"

#include <numbers>

namespace plica::test {
namespace {

using std::numbers::pi;

TEST(BaseResponse, of_a_tube_on_springs_is_that_of_one_dof) {
  constexpr double zeta = 0.02;
  Case data = sprung_tube(4e4);
  data.analyses.response = Response{.bases = {1}, .band = {1, 60}, .points = 100};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 1u);
  const ResponseResult& r = results.responses[0];
  ASSERT_EQ(r.channels.size(), 3u);
  const double f = std::sqrt(4e4 / 2) / (2 * pi);
  for (Eigen::Index i = 0; i < r.hertz.size(); ++i) {
    const double x = r.hertz[i] / f;
    const std::complex<double> wanted =
        1. + x * x / std::complex<double>(1 - x * x, 2 * zeta * x); // relative motion on the base
    EXPECT_LT(std::abs(r.acceleration(i, 1) - wanted), 1e-3 * std::abs(wanted) + 1e-6);
    EXPECT_LT(std::abs(r.acceleration(i, 0)), 1e-6) << "no motion across";
  }
  ASSERT_FALSE(r.peaks.empty());
  EXPECT_NEAR(r.peaks[0].frequency / f, 1, 2e-3);
  EXPECT_NEAR(r.peaks[0].damping / zeta, 1, 0.02);
}

// With a single mode the static rest has a maximum of its own near the next one: no resonance.
TEST(BaseResponse, lists_no_peak_above_the_last_mode) {
  Case data = tube(2);
  data.analyses.damping.modal = 0.01;
  data.sensors = {{.name = "mid", .at = {0, L / 2, 0}}};
  data.analyses.response = Response{.bases = {2}, .band = {5, 3000}};
  data.analyses.modes = Modes{.count = 2};
  const Results few = run_silently(data);
  ASSERT_FALSE(few.responses[0].peaks.empty());
  for (const ResponsePeak& p : few.responses[0].peaks)
    EXPECT_LT(p.frequency, 1.02 * few.modes.back().frequency);
  ASSERT_EQ(few.warnings.size(), 1U);
  EXPECT_NE(few.warnings[0].find("no peak is listed"), std::string::npos);
}

TEST(ForceResponse, tends_to_the_static_displacement_and_reads_sensor_axes) {
  constexpr double k = 4e4;
  Case data = sprung_tube(k);
  data.sensors[0].axes = {2, -1, 3};
  data.analyses.response = Response{.bases = {}, .band = {0.01, 60}, .points = 50};
  Force push;
  push.name = "push";
  push.at = "tube.end";
  data.analyses.response->forces = {push}; // along y
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 1u);
  const ResponseResult& r = results.responses[0];
  EXPECT_EQ(r.source, Source::force);
  const double omega = 2 * pi * r.hertz[0];
  // Both springs carry the force, the one at the end a little more: the tube is a spring between.
  const double tube_stiffness = EA / L;
  const double exact = (k + tube_stiffness) / (k * (k + 2 * tube_stiffness));
  EXPECT_NEAR(std::real(r.acceleration(0, 0)) / (-omega * omega * exact), 1, 1e-4);
  EXPECT_EQ(r.shown, std::vector<int>{0}) << "sensor axis x lies along the pipe";
  EXPECT_NEAR(vector_sum(r)(0, 0), std::abs(r.acceleration(0, 0)), 1e-12);
}

TEST(RandomResponse, of_a_case_is_that_of_miles) {
  constexpr double k = 4e4, S = 0.01, zeta = 0.02;
  Case data = sprung_tube(k);
  data.analyses.response = Response{.bases = {1}, .band = {0.1, 2000}, .points = 400};
  data.analyses.response->random.emplace().level = S;
  data.analyses.response->rms_bands = {{0.1, 22.5}, {22.5, 2000}};
  data.analyses.response->cross = {{"end.y", "end.y"}, {"end.y", "end.x"}};
  const Results results = run_silently(data);
  const RandomResult& random = *results.responses.at(0).random;
  const double f = std::sqrt(k / 2) / (2 * pi);
  const double miles = std::sqrt(pi / 2 * f / (2 * zeta) * S * (1 + 4 * zeta * zeta));
  EXPECT_NEAR(random.bands[0].rms[1] / miles, 1, 3e-3);
  EXPECT_NEAR(random.bands[0].input, std::sqrt(S * 1999.9), 1e-6);
  EXPECT_NEAR(std::hypot(random.bands[1].rms[1], random.bands[2].rms[1]), random.bands[0].rms[1],
              1e-9);
  EXPECT_LT((random.cross[0].density.real() - random.density.col(1)).norm(), 1e-12);
}

TEST(RandomResponse, holds_the_corners_of_its_table) {
  Case data = sprung_tube(4e4);
  data.analyses.response = Response{.bases = {1}, .band = {1, 2000}, .points = 100};
  data.analyses.response->random.emplace().table = {{21, 1}, {23, 1}};
  const Results results = run_silently(data);
  EXPECT_NEAR(results.responses.at(0).random->bands[0].input, std::sqrt(2.), 1e-6);
}

TEST(Damping, of_a_mode_goes_before_its_range_and_that_before_all) {
  Case data = sprung_tube(4e4); // modes near 11.3 11.3 22.5 33.8 33.8 Hz
  Damping& d = data.analyses.damping;
  d.modal = 0.01;
  d.ranges = {{{20, 40}, 0.03}};
  d.modes = {{4, 0.05}};
  const Results results = run_silently(data);
  EXPECT_DOUBLE_EQ(results.modes[0].damping, 0.01);
  EXPECT_DOUBLE_EQ(results.modes[2].damping, 0.03);
  EXPECT_DOUBLE_EQ(results.modes[3].damping, 0.05);
  EXPECT_DOUBLE_EQ(results.modes[4].damping, 0.03);
}

TEST(Damping, of_components_is_weighted_by_their_strain_energy) {
  Case data = sprung_tube(100);
  data.analyses.damping = {.modal = 0.01,
                           .ranges = {},
                           .modes = {},
                           .loss_factors = {{"mount.left", 0.2}, {"mount.right", 0.1}}};
  const Results results = run_silently(data);
  const auto along = std::max_element(results.modes.begin(), results.modes.end(),
                                      [](const ModeResult& a, const ModeResult& b) {
                                        return a.effective_mass[1] < b.effective_mass[1];
                                      });
  EXPECT_NEAR(along->damping, 0.01 + 0.15 / 2, 1e-4);
}

TEST(Response, without_damping_of_a_mode_in_its_band_is_refused) {
  Case data = sprung_tube(4e4);
  data.analyses.damping = {
      .modal = 0, .ranges = {{{1, 12}, 0.02}}, .modes = {}, .loss_factors = {}};
  data.analyses.response = Response{.bases = {1}, .band = {1, 60}, .points = 100};
  try {
    run_silently(data);
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("has no damping"), std::string::npos) << e.what();
  }
}

TEST(StressAnalysis, of_static_modal_harmonic_and_random_load_are_one_linear_field) {
  Case data = verification_case("bellows_a", {24, 2, 3}, 4);
  data.sensors = {
      {.name = "root", .at = {build(data).meridian[3][1], build(data).meridian[3][0], 0}}};
  data.analyses.damping.modal = 0.02;
  const double f = run_silently(data).modes[0].frequency;
  data.analyses.response = Response{.bases = {1}, .level = 5, .band = {1, 2 * f}, .points = 200};
  data.analyses.response->random.emplace().table = {{0.9 * f, 1e-6}, {1.1 * f, 1e-6}};
  data.analyses.stress = Stress{.frequencies = {0.01, f}};
  const Results results = run_silently(data);
  std::map<StressKind, std::vector<StressResult>> by_kind;
  for (const StressResult& s : results.stresses) by_kind[s.kind].push_back(s);
  ASSERT_EQ(by_kind[StressKind::statics].size(), 3u);
  ASSERT_EQ(by_kind[StressKind::harmonic].size(), 2u);
  ASSERT_EQ(by_kind[StressKind::rms].size(), 1u);
  EXPECT_NEAR(by_kind[StressKind::statics][1].largest / by_kind[StressKind::statics][2].largest, 1,
              1e-6)
      << "x and z of a body of revolution";
  // At the resonance 25 times the quasi-static stress, less what the other modes give.
  const double ratio =
      by_kind[StressKind::harmonic][1].largest / by_kind[StressKind::harmonic][0].largest;
  EXPECT_GT(ratio, 15);
  EXPECT_LT(ratio, 30);
  EXPECT_GT(by_kind[StressKind::rms][0].largest, 0);
  for (const StressResult& s : results.stresses)
    EXPECT_EQ(std::max(s.below.maxCoeff(), s.above.maxCoeff()), s.largest) << s.name;
}

} // namespace
} // namespace plica::test
