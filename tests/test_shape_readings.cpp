// Components of mode shapes as readings of a diagnosis.
#include "changed_beam.hpp"
#include "diagnose/readings/shape_readings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plica {
namespace {

using namespace changed_beam;

// Where a hammer strikes, m along the beam: h1, h2, ...
void add_stations(Measured& m, const std::vector<double>& along) {
  for (double y : along)
    m.sensors.push_back({.name = "h" + std::to_string(m.sensors.size() + 1), .at = {0, y, 0}});
}

// The shapes of all modes at the stations along the direction of each, as the case has them, off by
// hundredths of the largest.
void add_shapes(Measured& m, const Case& truth, const std::string& state) {
  for (MeasuredMode& mode : m.modes) {
    if (mode.state != state) continue;
    MeasuredVector& v = mode.vector.emplace();
    const std::array some_start{1., 0.3, -0.7, 0.5, 0.9}; // like no mode, and across none
    for (std::size_t i = 0; i < m.sensors.size(); ++i) {
      v.channels.push_back(m.sensors[i].name + (mode.direction == Axis::x ? ".x" : ".z"));
      v.real.push_back(some_start[i % some_start.size()]);
    }
  }
  const Eigen::VectorXd y = read_by(truth, m);
  const std::vector<Reading> readings = readings_of({.data = m, .responses = {}}).readings;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Reading& r = readings[i];
    MeasuredMode& mode = m.modes[std::stoul(r.entry.substr(6))];
    if (r.kind != ReadingKind::component || mode.state != state) continue;
    mode.vector->real[std::size_t(r.channel)] = y[Eigen::Index(i)];
  }
  constexpr std::array off{0.02, -0.01, 0.015, -0.02, 0.01, -0.005, 0.02};
  std::size_t next = state.size();
  for (MeasuredMode& mode : m.modes) {
    if (mode.state != state) continue;
    std::vector<double>& real = mode.vector->real;
    const double largest =
        Eigen::VectorXd::Map(real.data(), Eigen::Index(real.size())).cwiseAbs().maxCoeff();
    for (double& x : real) x = x / largest + off[next++ % off.size()];
  }
}

std::vector<Reading> components_of(const TestReadings& test) {
  std::vector<Reading> found;
  for (const Reading& r : test.readings)
    if (r.kind == ReadingKind::component) found.push_back(r);
  return found;
}

Measured one_mode(const MeasuredVector& vector) {
  Measured m;
  m.specimen = "beam";
  add_stations(m, {0.5, 1});
  m.modes.push_back(bending(Axis::z, 1, "", 10));
  m.modes.back().vector = vector;
  return m;
}

// First mode of a slender cantilever: 0.339523 of the tip's motion half way (Blevins 1979).
TEST(ShapeReadings, a_cantilever_answers_its_shape_scaled_to_the_measured_one) {
  const Case beam = beam_of(4, 1, 0.02, 0.01, true);
  const Measured m = one_mode({.channels = {"h1.z", "h2.z"}, .real = {-0.7, -2}, .imaginary = {}});
  const TestReadings readings = readings_of({.data = m, .responses = {}});
  const std::vector<Reading> components = components_of(readings);
  ASSERT_EQ(components.size(), 2U);
  EXPECT_NEAR(std::abs(components[0].value), 0.35, 1e-12);
  EXPECT_NEAR(std::abs(components[1].value), 1, 1e-12);
  const Eigen::VectorXd y = read_by(beam, m);
  EXPECT_NEAR(y[1] / y[2], 0.339523, 2e-3);
  // Scaled by least squares: what it leaves is across the shape.
  const Eigen::Vector2d left(components[0].value - y[1], components[1].value - y[2]);
  EXPECT_NEAR(left.dot(y.tail(2)), 0, 1e-9);
}

TEST(ShapeReadings, a_station_that_lies_beside_the_part_takes_no_other_with_it) {
  const Case beam = beam_of(4, 1, 0.02, 0.01, true);
  Measured m =
      one_mode({.channels = {"h1.z", "beside.z", "h2.z"}, .real = {0.34, 0.7, 1}, .imaginary = {}});
  m.sensors.push_back({.name = "beside", .at = {0.3, 0.7, 0}});
  const Eigen::VectorXd y = read_by(beam, m);
  ASSERT_EQ(y.size(), 4);
  EXPECT_NEAR(y[1] / y[3], 0.339523, 2e-3);
  EXPECT_TRUE(std::isnan(y[2]));
}

TEST(ShapeReadings,
     a_phase_common_to_all_channels_is_turned_away_and_a_complex_shape_is_no_reading) {
  const Measured turned = one_mode(
      {.channels = {"h1.z", "h2.z"}, .real = {0.17, 0.5}, .imaginary = {0.294449, 0.866025}});
  const std::vector<Reading> real = components_of(readings_of({.data = turned, .responses = {}}));
  ASSERT_EQ(real.size(), 2U);
  EXPECT_NEAR(real[0].value / real[1].value, 0.34, 1e-5);
  const Measured complex =
      one_mode({.channels = {"h1.z", "h2.z"}, .real = {0.5, 1}, .imaginary = {0.9, 0}});
  const TestReadings none = readings_of({.data = complex, .responses = {}});
  EXPECT_TRUE(components_of(none).empty());
  ASSERT_FALSE(none.warnings.empty());
  EXPECT_NE(none.warnings.back().find("out of phase"), std::string::npos) << none.warnings.back();
  const Measured nameless =
      one_mode({.channels = {"h1", "h2.rz"}, .real = {0.5, 1}, .imaginary = {}});
  const TestReadings neither = readings_of({.data = nameless, .responses = {}});
  EXPECT_TRUE(components_of(neither).empty());
  EXPECT_NE(neither.warnings.back().find("channel h1 is no"), std::string::npos);
}

TEST(ShapeReadings, a_shape_that_the_paired_mode_does_not_look_like_is_left_out) {
  const Case beam = beam_of(4, 1, 0.02, 0.01, true);
  const Measured m = one_mode({.channels = {"h1.z", "h2.z"}, .real = {1, -0.5}, .imaginary = {}});
  TestReadings readings = readings_of({.data = m, .responses = {}});
  leave_out_unlike_shapes(read_by(beam, m), readings);
  EXPECT_TRUE(components_of(readings).empty());
  EXPECT_EQ(readings.readings.size(), 1U);
  EXPECT_NE(readings.warnings.back().find("MAC 0.0"), std::string::npos)
      << readings.warnings.back();
}

// A lab's list of many channels: eight of those along the mode, the same in every state.
TEST(ShapeReadings, of_many_channels_eight_along_the_mode_are_read) {
  Measured m;
  m.specimen = "beam";
  MeasuredVector v;
  for (int k = 0; k < 40; ++k)
    for (const char axis : {'x', 'y', 'z'}) {
      v.channels.push_back("p" + std::to_string(k) + "." + axis);
      v.real.push_back(axis == 'z' ? std::pow(k / 39., 2) : 0.01);
    }
  m.modes.push_back(bending(Axis::z, 1, "", 10));
  m.modes.back().vector = v;
  const TestReadings readings = readings_of({.data = m, .responses = {}});
  ASSERT_EQ(components_of(readings).size(), 8U);
  EXPECT_EQ(readings.shapes[0].axes, std::vector<int>(8, 2));
  EXPECT_EQ(readings.shapes[0].sensors.front(), "p0");
  EXPECT_EQ(readings.shapes[0].sensors.back(), "p39");
  EXPECT_EQ(readings.shapes[0].values.back(), 1);
}

// Frequencies do not tell the halves of a free beam apart (Baseline,
// a_place_that_answers_like_its_mirror_image_is_stated_with_it), shapes do.
TEST(ShapeReadings, a_mass_on_a_free_beam_is_told_from_its_mirror_image) {
  const Case nominal = beam_of(4, 0.6, 0.025, 0.012, false);
  const Case heavier = with_third_point(nominal, 0.22, 0.1);
  Measured m = before_and_after(nominal, heavier);
  add_stations(m, {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
  add_shapes(m, nominal, "before");
  add_shapes(m, heavier, "after");
  const Diagnosis d = diagnosis_of(nominal, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  ASSERT_EQ(d.effects.front().name, "added_mass") << d.headline;
  ASSERT_EQ(d.effects.front().place, "beam") << d.headline;
  const std::array<double, 2> at = d.effects.front().parameters.back().interval;
  EXPECT_LT(at[0], 0.22) << d.headline;
  EXPECT_GT(at[1], 0.22) << d.headline;
  EXPECT_LT(at[1], 0.3) << d.headline;
}

} // namespace
} // namespace plica
