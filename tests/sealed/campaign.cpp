#include "campaign.hpp"

#include <fmt/format.h>

namespace sealed {
namespace {

VectorXd every(double from, double step, double to) {
  return VectorXd::LinSpaced(Eigen::Index(std::lround((to - from) / step)) + 1, from, to);
}

} // namespace

Campaign campaign_of(const Specimen& s) {
  Campaign c;
  const auto held_out = [&](int level) { return level == (s.level_out < 0 ? 3 : s.level_out); };
  if (s.structure == "short_bellows") {
    c.lines = every(400, 4, 1800);
    const std::array levels{1., 5., 20., 40.};
    for (const int base : {1, 0})
      for (int k = 0; k < 3; ++k) c.runs.push_back({base, levels[std::size_t(k)], "", held_out(k)});
    for (const int base : {1, 0}) c.runs.push_back({base, levels[3], "", held_out(3)});
    for (const int base : {1, 0}) c.runs.push_back({base, 5, "loaded", true});
    c.states["loaded"] = {{"parts.extra.mass", 0.08}};
  } else if (s.structure == "bolted_lap") {
    c.lines = every(60, 0.75, 759);
    const std::array levels{1., 3., 10., 30.};
    for (int k = 0; k < 4; ++k) c.runs.push_back({2, levels[std::size_t(k)], "", held_out(k)});
  } else if (s.campaign == "sets") { // 36 frequencies and dampings
    for (const char* off : {"m1", "m2", "m3", "m4"})
      c.states[std::string("without_") + off] = {{fmt::format("parts.{}.mass", off), 0}};
    c.states["without_m1_m3"] = {{"parts.m1.mass", 0}, {"parts.m3.mass", 0}};
    c.orders = 3;
    c.only_across = true;
  } else {
    c.states["without_m2"] = {{"parts.m2.mass", 0}};
    c.states["without_m4"] = {{"parts.m4.mass", 0}};
  }
  return c;
}

std::vector<PlacedSensor> placed_sensors(const Specimen& s) {
  std::vector<PlacedSensor> all;
  if (s.structure == "short_bellows") {
    all = {{"mid", "0, 25 mm, 46 mm", 0.002}, {"quarter", "46 mm, 13 mm, 0", 0.002}};
    if (s.mounted)
      all.insert(all.end(), {{"slant", "32.527 mm, 13 mm, 32.527 mm", 0.002},
                             {"foot", "0, 0, 40 mm", 0.002},
                             {"head", "0, 56 mm, 40 mm", 0.002}});
  } else if (s.structure == "bolted_lap") {
    all = {{"joint", "0, 250 mm, 0", 0.005}};
    if (s.mounted)
      all.insert(all.end(), {{"foot", "0, 0, 0", 0.005}, {"head", "0, 500 mm, 0", 0.005}});
  } else {
    all = {{"tip", "0, 600 mm, 0", 0.005}};
  }
  return all;
}

std::string sensors_of(const Specimen& s) {
  std::string text = "sensors:\n";
  for (const PlacedSensor& sensor : placed_sensors(s))
    text += fmt::format("  - {{name: {}, at: [{}], axes: [x, y, z], mass: {:g} g}}\n", sensor.name,
                        sensor.at, 1000 * sensor.mass);
  return text;
}

std::string states_of(const Campaign& c) {
  if (c.states.empty()) return "";
  std::string text = "states:\n";
  for (const auto& [name, set] : c.states) {
    text += fmt::format("  - {{name: {}, set: {{", name);
    for (const auto& [path, value] : set)
      text += fmt::format("{}{}: {} kg", text.ends_with('{') ? "" : ", ", path, value);
    text += "}}\n";
  }
  return text;
}

} // namespace sealed
