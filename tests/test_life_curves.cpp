// Fatigue curves.
//
// Sources: ASME VIII-2 (2010) table 4.19.5 in MPa and in psi; closed forms of Basquin, Coffin and
// Manson, and of Smith, Watson and Topper, whatever the constants of the steel.
#include "life/curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plica::test {
namespace {

constexpr double psi_to_pascal = 6894.757293168;

FatigueCurve curve_of(FatigueLaw law) {
  return {.name = "curve", .source = "", .law = std::move(law)};
}

double cycles_of(const FatigueCurve& curve, double range, double mean = 0) {
  return life(curve, {.range = range, .mean = mean}).cycles;
}

// The table gives the curve twice; both must agree to the rounding of its numbers.
TEST(LifeCurves, the_bellows_curve_in_mpa_is_the_one_in_psi) {
  const FatigueCurve curve = curve_of(BellowsCurve{});
  for (const double psi : {40e3, 50e3, 60e3, 64e3, 66e3, 80e3, 110e3, 200e3}) {
    const double root = psi >= 65e3 ? 5.2e6 / (psi - 38300) : 6.7e6 / (psi - 30600);
    EXPECT_NEAR(cycles_of(curve, psi * psi_to_pascal) / (root * root), 1, 0.01) << psi;
  }
}

TEST(LifeCurves, the_bellows_curve_has_no_steps_and_ends_at_a_million) {
  const FatigueCurve curve = curve_of(BellowsCurve{});
  EXPECT_NEAR(cycles_of(curve, 448e6), 38000, 100);
  EXPECT_NEAR(cycles_of(curve, 447.999e6) / cycles_of(curve, 448e6), 1, 2e-3);
  EXPECT_NEAR(cycles_of(curve, 257.3e6), 1e6, 1e4);
  const CurveLife low = life(curve, {.range = 257e6});
  EXPECT_EQ(low.cycles, 1e6);
  EXPECT_EQ(low.bound, Bound::at_least);
  EXPECT_EQ(text_of(low), "at least 1000000");
  EXPECT_EQ(life(curve, {.range = 1e12}).bound, Bound::at_most);
}

TEST(LifeCurves, notches_and_heat_act_on_the_stress_of_the_bellows_curve) {
  EXPECT_EQ(cycles_of(curve_of(BellowsCurve{.Kg = 2}), 300e6),
            cycles_of(curve_of(BellowsCurve{}), 600e6));
  EXPECT_EQ(cycles_of(curve_of(BellowsCurve{.E_ratio = 1.25}), 400e6),
            cycles_of(curve_of(BellowsCurve{}), 500e6));
  FatigueCurve hot = curve_of(BellowsCurve{});
  hot.temperature_factor = 0.8;
  EXPECT_EQ(cycles_of(hot, 400e6), cycles_of(curve_of(BellowsCurve{}), 500e6));
  EXPECT_NE(what_is_inside(hot).find("3 on cycles and 1.25 on stress"), std::string::npos);
}

TEST(LifeCurves, stress_life_with_a_limit_and_with_a_second_slope) {
  StressLifeCurve law{.knee_amplitude = 200e6, .knee_cycles = 2e6, .slope = 5, .fewest = 1e3};
  EXPECT_NEAR(cycles_of(curve_of(law), 800e6), 2e6 / 32, 1e-6);
  EXPECT_TRUE(std::isinf(cycles_of(curve_of(law), 399e6)));
  EXPECT_EQ(text_of(life(curve_of(law), {.range = 399e6})), "unlimited");
  EXPECT_EQ(life(curve_of(law), {.range = 4e9}).bound, Bound::at_most);
  law.second_slope = 9;
  EXPECT_NEAR(cycles_of(curve_of(law), 200e6), 2e6 * 512, 1e-3);
}

TEST(LifeCurves, mean_stress_by_goodman_and_by_smith_watson_topper) {
  FatigueCurve curve =
      curve_of(StressLifeCurve{.knee_amplitude = 200e6, .knee_cycles = 2e6, .slope = 5});
  curve.mean_stress = MeanStress::goodman;
  curve.ultimate = 600e6;
  EXPECT_NEAR(equivalent_amplitude(curve, {.range = 400e6, .mean = 300e6}), 400e6, 1e-3);
  EXPECT_NEAR(equivalent_amplitude(curve, {.range = 400e6, .mean = -300e6}), 200e6, 1e-3);
  EXPECT_EQ(cycles_of(curve, 400e6, 600e6), 0);
  curve.mean_stress = MeanStress::smith_watson_topper;
  // R = 0: sqrt(2) Sa, Dowling, Mechanical Behavior of Materials, eq. for R = 0.
  EXPECT_NEAR(equivalent_amplitude(curve, {.range = 400e6, .mean = 200e6}), std::sqrt(2.) * 200e6,
              1e-3);
  EXPECT_TRUE(std::isinf(cycles_of(curve, 400e6, -200e6)));
}

const StrainLifeCurve steel{.E = 203e9, .sf = 896e6, .b = -0.12, .ef = 0.41, .c = -0.51};

TEST(LifeCurves, strain_life_solves_coffin_manson_without_mean) {
  for (const double N : {10., 1e3, 1e5, 1e7}) {
    const double ea =
        steel.sf / steel.E * std::pow(2 * N, steel.b) + steel.ef * std::pow(2 * N, steel.c);
    EXPECT_NEAR(cycles_of(curve_of(steel), 2 * steel.E * ea) / N, 1, 1e-9);
  }
}

// Where elastic and plastic strain are equal: 2N = (ef E / sf)^(1/(b-c)).
TEST(LifeCurves, the_transition_life_of_strain_life) {
  const double reversals = std::pow(steel.ef * steel.E / steel.sf, 1 / (steel.b - steel.c));
  const double ea = 2 * steel.sf / steel.E * std::pow(reversals, steel.b);
  EXPECT_NEAR(2 * cycles_of(curve_of(steel), 2 * steel.E * ea) / reversals, 1, 1e-9);
  EXPECT_NEAR(cyclic_stress(steel, ea), steel.E * ea / 2, 1e-6 * steel.E * ea);
}

TEST(LifeCurves, strain_life_with_mean_solves_smith_watson_topper) {
  const double ea = 2e-3, mean = 150e6;
  const double N = cycles_of(curve_of(steel), 2 * steel.E * ea, mean);
  const double right = steel.sf * steel.sf / steel.E * std::pow(2 * N, 2 * steel.b) +
                       steel.sf * steel.ef * std::pow(2 * N, steel.b + steel.c);
  EXPECT_NEAR((mean + cyclic_stress(steel, ea)) * ea / right, 1, 1e-9);
  EXPECT_LT(N, cycles_of(curve_of(steel), 2 * steel.E * ea));
  EXPECT_TRUE(std::isinf(cycles_of(curve_of(steel), 2 * steel.E * ea, -1e9)));
}

TEST(LifeCurves, a_table_is_straight_in_a_log_log_plot_and_says_where_it_ends) {
  const FatigueCurve curve =
      curve_of(TableCurve{.points = {{1e3, 400e6}, {1e5, 200e6}, {1e7, 150e6}}});
  EXPECT_NEAR(cycles_of(curve, 2 * 400e6), 1e3, 1e-6);
  EXPECT_NEAR(cycles_of(curve, 2 * 200e6), 1e5, 1e-4);
  EXPECT_NEAR(cycles_of(curve, 2 * std::sqrt(400e6 * 200e6)), 1e4, 1e-4);
  EXPECT_EQ(life(curve, {.range = 2 * 149e6}).bound, Bound::at_least);
  EXPECT_EQ(life(curve, {.range = 2 * 401e6}).bound, Bound::at_most);
  EXPECT_EQ(life(curve, {.range = 2 * 160e6}).bound, Bound::exact);
}

TEST(LifeCurves, everything_wrong_with_a_curve_is_said_at_once) {
  FatigueCurve curve =
      curve_of(StressLifeCurve{.knee_amplitude = -1, .knee_cycles = 0, .slope = 5});
  curve.mean_stress = MeanStress::goodman;
  curve.temperature_factor = 0;
  EXPECT_EQ(check(curve).size(), 4u);
  curve = curve_of(TableCurve{.points = {{1e3, 200e6}, {1e4, 300e6}, {1e3, 100e6}}});
  EXPECT_EQ(check(curve).size(), 2u);
  curve = curve_of(BellowsCurve{.Kg = 5});
  curve.mean_stress = MeanStress::smith_watson_topper;
  EXPECT_EQ(check(curve).size(), 2u);
  EXPECT_TRUE(check(curve_of(steel)).empty());
  EXPECT_THROW(life(curve_of(steel), {.range = -1}), std::invalid_argument);
}

// Table 1 of Hannes et al. (Fatigue Design 2017): N = 591 (e_a - 0.056 %)^-2.07 of plain pipe, e_a
// in percent; with a butt weld 1.79 times the strain in 416 (e_a - 0.056 %)^-2.22. Bounds where
// nothing was tested.
TEST(LifeCurves, published_tests_have_the_constants_and_the_range_of_their_source) {
  constexpr double E = 200e9;
  const FatigueCurve plain = curve_of(PublishedCurve{.of = PublishedSteel::pipe_304L, .E = E});
  const FatigueCurve weld =
      curve_of(PublishedCurve{.of = PublishedSteel::pipe_304L_butt_weld, .E = E});
  const auto range_of = [](double percent) { return 2 * E * percent / 100; };
  EXPECT_NEAR(cycles_of(plain, range_of(0.2)) / (591 * std::pow(0.144, -2.07)), 1, 1e-12);
  EXPECT_NEAR(cycles_of(plain, range_of(0.2)) / 32640, 1, 1e-3);
  EXPECT_NEAR(cycles_of(weld, range_of(0.1)) / (416 * std::pow(0.123, -2.22)), 1, 1e-12);
  for (const FatigueCurve& curve : {plain, weld}) {
    const CurveLife little = life(curve, {.range = range_of(0.03)});
    EXPECT_EQ(little.bound, Bound::at_least);
    EXPECT_EQ(little.cycles, 1.25e6);
    const CurveLife much = life(curve, {.range = range_of(1)});
    EXPECT_EQ(much.bound, Bound::at_most);
    EXPECT_EQ(much.cycles, 5400);
    EXPECT_NEAR(*deviation_of(curve), 0.36 / std::log(10.), 1e-12);
    EXPECT_NE(std::string(tests_of(std::get<PublishedCurve>(curve.law).of).source).find("Hannes"),
              std::string::npos);
  }
  EXPECT_FALSE(deviation_of(curve_of(BellowsCurve{})));
  EXPECT_FALSE(check(curve_of(PublishedCurve{})).empty()) << "a modulus is needed";
}

// Design curves of codes by their points: I-9.2M of ASME III is for E = 195 GPa, a wall of another
// modulus has its stress in proportion; RCC-MRx has ranges of strain, over the temperature.
TEST(LifeCurves, design_curves_of_codes_have_their_points) {
  constexpr double E = 195e9;
  const auto asme = [](double modulus) {
    return curve_of(PublishedCurve{.of = PublishedSteel::austenitic_asme_III, .E = modulus});
  };
  for (const auto& [N, Sa] : {std::pair{1e1, 6000e6}, {1e3, 745e6}, {1e6, 126e6}, {1e11, 93.7e6}}) {
    EXPECT_NEAR(cycles_of(asme(E), 2 * Sa * (1 + 1e-12)) / N, 1, 1e-6);
    EXPECT_NEAR(cycles_of(asme(0.9 * E), 2 * 0.9 * Sa * (1 + 1e-12)) / N, 1, 1e-6);
  }
  const double between =
      std::sqrt(974e6 * 745e6); // 500 and 1000 cycles: straight in a log-log plot
  EXPECT_NEAR(cycles_of(asme(E), 2 * between) / std::sqrt(500. * 1000), 1, 1e-9);
  EXPECT_EQ(life(asme(E), {.range = 2 * 90e6}).bound, Bound::at_least);
  EXPECT_EQ(life(asme(E), {.range = 2 * 90e6}).cycles, 1e11);
  EXPECT_EQ(life(asme(E), {.range = 2 * 6100e6}).bound, Bound::at_most);
  EXPECT_TRUE(is_design(asme(E)));
  EXPECT_FALSE(deviation_of(asme(E)));
  EXPECT_NE(what_is_inside(asme(E)).find("12 on cycles and 2 on stress"), std::string::npos);
  FatigueCurve twice = asme(E);
  twice.mean_stress = MeanStress::smith_watson_topper;
  EXPECT_EQ(check(twice).size(), 1u) << "it has its own";

  double before = 0;
  for (int i = int(PublishedSteel::rcc_mrx_316LN_650C); i >= int(PublishedSteel::rcc_mrx_316LN);
       --i) { // colder, longer
    const FatigueCurve curve = curve_of(PublishedCurve{.of = PublishedSteel(i), .E = E});
    EXPECT_TRUE(check(curve).empty());
    const double N = cycles_of(curve, 0.5e-2 * E);
    EXPECT_GT(N, before) << tests_of(PublishedSteel(i)).name;
    before = N;
  }
  const FatigueCurve cold = curve_of(PublishedCurve{.of = PublishedSteel::rcc_mrx_316LN, .E = E});
  EXPECT_NEAR(cycles_of(cold, 0.698e-2 * E * (1 + 1e-12)) / 1000, 1, 1e-6);
  for (const PublishedTests& tests : published_tests())
    for (std::size_t i = 1; i < tests.points.size(); ++i) {
      EXPECT_GT(tests.points[i][0], tests.points[i - 1][0]) << tests.name;
      EXPECT_LT(tests.points[i][1], tests.points[i - 1][1]) << tests.name;
    }
}

} // namespace
} // namespace plica::test
