// Intervals of lives by tolerances, mesh errors by place, and the stress of ends that move at
// random, against closed forms.
#include "run/study/error_bars.hpp"
#include "run/study/life_intervals.hpp"
#include "run/study/refine.hpp"
#include "tests/life_case.hpp"

#include <cmath>
#include <numbers>

namespace plica::test::life_intervals { // names of its own in a file of many tests
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

using namespace life_case;

Case coarse_bellows(int modes = 0) {
  return life_case::coarse_bellows({.around = 24, .arc = 3, .wall = 3}, modes);
}

const double resonance_of_mass = std::sqrt(5.4e4 / 20) / (2 * pi);

// 18 to 22 kg on the right end, which is free; the left one is moved along through the resonance.
Case free_end_with_mass() {
  Case data = coarse_bellows(8);
  data.mount.pop_back();
  data.caps[1].mass = 20;
  data.caps[1].inertia = {0.02, 0.02, 0.02, 0, 0, 0};
  data.tolerances = {{.path = "caps.right.mass", .value = 20, .low = 18, .high = 22}};
  data.analyses.damping.modal = 0.02;
  data.analyses.error_bars = false;
  data.analyses.response = Response{
      .bases = {1}, .band = {resonance_of_mass / 10, 3 * resonance_of_mass}, .points = 400};
  return data;
}

LifeHistory trip() {
  LifeHistory history{.name = "trip", .signals = {{.of = "axial", .signal = {}}}, .repeats = 50};
  VectorXd motion(9);
  motion << 0, 2, -1, 3, 0, 1, -2, 2, 0; // mm
  history.signals[0].signal.samples = 1e-3 * motion;
  history.signals[0].signal.step = 1;
  return history;
}

Results with_error_bars(const Case& data) {
  Results r = run_silently(data);
  r.error_bars = error_bars(data, r, [](const std::string&) {});
  add_life_intervals(data, r);
  return r;
}

const ErrorBar& bar_of(const Results& results, const std::string& key) {
  for (const ErrorBar& b : results.error_bars.bars)
    if (b.key == key) return b;
  throw std::runtime_error("no error bar " + key);
}

// All ranges of a history of movement scale with those of a stroke: the damage of a power law with
// their fourth power. Of the sum of both likewise.
TEST(LifeIntervals, of_a_history_is_that_of_its_stress_to_the_power_of_the_slope) {
  Case data = coarse_bellows();
  data.tolerances = {
      {.path = "parts.bellows.profile[0].height", .value = 9e-3, .low = 8.5e-3, .high = 9.5e-3}};
  data.analyses.life->strokes = {{.name = "one", .shift = {.axial = 1e-3}, .count = 1000}};
  data.analyses.life->histories = {trip()};
  Results r = with_error_bars(data);
  const ErrorBar& range = bar_of(r, "life_one");
  ASSERT_TRUE(range.interval && duty(r, "trip").damage_between && r.life->damage_between);
  EXPECT_FALSE(duty(r, "trip").between) << "it has no one life";
  for (const std::size_t i : {0, 1}) {
    const double expected = std::pow((*range.interval)[i] / range.value, slope);
    const DutyResult& history = duty(r, "trip");
    EXPECT_NEAR((*history.damage_between)[i] / history.damage / expected, 1, 1e-3);
    EXPECT_NEAR((*r.life->damage_between)[i] / r.life->spots[0].damage / expected, 1, 1e-3);
    const DutyResult& stroke = duty(r, "one");
    EXPECT_NEAR((*stroke.damage_between)[i] * (*stroke.between)[1 - i].cycles / stroke.count, 1,
                1e-9);
  }
  EXPECT_TRUE(r.life->with_tolerances);
  const double up = std::log10((*duty(r, "trip").damage_between)[1] / duty(r, "trip").damage);
  data.analyses.life->deviation = 0.2;
  add_life_intervals(data, r);
  EXPECT_NEAR(std::log10((*duty(r, "trip").damage_between)[1] / duty(r, "trip").damage),
              std::hypot(up, 1.6448536 * 0.2), 1e-6);
}

// A mass m on the bellows under white acceleration W and under a sine that sweeps through its
// resonance: stretch by Miles goes with m^(3/4), that at resonance with m; the damage per swing
// with the fourth power of it, the swings a second with m^(-1/2). In a sweep the cycles near the
// resonance go with its width, m^(-1/2) too. m lies between 18 and 22 kg: 5 and 95 % at 18.2, 21.8.
TEST(LifeIntervals, of_random_motion_and_of_a_sweep_go_with_the_mass_by_hand) {
  Case data = free_end_with_mass();
  const double f = resonance_of_mass;
  data.analyses.response->random.emplace();
  data.analyses.response->random->level = 0.5;
  data.analyses.life->random = {{.name = "road", .of = "y", .duration = 3600}};
  data.analyses.life->sweeps = {{.name = "sweep",
                                 .of = "y",
                                 .acceleration = 3,
                                 .force = {},
                                 .band = {f / 2, 2 * f},
                                 .octaves_per_minute = 2}};
  const Results r = with_error_bars(data);
  const std::array mass{18.2 / 20, 21.8 / 20};
  for (const auto& [name, power] : {std::pair("road", 3 - 0.5), {"sweep", 4 - 0.5}}) {
    const DutyResult& d = duty(r, name);
    ASSERT_TRUE(d.damage_between) << name;
    for (const std::size_t i : {0, 1})
      EXPECT_NEAR((*d.damage_between)[i] / d.damage / std::pow(mass[i], power), 1, 0.01) << name;
  }
}

// A slider beside a mass on the bellows. One that never slips is a spring, and the sweep by
// harmonic balance has the interval of the linear one; one that slips has an interval too, by the
// joints solved anew, and so has the sum.
TEST(LifeIntervals, of_a_sweep_with_friction_are_of_its_joints_solved_anew) {
  const auto swept = [](double slip_force) {
    Case data = free_end_with_mass();
    const double f = resonance_of_mass;
    data.parts.push_back({"liner", sliding_liner(slip_force)});
    for (const bool friction : {false, true})
      data.analyses.life->sweeps.push_back({.name = friction ? "balanced" : "linear",
                                            .of = "y",
                                            .acceleration = 3,
                                            .force = {},
                                            .band = {f / 2, 3 * f},
                                            .octaves_per_minute = 2,
                                            .friction = friction});
    return with_error_bars(data);
  };
  const Results stuck = swept(1e6), slipping = swept(300);
  const auto span = [](const DutyResult& d, std::size_t i) {
    return (*d.damage_between)[i] / d.damage;
  };
  for (const std::size_t i : {0, 1}) {
    ASSERT_TRUE(duty(stuck, "balanced").damage_between &&
                duty(slipping, "balanced").damage_between);
    EXPECT_NEAR(span(duty(stuck, "balanced"), i) / span(duty(stuck, "linear"), i), 1, 0.02);
    EXPECT_GT(std::abs(std::log(span(duty(slipping, "balanced"), i))), 0.02);
  }
  for (const Results* r : {&stuck, &slipping}) ASSERT_TRUE(r->life->damage_between);
}

// A run four times finer along shows what places miss: most of it is in their mesh error, whose
// first order is too much rather than too little where the recovered stress is better than that.
// That of the hottest place is that of the headline.
TEST(MeshErrorOfStress, by_place_is_what_a_finer_mesh_shows) {
  Case data = coarse_bellows();
  data.analyses.life->strokes = {{.name = "one", .shift = {.axial = 1e-3}, .count = 1000}};
  const Results r = with_error_bars(data);
  Results fine = run_silently(refined(data, {.along = 4, .around = 1}));
  ASSERT_EQ(r.error_bars.places.size(), r.stress_tables.size());
  const StressTable &coarse_table = r.stress_tables[0], &fine_table = fine.stress_tables[0];
  ASSERT_EQ(coarse_table.rows.size(), fine_table.rows.size());
  double largest = 0, of_largest = 0;
  for (std::size_t i = 0; i < coarse_table.rows.size(); ++i) {
    const double found = std::abs(coarse_table.rows[i].von_mises);
    const double better = std::abs(fine_table.rows[i].von_mises);
    const MeshError& error = r.error_bars.places[0][i];
    ASSERT_TRUE(std::isfinite(error.total()));
    const double raw = found / better - 1, corrected = (found + error.along) / better - 1;
    EXPECT_LT(std::abs(corrected), 0.75 * std::abs(raw) + 1e-3)
        << r.places[std::size_t(coarse_table.rows[i].place)].name;
    EXPECT_LT(std::abs(corrected), 0.06);
    EXPECT_LT(raw * corrected, 1e-6) << "too much rather than too little";
    if (found > largest) {
      largest = found;
      of_largest = error.total();
    }
  }
  EXPECT_NEAR(of_largest / r.error_bars.stresses[0].total(), 1, 1e-6);
}

// A thin tube of shells, 0.6 m long, whose right end moves at random far below its modes.
constexpr double radius = 0.015, length = 0.6, wall = 1e-3, E = 193e9;
constexpr double W = 0.3, low = 5, high = 20; // (m/s2)2/Hz, Hz

Case moved_tube(int direction) {
  Case data = verification_case("bellows_a");
  Bellows& tube = bellows_of(data);
  tube.root_radius = radius;
  tube.profile = {{.shape = SectionShape::cuff, .length = length, .elements = 120, .points = {}}};
  tube.wall.plies = {wall};
  tube.mesh = {.around = 24, .arc = 2, .wall = 2};
  data.analyses.modes = Modes{.count = 10};
  data.analyses.damping.modal = 0.02;
  data.analyses.error_bars = false;
  Motion moved;
  moved.name = "end";
  moved.move = {"right"};
  moved.direction = direction;
  moved.random.emplace();
  moved.random->level = W;
  data.analyses.response =
      Response{.bases = {}, .motions = {moved}, .band = {low, high}, .points = 400};
  data.analyses.stress.emplace();
  data.analyses.life.emplace();
  data.analyses.life->curve = power_law();
  data.analyses.life->strokes = {{.name = "one", .shift = {}, .count = 1}};
  (direction == 1 ? data.analyses.life->strokes[0].shift.axial
                  : data.analyses.life->strokes[0].shift.lateral_x) = 1e-3;
  data.analyses.life->random = {{.name = "road", .of = "end", .duration = 3600}};
  return data;
}

// Of the displacement: int f^n W / (2 pi f)^4 df.
double moment(double n) {
  return W / std::pow(2 * pi, 4) * (std::pow(low, n - 3) - std::pow(high, n - 3)) / (3 - n);
}

const StressResult& rms_of(const Results& r) {
  for (const StressResult& s : r.stresses)
    if (s.kind == StressKind::rms) return s;
  throw std::runtime_error("no random stress");
}

// Largest von Mises of the middle surface's neighbours at a cut: mean of both faces.
double at_cut(const Results& r, const StressResult& s, double y) {
  double largest = 0;
  for (std::size_t i = 0; i < r.mesh.nodes.size(); ++i)
    if (std::abs(r.mesh.nodes[i].y() - y) < 1e-6 && std::isfinite(s.above[Eigen::Index(i)]))
      largest = std::max(largest, (s.above[Eigen::Index(i)] + s.below[Eigen::Index(i)]) / 2);
  return largest;
}

void expect_of_stroke(const Results& r) {
  const RandomStress& random = *duty(r, "road").random;
  const double stroke = std::sqrt(moment(0));
  EXPECT_NEAR(random.rms / (stroke / 1e-3 * duty(r, "one").range), 1, 0.005);
  EXPECT_NEAR(random.up_crossings / std::sqrt(moment(2) / moment(0)), 1, 0.005);
}

// Stretched by d: E d / L.
TEST(MovedEndsStress, of_a_tube_stretched_at_random_is_that_of_the_stroke) {
  const Results r = run_silently(moved_tube(1));
  const double rms = E * std::sqrt(moment(0)) / length;
  const double found = at_cut(r, rms_of(r), length / 2);
  print_for_table("random stretching of a tube, RMS in the middle, MPa", found / 1e6, rms / 1e6,
                  0.005);
  EXPECT_NEAR(found / rms, 1, 0.005);
  expect_of_stroke(r);
}

// Ends shifted across by d and kept parallel: 6 E r d / L^2 (1 - 2 x / L) / (1 + P), P = 12 E I /
// (G A_s L^2), half of it at x = L / 4; A_s = A / 2 of a thin ring.
TEST(MovedEndsStress, of_a_tube_shifted_at_random_is_that_of_a_beam) {
  const Results r = run_silently(moved_tube(0));
  const double P = 12 * 2.6 * (radius * radius / 2) / (0.5 * length * length);
  const double rms = 3 * E * radius * std::sqrt(moment(0)) / (length * length) / (1 + P);
  const double found = at_cut(r, rms_of(r), length / 4);
  print_for_table("random shift of a tube, RMS at a quarter, MPa", found / 1e6, rms / 1e6, 0.01);
  EXPECT_NEAR(found / rms, 1, 0.01);
  expect_of_stroke(r);
}

// A case that names published tests has their source, their scatter and an interval from it.
TEST(LifeIntervals, of_published_tests_are_of_their_scatter) {
  Case data = coarse_bellows();
  data.analyses.life->curve = {
      .name = "", .source = "", .law = PublishedCurve{.of = PublishedSteel::pipe_304L, .E = E}};
  data.analyses.life->strokes = {{.name = "one", .shift = {.axial = 8e-3}, .count = 1000}};
  Results r = run_silently(data);
  add_life_intervals(data, r);
  EXPECT_NE(r.life->curve.find("Hannes"), std::string::npos) << r.life->curve;
  const DutyResult& one = duty(r, "one");
  ASSERT_TRUE(one.between && one.life && one.life->bound == Bound::exact);
  EXPECT_NEAR(std::log((*one.between)[1].cycles / one.life->cycles), 1.6448536 * 0.36, 1e-6);
  EXPECT_FALSE(r.life->with_tolerances);
}

} // namespace
} // namespace plica::test::life_intervals
