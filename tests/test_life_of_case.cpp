// Stress by place and fatigue life of whole cases: scaling, both routes, formulas beside, a mass on
// a spring by hand, random motion beside its history.
#include "life/miner.hpp"
#include "model/description/ejma.hpp"
#include "run/study/error_bars.hpp"
#include "run/study/life_intervals.hpp"
#include "tests/life_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace plica::test {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

using namespace life_case;

Case coarse_bellows() {
  return life_case::coarse_bellows({.around = 24, .arc = 4, .wall = 5});
}

LifeStroke axial(const std::string& name, double by, bool reversed = false) {
  LifeStroke stroke{.name = name, .shift = {}, .reversed = reversed, .count = 1000};
  stroke.shift.axial = by;
  return stroke;
}

// Twice the stroke, twice the stress; from minus to plus, twice again and no mean.
TEST(LifeOfCase, is_linear_in_the_stroke) {
  Case data = coarse_bellows();
  data.analyses.life->strokes = {axial("one", 1e-3), axial("two", 2e-3), axial("both", 1e-3, true)};
  const Results r = run_silently(data);
  const DutyResult &one = duty(r, "one"), &two = duty(r, "two"), &both = duty(r, "both");
  EXPECT_NEAR(two.range / one.range, 2, 1e-6);
  EXPECT_NEAR(both.range / one.range, 2, 1e-6);
  EXPECT_NEAR(std::abs(one.mean) / one.range, 0.5, 1e-6);
  EXPECT_NEAR(both.mean / both.range, 0, 1e-6);
  const double by_hand = 1000 / (knee_cycles * std::pow(2 * knee / one.range, slope));
  EXPECT_NEAR(one.damage / by_hand, 1, 1e-5);
  EXPECT_NEAR(two.damage / one.damage, 16, 1e-4);
  EXPECT_NEAR(r.life->spots[0].damage / (one.damage + two.damage + both.damage), 1, 1e-5);
}

// One sector or the whole mesh: the same places, the same numbers.
TEST(LifeOfCase, by_symmetry_is_that_of_the_full_mesh) {
  Case data = coarse_bellows();
  LifeStroke bent = axial("bent", 1e-3);
  bent.shift.lateral_x = 0.5e-3;
  bent.shift.angular_z = 0.01;
  data.analyses.life->strokes = {axial("one", 1e-3), bent};
  const Results symmetric = run_silently(data);
  data.analyses.symmetry = Symmetry::off;
  const Results full = run_silently(data);
  EXPECT_TRUE(symmetric.route.starts_with("rotational")) << symmetric.route;
  EXPECT_TRUE(full.route.starts_with("full")) << full.route;
  ASSERT_EQ(symmetric.places.size(), full.places.size());
  ASSERT_EQ(symmetric.places.size(), 21u) << "ten crowns, eleven roots, no cuffs";
  for (const char* name : {"one", "bent"})
    EXPECT_NEAR(duty(symmetric, name).range / duty(full, name).range, 1, 1e-5) << name;
  ASSERT_EQ(symmetric.stress_tables.size(), full.stress_tables.size());
  for (std::size_t t = 0; t < full.stress_tables.size(); ++t)
    for (std::size_t i = 0; i < full.stress_tables[t].rows.size(); ++i) {
      const PlaceStress &a = symmetric.stress_tables[t].rows[i], &b = full.stress_tables[t].rows[i];
      EXPECT_EQ(a.place, b.place);
      EXPECT_NEAR(a.von_mises, b.von_mises, 1e-4 * std::abs(b.von_mises));
    }
}

// A table holds together: faces are membrane -+ bending, von Mises follows from the components of
// an axisymmetric stress, and what S5 + S6 of EJMA are for is met within what ninety bellows showed
// of inner convolutions and held ends (0.97 to 1.20, docs/life.md; here C1 = 0.33, C2 = 0.78).
TEST(LifeOfCase, stress_of_a_stroke_beside_ejma) {
  Case data = without_modes(verification_case("bellows_a"));
  data.analyses.life.emplace();
  data.analyses.life->strokes = {axial("one", 1e-3)};
  const Results r = run_silently(data);
  ASSERT_EQ(r.stress_tables.size(), 1u);
  const StressTable& table = r.stress_tables[0];
  ASSERT_EQ(table.rows.size(), 2 * r.places.size());
  for (const PlaceStress& s : table.rows) {
    EXPECT_NEAR(s.meridional, s.meridional_membrane + (s.outer ? 1 : -1) * s.meridional_bending, 1);
    EXPECT_NEAR(s.hoop, s.hoop_membrane + (s.outer ? 1 : -1) * s.hoop_bending, 1);
    const double vm =
        std::sqrt(s.meridional * s.meridional + s.hoop * s.hoop - s.meridional * s.hoop);
    EXPECT_NEAR(std::abs(s.von_mises) / vm, 1, 2e-3);
    EXPECT_NEAR(s.principal[0], std::max(s.meridional, s.hoop), 2e-3 * vm);
  }
  const auto bellows =
      std::get<EjmaBellows>(ejma_bellows(bellows_of(data), data.materials.at("steel")));
  const EjmaStress ejma = ejma_stress(bellows, ejma_factors(bellows), 0, 1e-3 / 10);
  const double ratio = duty(r, "one").range / (ejma.S5 + ejma.S6);
  print_for_table("bellows A, largest stress of an axial stroke over S5 + S6 of EJMA", ratio, 1,
                  0.2);
  EXPECT_GT(ratio, 0.97);
  EXPECT_LT(ratio, 1.20);
  ASSERT_TRUE(table.meridian);
  EXPECT_NEAR(table.meridian->outer.cwiseAbs().maxCoeff() / std::abs(table.rows[0].meridional), 1,
              0.5);
}

// Damage along the wall: its largest is that of the first hot spot, on the face of that spot, and
// by an axial stroke convolution by convolution the same in the middle of the bellows.
TEST(LifeOfCase, damage_along_the_meridian_runs_through_the_hot_spot) {
  Case data = coarse_bellows();
  data.analyses.life->strokes = {axial("one", 1e-3)};
  const LifeResult life = *run_silently(data).life;
  ASSERT_TRUE(life.meridian);
  const MeridianDamage& m = *life.meridian;
  ASSERT_EQ(m.inner.size(), m.along.size());
  ASSERT_EQ(m.outer.size(), m.along.size());
  EXPECT_EQ(m.part, "bellows");
  const LifeSpot& spot = life.spots[0];
  EXPECT_NEAR((spot.outer ? m.outer : m.inner).maxCoeff() / spot.damage, 1, 1e-6);
  for (Eigen::Index i = 1; i < m.along.size(); ++i) EXPECT_GT(m.along[i], m.along[i - 1]);
  const Eigen::Index per = (m.along.size() - 1) / 10; // ten convolutions
  for (Eigen::Index i = 4 * per; i < 5 * per; ++i)
    EXPECT_NEAR(m.inner[i], m.inner[i + per], 0.02 * m.inner.maxCoeff());
}

// Bending stress of a ply goes with its thickness: 0.2 mm and 0.1 mm that slip as 2 to 1.
TEST(LifeOfCase, plies_that_slip_bend_each_by_its_thickness) {
  Case data = coarse_bellows();
  bellows_of(data).wall.plies = {0.2e-3, 0.1e-3};
  bellows_of(data).wall.bond = 0;
  data.analyses.life->strokes = {axial("one", 1e-3)};
  const StressTable table = run_silently(data).stress_tables[0];
  int pairs = 0;
  for (std::size_t i = 0; i + 1 < table.rows.size(); ++i) {
    const PlaceStress &a = table.rows[i], &b = table.rows[i + 1];
    if (a.ply != 1) continue;
    ++pairs;
    ASSERT_EQ(b.ply, 2);
    EXPECT_EQ(a.node, b.node);
    EXPECT_NEAR(a.meridional_bending / b.meridional_bending, 2, 1e-9);
    EXPECT_NEAR(a.meridional_membrane / b.meridional_membrane, 1, 1e-9);
  }
  EXPECT_EQ(pairs, 2 * 21);
}

// 20 kg on the end of bellows A (0.1 kg): an oscillator along the axis.
struct MassOnBellows {
  Case data = verification_case("bellows_a", {.around = 24, .arc = 4, .wall = 5}, 8);
  double zeta = 0;
  int mode = 0; // the axial one, from 1
  double hertz = 0;

  explicit MassOnBellows(double damping) : zeta(damping) {
    data.mount.pop_back(); // the right end is free
    data.caps[1].mass = 20;
    data.caps[1].inertia = {0.02, 0.02, 0.02, 0, 0, 0};
    data.analyses.error_bars = false;
    const Results r = run_silently(data);
    for (std::size_t i = 0; i < r.modes.size(); ++i)
      if (r.modes[i].effective_mass[1] > 10) {
        mode = int(i) + 1;
        hertz = r.modes[i].frequency;
      }
    EXPECT_NEAR(hertz, std::sqrt(r.statics->k_axial / 20.03) / (2 * pi), 0.005 * hertz);
    data.analyses.damping.modal = zeta;
    data.analyses.response =
        Response{.bases = {1}, .level = 1, .band = {hertz / 10, 2 * hertz}, .points = 400};
    data.analyses.life.emplace();
    data.analyses.life->curve = power_law();
    data.analyses.life->strokes = {axial("one", 1e-3)};
  }
};

// At resonance the mass moves by a / (2 zeta omega^2) against the base (a massless spring; its own
// mass and the other modes are worth 0.5 %), there and back: stress by the stroke of 1 mm, cycles
// by frequency and time.
TEST(LifeOfCase, dwell_at_a_resonance_is_that_by_hand) {
  MassOnBellows m(0.01);
  m.data.analyses.life->dwells = {{.name = "dwell",
                                   .of = "y",
                                   .acceleration = 2,
                                   .force = {},
                                   .mode = m.mode,
                                   .duration = 3600}};
  const Results r = run_silently(m.data);
  const double omega = 2 * pi * m.hertz, motion = 2 / (2 * m.zeta * omega * omega);
  const double range = 2 * motion / 1e-3 * duty(r, "one").range;
  const double cycles = 3600 * m.hertz;
  const double damage = cycles / (knee_cycles * std::pow(2 * knee / range, slope));
  print_for_table("dwell at resonance, stress range by hand, MPa", duty(r, "dwell").range / 1e6,
                  range / 1e6, 0.01);
  EXPECT_NEAR(duty(r, "dwell").range / range, 1, 0.01);
  EXPECT_NEAR(duty(r, "dwell").count / cycles, 1, 1e-6);
  EXPECT_NEAR(duty(r, "dwell").damage / damage, 1, 0.04) << "the fourth power";
}

// A slow sweep through the resonance: sum over frequencies of df / (R ln 2) cycles of the steady
// range, by hand for the oscillator. 1 % in stress is 4 % in damage.
TEST(LifeOfCase, sweep_through_a_resonance_is_that_by_hand) {
  MassOnBellows m(0.02);
  m.data.analyses.life->sweeps = {{.name = "sweep",
                                   .of = "y",
                                   .acceleration = 3,
                                   .force = {},
                                   .band = {m.hertz / 2, 2 * m.hertz},
                                   .octaves_per_minute = 2,
                                   .count = 3}};
  const Results r = run_silently(m.data);
  const double unit = duty(r, "one").range / 1e-3, rate = 2. / 60;
  double damage = 0;
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double f = m.hertz * (0.5 + 1.5 * (i + 0.5) / steps), s = f / m.hertz;
    const double motion = 3 / std::pow(2 * pi * m.hertz, 2) /
                          std::abs(std::complex<double>(1 - s * s, 2 * m.zeta * s));
    const double cycles = 3 * 1.5 * m.hertz / steps / (rate * std::numbers::ln2);
    damage += cycles / (knee_cycles * std::pow(2 * knee / (2 * motion * unit), slope));
  }
  EXPECT_NEAR(duty(r, "sweep").damage / damage, 1, 0.04);
}

// White acceleration of the base: RMS of a lightly damped oscillator is that of Miles, pi/2 f Q W
// for its absolute acceleration; of its stretch, over omega^2 (0.25 % more at 5 % of damping).
// Lightly damped: narrow band, and all methods within a few percent of its damage. Rainflow of a
// record of the same density, drawn with random phases, agrees within the scatter of 300 s: about
// 780 independent swings, slope 4, so a standard deviation of sqrt(5 / 780) = 8 %.
TEST(LifeOfCase, random_motion_is_miles_and_its_history) {
  MassOnBellows m(0.05);
  constexpr double W = 0.5, seconds = 300; // (m/s2)2/Hz
  m.data.analyses.response->random.emplace();
  m.data.analyses.response->random->level = W;
  m.data.analyses.life->random = {{.name = "road", .of = "y", .duration = seconds}};
  const double rate = 20 * m.hertz;
  const auto count = Eigen::Index(seconds * rate);
  VectorXd samples = VectorXd::Zero(count);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> phase(0, 2 * pi);
  for (double f = 0.1 * m.hertz; f < 2 * m.hertz;
       f += 1 / seconds) { // lines, by a turning phasor each
    std::complex<double> line = std::polar(std::sqrt(2 * W / seconds), phase(random));
    const std::complex<double> turn = std::polar(1., 2 * pi * f / rate);
    for (Eigen::Index i = 0; i < count; ++i, line *= turn) samples[i] += line.real();
  }
  LifeHistory history{.name = "record", .signals = {{.of = "y", .signal = {}}}, .repeats = 1};
  history.signals[0].signal.samples = samples;
  history.signals[0].signal.step = 1 / rate;
  m.data.analyses.life->histories = {history};
  const Results r = run_silently(m.data);
  const RandomStress& stress = *duty(r, "road").random;
  const double omega = 2 * pi * m.hertz, Q = 1 / (2 * m.zeta);
  const double rms =
      std::sqrt(pi / 2 * m.hertz * Q * W) / (omega * omega) / 1e-3 * duty(r, "one").range;
  print_for_table("random motion, RMS of the stress by Miles, MPa", stress.rms / 1e6, rms / 1e6,
                  0.01);
  EXPECT_NEAR(stress.rms / rms, 1, 0.01);
  EXPECT_NEAR(stress.up_crossings / m.hertz, 1, 0.03);
  double dirlik = 0, narrow = 0;
  for (const auto& [method, damage] : stress.damages) {
    if (method == "Dirlik") dirlik = damage;
    if (method == "narrow band") narrow = damage;
  }
  EXPECT_NEAR(dirlik / narrow, 1, 0.1);
  EXPECT_NEAR(duty(r, "road").damage / dirlik, 1, 1e-5);
  EXPECT_NEAR(duty(r, "record").damage / dirlik, 1, 0.24);
}

// A slider beside the bellows: that never slips it is a spring, and the harmonic balance gives the
// linear sweep; that slips it takes energy from the resonance, and with it damage.
TEST(LifeOfCase, sweep_with_friction_between_stuck_and_slipping) {
  const auto damage = [](double slip_force) {
    MassOnBellows m(0.02);
    m.data.parts.push_back({"liner", sliding_liner(slip_force)});
    m.data.analyses.life->strokes.clear();
    for (const bool friction : {false, true})
      m.data.analyses.life->sweeps.push_back({.name = friction ? "balanced" : "linear",
                                              .of = "y",
                                              .acceleration = 3,
                                              .force = {},
                                              .band = {m.hertz / 2, 3 * m.hertz},
                                              .friction = friction});
    const Results r = run_silently(m.data);
    return std::array{duty(r, "linear").damage, duty(r, "balanced").damage};
  };
  const auto stuck = damage(1e6), slipping = damage(300);
  EXPECT_NEAR(stuck[1] / stuck[0], 1, 0.01);
  EXPECT_NEAR(slipping[0] / stuck[0], 1, 1e-6) << "linear: small motion sticks";
  EXPECT_LT(slipping[1], 0.7 * stuck[1]);
}

// Half a millimetre of height changes stress and life; the interval of the life is that of the
// stress through the curve, here a power law, and a deviation widens it.
TEST(LifeOfCase, interval_of_a_life_is_that_of_its_stress) {
  Case data = coarse_bellows();
  data.tolerances = {
      {.path = "parts.bellows.profile[0].height", .value = 9e-3, .low = 8.5e-3, .high = 9.5e-3}};
  data.analyses.life->strokes = {axial("one", 1e-3)};
  Results r = run_silently(data);
  r.error_bars = error_bars(data, r, [](const std::string&) {});
  add_life_intervals(data, r);
  const ErrorBar* bar = nullptr;
  for (const ErrorBar& b : r.error_bars.bars)
    if (b.key == "life_one") bar = &b;
  ASSERT_TRUE(bar && bar->interval);
  EXPECT_LT(std::abs(bar->mesh.total() / bar->value), 0.1);
  const DutyResult& one = duty(r, "one");
  ASSERT_TRUE(one.between);
  const double expected = one.life->cycles * std::pow((*bar->interval)[1] / bar->value, -slope);
  EXPECT_NEAR((*one.between)[0].cycles / expected, 1, 1e-6);
  EXPECT_GT((*one.between)[1].cycles, 1.1 * one.life->cycles);
  const double tolerance = std::log10(one.life->cycles / (*one.between)[0].cycles);
  data.analyses.life->deviation = 0.2;
  add_life_intervals(data, r);
  EXPECT_NEAR(std::log10(one.life->cycles / duty(r, "one").between->at(0).cycles),
              std::hypot(tolerance, 1.6448536 * 0.2), 1e-6);
}

// A movement of the end as a history: rainflow of the stroke itself.
TEST(LifeOfCase, history_of_movement_is_its_rainflow) {
  Case data = coarse_bellows();
  data.analyses.life->strokes = {axial("one", 1e-3)};
  const std::vector<double> motion{0, 2, -1, 3, 0, 1, -2, 2, 0}; // mm
  LifeHistory history{.name = "trip", .signals = {{.of = "axial", .signal = {}}}, .repeats = 50};
  history.signals[0].signal.samples =
      1e-3 * VectorXd::Map(motion.data(), Eigen::Index(motion.size()));
  history.signals[0].signal.step = 1;
  data.analyses.life->histories = {history};
  const Results r = run_silently(data);
  std::vector<double> stress;
  for (const double x : motion) stress.push_back(x * duty(r, "one").range);
  EXPECT_NEAR(duty(r, "trip").damage / (50 * miner(power_law(), rainflow(stress)).damage), 1, 1e-4);
  EXPECT_NEAR(duty(r, "trip").range / duty(r, "one").range, 5, 1e-5);
}

// Below the curve of bellows: at least a million cycles, and the damage is at most that.
TEST(LifeOfCase, beyond_the_curve_is_a_bound) {
  Case data = coarse_bellows();
  data.analyses.life->curve = {.name = "bellows", .source = "", .law = BellowsCurve{}};
  data.analyses.life->strokes = {axial("little", 0.1e-3), axial("much", 4e-3)};
  const Results r = run_silently(data);
  const DutyResult& little = duty(r, "little");
  ASSERT_TRUE(little.life);
  EXPECT_EQ(little.life->bound, Bound::at_least);
  EXPECT_EQ(little.life->cycles, 1e6);
  EXPECT_TRUE(little.at_most);
  EXPECT_NEAR(little.damage, 1000 / 1e6, 1e-9);
  EXPECT_EQ(duty(r, "much").life->bound, Bound::exact);
  EXPECT_FALSE(duty(r, "much").at_most);
  EXPECT_NE(r.life->curve.find("factors of 3 on cycles and 1.25 on stress are inside"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
