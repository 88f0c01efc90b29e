// The EJMA sheet: movements, pressures, and what stands beside the shells.
//
// Sources: beam theory for the movements and for the column; worksheet of EJMA example A (see
// test_ejma.cpp) for stress; ASME VIII-2 table 4.19.5 for cycles.
#include "io/write/write_ejma.hpp"
#include "run/study/bellows_shells.hpp"
#include "run/study/ejma_sheet.hpp"
#include "tests/bellows_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

constexpr double per_inch = 0.0254, per_psi = 6894.757293168;

const EjmaBellows worksheet_a{.inner_diameter = 38 * per_inch,
                              .depth = 1.095 * per_inch,
                              .pitch = 1 * per_inch,
                              .torus_radius = 0.25 * per_inch,
                              .thickness = 0.03 * per_inch,
                              .convolutions = 6,
                              .E = 29e6 * per_psi,
                              .tangent = 1 * per_inch};

TEST(EjmaSheets, the_polynomials_give_every_stress_of_example_a_within_its_reading) {
  const EjmaStress s =
      ejma_stress(worksheet_a, ejma_factors(worksheet_a), 14.5 * per_psi, 0.0525 * per_inch);
  for (const auto& [value, printed] :
       {std::pair{s.S3, 268.56}, {s.S4, 6762.44}, {s.S5, 307.17}, {s.S6, 38386.3}})
    EXPECT_NEAR(value / (printed * per_psi), 1, 0.015);
}

// Circumferential stress balances the pressure on the area that it is spread over.
TEST(EjmaSheets, circumferential_stresses_balance_the_pressure) {
  const double P = 14.5 * per_psi, Dm = ejma_mean_diameter(worksheet_a);
  const EjmaStress s = ejma_stress(worksheet_a, ejma_factors(worksheet_a), P, 0);
  EXPECT_NEAR(2 * s.S2 * ejma_metal_area(worksheet_a) / (P * Dm * worksheet_a.pitch), 1, 1e-12);
  EXPECT_NEAR(s.S1 * 2 * worksheet_a.thickness /
                  (P * (worksheet_a.inner_diameter + worksheet_a.thickness)),
              1, 1e-12);
}

// Ends held: the curvature of a clamped beam moved across is 6 y / L^2 at its ends, of one bent
// evenly theta / L; a convolution at the distance Dm/2 moves by that times q Dm / 2.
TEST(EjmaSheets, movements_of_a_convolution_are_those_of_a_beam) {
  const double L = ejma_length(worksheet_a), Dm = ejma_mean_diameter(worksheet_a);
  const double of_curvature = worksheet_a.pitch * Dm / 2;
  const EjmaEquivalent e =
      ejma_equivalent(worksheet_a, {.axial = 0, .lateral = 1e-3, .angular = -0.01});
  EXPECT_NEAR(e.lateral / (6 * 1e-3 / (L * L) * of_curvature), 1, 1e-12);
  EXPECT_NEAR(e.angular / (0.01 / L * of_curvature), 1, 1e-12);
  EXPECT_DOUBLE_EQ(ejma_equivalent(worksheet_a, {.axial = -6e-3}).sum(), 1e-3);
  EXPECT_GT(ejma_equivalent(worksheet_a, {.axial = -0.01, .lateral = 1e-3}).lateral, e.lateral);
  EXPECT_THROW(ejma_equivalent(worksheet_a, {.axial = -1.01 * L}), std::invalid_argument);
}

// The elastic column, both ends held, P pi Dm^2/4 = 4 pi^2 EI / L^2 with EI = K L Dm^2/8, buckles
// at 2 pi K / L; EJMA allows 0.17 of it.
TEST(EjmaSheets, column_squirm_is_a_set_share_of_the_elastic_column) {
  const EjmaFactors c = ejma_factors(worksheet_a);
  const double K = ejma_convolution_stiffness(worksheet_a, c) / worksheet_a.convolutions;
  const double elastic = 2 * std::numbers::pi * K / ejma_length(worksheet_a);
  EXPECT_NEAR(ejma_column_squirm(worksheet_a, c) / elastic, 0.17, 1e-12);
  // In plane: without bending by pressure (Cp = 0) a = 2, by much bending a = 4 d^2.
  EjmaFactors none = c;
  none.Cp = 0;
  const double area =
      ejma_metal_area(worksheet_a) / (ejma_mean_diameter(worksheet_a) * worksheet_a.pitch);
  EXPECT_NEAR(ejma_in_plane_squirm(worksheet_a, none, 200e6), 1.3 * 200e6 * area / std::sqrt(2.),
              1e-3);
  EXPECT_LT(ejma_in_plane_squirm(worksheet_a, c, 200e6, 1.1),
            ejma_in_plane_squirm(worksheet_a, c, 200e6));
}

const SheetLine& line_of(const EjmaSheet& sheet, const std::string& key) {
  for (const SheetLine& line : sheet.lines)
    if (line.key == key) return line;
  throw std::runtime_error("no line " + key);
}

std::vector<EjmaSheet> sheets_of(const Case& data, const EjmaRequest& request) {
  return ejma_sheets(data, request, [](const std::string&) {});
}

// Bellows A: 5.418e4 N/m, 376.5 and 598.1 Hz by an independent shell of revolution (its case file);
// EJMA 5.258e4 N/m.
TEST(EjmaSheets, the_sheet_of_bellows_a_has_both_columns) {
  const EjmaRequest request{.pressure = 50e3,
                            .movement = {.axial = 4e-3, .lateral = 1e-3, .angular = 0.01},
                            .cycles = 1e4,
                            .yield = 400e6};
  const std::vector<EjmaSheet> sheets = sheets_of(verification_case("bellows_a"), request);
  ASSERT_EQ(sheets.size(), 1u);
  const EjmaSheet& sheet = sheets.front();
  EXPECT_EQ(sheet.refused, "");
  EXPECT_NEAR(*line_of(sheet, "k_axial").formula / 5.258e4, 1, 0.001);
  EXPECT_NEAR(*line_of(sheet, "k_axial").shells / 5.418e4, 1, 0.02);
  EXPECT_NEAR(*line_of(sheet, "k_torsion").shells / 1.7541e4, 1, 0.02);
  EXPECT_NEAR(*line_of(sheet, "f_axial").shells / 376.5, 1, 0.02);
  EXPECT_NEAR(*line_of(sheet, "f_axial").formula / 372.7, 1, 0.02); // of its softer K
  EXPECT_NEAR(*line_of(sheet, "f_lateral").shells / 598.1, 1, 0.02);
  EXPECT_NEAR(*line_of(sheet, "f_lateral_rotary").formula / 593.5, 1, 0.02);
  EXPECT_NEAR(*line_of(sheet, "mass").formula / 0.09731, 1, 0.01);
  const double St = *line_of(sheet, "St").formula;
  EXPECT_NEAR(*line_of(sheet, "N_allowed").formula / std::pow(35850 / (St / 1e6 - 264), 2), 1,
              1e-9);
  EXPECT_NEAR(*line_of(sheet, "damage").formula * *line_of(sheet, "N_allowed").formula, 1e4, 1e-6);
  EXPECT_NE(ejma_text(sheets).find("3 on cycles and 1.25 on stress"), std::string::npos);
}

// Along the axis as the coefficients of an independent ring model, which differ from the tables by
// up to 5 %. Across and bent, the formulas move a convolution as at its mean diameter; root and
// crown lie at (1 -+ w/Dm) times that.
TEST(EjmaSheets, stress_of_the_shells_is_near_the_formulas_for_every_movement) {
  const auto ratio = [](const EjmaMovement& m) {
    const auto sheets = sheets_of(verification_case("bellows_a"), {.movement = m});
    const SheetLine& s = line_of(sheets[0], "S6");
    return *s.shells / *s.formula;
  };
  const double axial = ratio({.axial = 1e-6}), reach = 9. / 61;
  EXPECT_NEAR(axial, 1, 0.05);
  for (const EjmaMovement& m : {EjmaMovement{.lateral = 1e-3}, EjmaMovement{.angular = 0.01}})
    EXPECT_NEAR(ratio(m) / axial, 1, reach);
}

TEST(EjmaSheets, movements_add_up_in_the_worst_place) {
  Case data = verification_case("bellows_a");
  const BellowsStatics shells(bellows_alone(data, data.parts.front()), [](const std::string&) {});
  const double axial = shells.stress({.axial = 1e-3}).face;
  const double lateral = shells.stress({.lateral = 1e-3}).face;
  const double both = shells.stress({.axial = 1e-3, .lateral = 1e-3}).face;
  EXPECT_LE(both, axial + lateral + 1e-6);
  EXPECT_GT(both, std::max(axial, lateral));
  EXPECT_DOUBLE_EQ(shells.stress({.axial = -1e-3, .lateral = -1e-3}).face, both);
}

TEST(EjmaSheets, a_profile_that_is_no_u_has_the_shells_alone) {
  Case data = verification_case("bellows_a");
  bellows_of(data).profile.front().shape = SectionShape::omega;
  bellows_of(data).profile.front().root_arc_radius = 1.6e-3;
  bellows_of(data).profile.front().crown_arc_radius = 1.6e-3;
  const auto sheets = sheets_of(data, {.movement = {.axial = 1e-3}});
  EXPECT_EQ(sheets[0].refused, "its convolutions are no U");
  EXPECT_FALSE(line_of(sheets[0], "k_axial").formula);
  EXPECT_TRUE(line_of(sheets[0], "k_axial").shells);
  EXPECT_FALSE(sheets[0].life);
}

TEST(EjmaSheets, coefficients_out_of_range_are_refused_by_their_names) {
  Case data = verification_case("bellows_a");
  bellows_of(data).wall.plies = {0.005e-3};
  const auto sheets = sheets_of(data, {.shells = false});
  EXPECT_NE(sheets[0].refused.find("C2"), std::string::npos);
  EXPECT_TRUE(sheets[0].lines.empty());
}

TEST(EjmaSheets, what_no_bellows_can_follow_is_an_error) {
  Case data = verification_case("bellows_a");
  const EjmaRequest crushed{.movement = {.axial = -0.07}, .Kg = 5, .shells = false};
  try {
    sheets_of(data, crushed);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
  bellows_of(data).profile.front().shape = SectionShape::cuff;
  bellows_of(data).profile.front().length = 0.05;
  EXPECT_THROW(sheets_of(data, {.shells = false}), InputError);
}

TEST(EjmaSheets, plies_that_slip_and_plies_that_differ) {
  Case data = verification_case("bellows_a");
  bellows_of(data).wall = {.plies = {0.15e-3, 0.15e-3}, .bond = 0};
  const auto slipping = sheets_of(data, {.shells = false});
  EXPECT_EQ(*line_of(slipping[0], "n").formula, 2);
  bellows_of(data).wall.plies = {0.1e-3, 0.2e-3};
  EXPECT_EQ(sheets_of(data, {.shells = false})[0].refused, "its plies differ in thickness");
}

TEST(EjmaSheets, tables_say_where_a_life_is_a_bound) {
  const auto sheets = sheets_of(verification_case("bellows_a"),
                                {.movement = {.axial = 0.1e-3}, .cycles = 1e4, .shells = false});
  EXPECT_EQ(sheets[0].life->bound, Bound::at_least);
  EXPECT_NE(ejma_text(sheets).find("at least 1000000"), std::string::npos);
  EXPECT_NE(ejma_text(sheets).find("at most 0.01"), std::string::npos);
  EXPECT_NE(ejma_csv(sheets).find("N_allowed"), std::string::npos);
  EXPECT_NE(ejma_json(sheets, "a").find("\"formula_bound\": \"at least\""), std::string::npos);
}

} // namespace
} // namespace plica::test
