// What a report of a run beside a test begins with: the number that is farthest off.
#include "tests/sample_results.hpp"

#include "io/tables/farthest.hpp"
#include "io/tables/summary.hpp"
#include "lab/measured/measured_words.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace {

using namespace plica;
using namespace plica::test;

// A damping that was assumed, and a mass that was weighed, are not what a model has wrong.
TEST(FarthestOff, is_no_number_that_the_case_was_given) {
  Results r;
  r.comparison = {
      {.quantity = "mass", .unit = "kg", .measured = 1, .computed = 2, .kind = ComparedKind::mass},
      {.quantity = "half-power damping of the peak",
       .unit = "%",
       .measured = 4,
       .computed = 1,
       .kind = ComparedKind::damping},
      {.quantity = "damping by energy of the first peak",
       .unit = "%",
       .measured = 4,
       .computed = 1,
       .kind = ComparedKind::damping},
      {.quantity = "amplitude of the first peak",
       .unit = "",
       .measured = 4,
       .computed = 16,
       .kind = ComparedKind::amplitude},
      {.quantity = "axial mode 1 in y", .unit = "Hz", .measured = 100, .computed = 101},
      {.quantity = "axial stiffness",
       .unit = "N/m",
       .measured = 100,
       .sigma = 1,
       .computed = 104,
       .kind = ComparedKind::stiffness}};
  const FarthestOff found = farthest_off(r);
  ASSERT_NE(found.row, nullptr);
  EXPECT_EQ(found.row->quantity, "axial stiffness");
  EXPECT_EQ(found.computed, 2);
  EXPECT_EQ(found.within, 1);
  const std::string text = summary_text(r);
  EXPECT_NE(text.find("Farthest from the test: axial stiffness"), std::string::npos) << text;
  EXPECT_NE(text.find("(+4.0 %, +4.0 sigma); 1 of 2 computed numbers lie within 2 sigma (2 % "
                      "where the test states none)"),
            std::string::npos)
      << text;
  r.comparison.resize(4);
  EXPECT_EQ(farthest_off(r).row, nullptr);
}

// A frequency that is known to a thousandth is 10 sigma off, a stiffness of unknown error by 30 %.
TEST(FarthestOff, is_judged_by_one_measure) {
  Results r;
  r.comparison = {
      {.quantity = "axial mode 1", .unit = "Hz", .measured = 100, .sigma = 0.1, .computed = 101},
      {.quantity = "axial stiffness",
       .unit = "N/m",
       .measured = 100,
       .computed = 130,
       .kind = ComparedKind::stiffness}};
  EXPECT_EQ(farthest_off(r).row->quantity, "axial stiffness");
}

// Of a mode itself, of a peak the nearest, of a stiffness the first that moves the part that way.
TEST(FarthestOff, has_a_mode_that_shows_it) {
  Results r;
  r.modes = {mode_of(90, "transverse", "x", 1, -1), mode_of(91, "transverse", "z", 1, -1),
             mode_of(130, "axial", "", 1, -1), mode_of(300, "torsion", "", 1, -1)};
  const auto of_frequency = [&](double computed) {
    return mode_that_shows(r, {.quantity = "a mode", .unit = "Hz", .computed = computed});
  };
  const auto of_stiffness = [&](StaticDirection direction) {
    return mode_that_shows(r, {.quantity = stiffness_name(direction),
                               .unit = stiffness_unit(direction),
                               .computed = 5e4,
                               .kind = ComparedKind::stiffness,
                               .static_test = int(direction)});
  };
  EXPECT_EQ(of_frequency(130), 2U);
  EXPECT_EQ(of_frequency(91.2), 1U);
  EXPECT_EQ(of_stiffness(StaticDirection::transverse_x), 0U);
  EXPECT_EQ(of_stiffness(StaticDirection::transverse_z), 1U);
  EXPECT_EQ(of_stiffness(StaticDirection::axial), 2U);
  EXPECT_EQ(of_stiffness(StaticDirection::torsion), 3U);
  EXPECT_EQ(of_stiffness(StaticDirection::bending_x), std::nullopt);
}

} // namespace
