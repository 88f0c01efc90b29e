// A mass where several sensors sit.
#include "diagnose/effects/effect.hpp"
#include "tests/steel_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace plica {
namespace {

using Eigen::VectorXd;

// A clamped plate with two sensors of 4 and 6 g at one corner.
Case plate_with_two_sensors() {
  Case c = steel_plate({{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}, {0, 0.2, 0}}}, {8, 8});
  c.caps.push_back({.name = "clamp", .of = {"plate.edge4"}});
  c.mount.push_back({.cap = "clamp"});
  c.sensors.push_back({.name = "corner", .at = {0.3, 0, 0}, .mass = 4e-3});
  c.sensors.push_back({.name = "beside", .at = {0.3, 0, 0}, .mass = 6e-3});
  c.diagnose.places = {"plate.spot", "sensor."}; // else anywhere on it
  return c;
}

// Whichever of them is heavier than the case says: it is the same mass on the same node, and the
// case says it of the sensor that is named.
TEST(SensorsTogether, a_mass_is_told_of_each) {
  const Case c = plate_with_two_sensors();
  const BuiltCase built = build(c);
  const Measured m;
  const Structure s{.data = c, .built = built, .measured = m, .stiffness = 1e4, .mass = 1};
  ASSERT_EQ(built.sensors.size(), 2U);
  const int node = built.sensors[0].node;
  ASSERT_EQ(built.sensors[1].node, node);
  const std::vector<Hypothesis> all = effect_named("added_mass").hypotheses(s);
  const auto at = [&](const std::string& place) {
    return std::find_if(all.begin(), all.end(),
                        [&](const Hypothesis& h) { return h.place == place; });
  };
  EXPECT_EQ(at("plate.spot[100][0]"), all.end()) << "it is told of the sensors";
  for (std::size_t k = 0; k < c.sensors.size(); ++k) {
    const auto h = at("sensor." + c.sensors[k].name);
    ASSERT_NE(h, all.end()) << c.sensors[k].name;
    Model model = built.model;
    h->changes.front().apply(model);
    ASSERT_EQ(model.masses.size(), built.model.masses.size() + 1);
    EXPECT_EQ(model.masses.back().node, node);
    EXPECT_EQ(model.masses.back().body.mass, 1);
    constexpr double added = 0.02;
    const CaseEdits edits = h->in_case(c, VectorXd::Constant(1, added));
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0].path, "sensors[" + std::to_string(k) + "].mass");
    EXPECT_NEAR(std::stod(edits[0].value), c.sensors[k].mass + added, 1e-12);
  }
}

} // namespace
} // namespace plica
