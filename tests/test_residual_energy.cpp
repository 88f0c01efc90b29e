// Minimum dynamic residual expansion: the component whose stiffness is off stands out.
#include "diagnose/account/residual_energy.hpp"
#include "io/input/case_file.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace plica {
namespace {

using Eigen::VectorXd;

constexpr int sensors = 10;

// Two beams and a lap, with five accelerometers without mass along each beam.
Case beams() {
  const auto file = std::filesystem::path(PLICA_SOURCE_DIR) / "cases/bolted_lap/bolted_lap.yaml";
  Case data = read_case(file.string(), "").data;
  data.sensors.clear();
  for (int i = 0; i < sensors; ++i) {
    Sensor s;
    s.name = "s" + std::to_string(i);
    const int node = 2 * (i % 5 + 1); // of twelve stretches of a beam
    s.at = {0, (i < 5 ? 0 : 0.25) + 0.25 * node / 12, 0};
    data.sensors.push_back(s);
  }
  return data;
}

// Its two lowest modes in z as a modal test over all sensors gives them.
Measured modal_test(const Case& specimen) {
  Measured m;
  m.specimen = specimen.name;
  m.weighings = {{.value = 1, .sigma = {}, .repeats = {}}};
  const Nominal model = nominal_of(specimen, m);
  const TestReadings test = readings_of({.data = m, .responses = {}});
  const AffineModes modes = *Predictor(model, test, {}).modes(VectorXd());
  for (Eigen::Index i = 0; i < modes.lambda.size() && m.modes.size() < 2; ++i) {
    MeasuredVector shape;
    for (int s = 0; s < sensors; ++s) {
      shape.channels.push_back("s" + std::to_string(s) + ".z");
      shape.real.push_back(modes.marked(6 * s + 2, i));
    }
    const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const double z = std::abs(*std::max_element(shape.real.begin(), shape.real.end(), size));
    double x = 0;
    for (int s = 0; s < sensors; ++s) x = std::max(x, std::abs(modes.marked(6 * s, i)));
    if (x > z) continue;
    MeasuredMode mode;
    mode.shape = MeasuredShape::transverse;
    mode.direction = Axis::z;
    mode.order = int(m.modes.size()) + 1;
    mode.frequency = modes.hertz(i);
    mode.vector = shape;
    m.modes.push_back(mode);
  }
  return m;
}

std::vector<LocatedGap> located(const Case& specimen, const Case& data) {
  const Measured m = modal_test(specimen);
  return residual_energy(nominal_of(data, m), readings_of({.data = m, .responses = {}}), m);
}

TEST(ResidualEnergy, is_where_the_stiffness_is_off) {
  const Case data = beams();
  for (const char* soft : {"beam1", "beam2"}) {
    Case specimen = data;
    specimen.materials["soft"] = specimen.materials.at("steel");
    specimen.materials["soft"].E *= 0.7;
    for (Part& part : specimen.parts)
      if (part.name == soft) std::get<BeamPart>(part.body).section.material = "soft";
    const auto gaps = located(specimen, data);
    ASSERT_FALSE(gaps.empty());
    const auto most =
        std::max_element(gaps.begin(), gaps.end(),
                         [](const LocatedGap& a, const LocatedGap& b) { return a.z < b.z; });
    std::string all;
    for (const LocatedGap& g : gaps)
      all += g.component + ", " + g.band + ": " + std::to_string(g.z) + "\n";
    EXPECT_EQ(most->component, soft) << all;
    EXPECT_TRUE(most->significant) << most->z;
  }
}

TEST(ResidualEnergy, is_nowhere_unusual_where_nothing_is_off) {
  const Case data = beams();
  const auto gaps = located(data, data);
  ASSERT_FALSE(gaps.empty());
  for (const LocatedGap& g : gaps)
    EXPECT_FALSE(g.significant) << g.component << " " << g.band << " z " << g.z;
}

TEST(ResidualEnergy, needs_enough_channels) {
  const Case data = beams();
  Measured m = modal_test(data);
  for (MeasuredMode& mode : m.modes) {
    mode.vector->channels.resize(fewest_channels - 1);
    mode.vector->real.resize(fewest_channels - 1);
  }
  EXPECT_TRUE(
      residual_energy(nominal_of(data, m), readings_of({.data = m, .responses = {}}), m).empty());
}

} // namespace
} // namespace plica
