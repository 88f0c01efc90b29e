// Measured beside computed: which numbers are paired, and what the model cannot show.
#include "tests/sample_results.hpp"

#include "compare/compare.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

MeasuredMode measured(double frequency, MeasuredShape shape, Axis direction, Axis base) {
  MeasuredMode m;
  m.frequency = frequency;
  m.shape = shape;
  m.direction = direction;
  m.base = base;
  return m;
}

TEST(Compare, pairs_modes_by_shape_direction_and_order) {
  Measured data;
  data.modes = {measured(130, MeasuredShape::axial, Axis::y, Axis::y),
                measured(260, MeasuredShape::axial, Axis::y, Axis::y),
                measured(140, MeasuredShape::axial, Axis::y, Axis::y)};
  data.modes[1].order = 2;
  Results results = sample();
  results.responses.clear();
  const auto rows = compare(results, data);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].computed, 131.26);
  EXPECT_EQ(rows[1].quantity, "axial mode 2");
  EXPECT_EQ(rows[1].computed, 262.1);
  EXPECT_EQ(rows[2].computed, 131.26) << "another test of the first mode";
}

// What was measured of another state has no place beside the case, and the others keep the numbers
// that the file gives them.
TEST(Compare, leaves_other_states_out_and_keeps_the_numbers_of_entries) {
  Measured data;
  data.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
                 {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  data.modes = {measured(90, MeasuredShape::axial, Axis::y, Axis::y),
                measured(130, MeasuredShape::axial, Axis::y, Axis::y)};
  data.modes[0].state = "after";
  data.modes[1].state = "before";
  Results results = sample();
  results.responses.clear();
  const auto rows = compare(results, data);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].entry, "modes[1]");
  EXPECT_EQ(rows[0].measured, 130);
}

TEST(Compare, never_pairs_a_second_mode_with_the_first_peak) {
  Measured data;
  data.modes = {measured(130, MeasuredShape::other, Axis::y, Axis::y),
                measured(480, MeasuredShape::other, Axis::y, Axis::y)};
  data.modes[0].damping = 0.011;
  data.modes[1].order = 2;
  const auto rows = compare(sample(), data);
  ASSERT_EQ(rows.size(), 2u) << "one peak: its frequency and its damping";
  EXPECT_EQ(rows[0].computed, 131.26);
  EXPECT_NEAR(rows[1].computed, 1.0, 1e-12);
}

TEST(Compare, pairs_the_peaks_of_one_sensor_in_order) {
  Measured data;
  data.modes = {measured(300, MeasuredShape::other, Axis::y, Axis::y),
                measured(130, MeasuredShape::other, Axis::y, Axis::y)};
  Results results = sample();
  ResponseResult& r = results.responses[0];
  const std::string sensor = r.channels[0].first;
  int channel = 0;
  while (r.channels[channel].second != "y") ++channel;
  for (MeasuredMode& m : data.modes) m.sensor = r.channels[channel].first;
  r.peaks = {{.channel = channel, .frequency = 131, .amplitude = 50, .damping = 0.01},
             {.channel = channel, .frequency = 200, .amplitude = 2, .damping = 0.01},
             {.channel = channel, .frequency = 310, .amplitude = 9, .damping = 0.01}};
  const auto rows = compare(results, data);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].computed, 310) << "the second largest";
  EXPECT_EQ(rows[1].computed, 131);
  EXPECT_EQ(rows[1].quantity, "frequency of the peak at " + sensor + " in y, base y");
  data.modes[0].sensor = "elsewhere";
  EXPECT_EQ(compare(results, data).size(), 1u);
}

TEST(Compare, says_what_has_no_path_and_only_that) {
  Measured data;
  data.modes = {measured(166, MeasuredShape::transverse, Axis::z, Axis::y)};
  ASSERT_EQ(unanswered(sample(), data).size(), 1u);
  EXPECT_NE(unanswered(sample(), data)[0].find("166 Hz in z while the base moved in y"),
            std::string::npos);
  data.modes = {measured(166, MeasuredShape::axial, Axis::y, Axis::y),       // along the base
                measured(900, MeasuredShape::transverse, Axis::z, Axis::y),  // beyond the band
                measured(166, MeasuredShape::transverse, Axis::z, Axis::x)}; // no such response
  EXPECT_TRUE(unanswered(sample(), data).empty());
}

} // namespace
} // namespace plica::test
