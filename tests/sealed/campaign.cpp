#include "campaign.hpp"

#include <fmt/format.h>

namespace sealed {
namespace {

VectorXd every(double from, double step, double to) {
  return VectorXd::LinSpaced(Eigen::Index(std::lround((to - from) / step)) + 1, from, to);
}

} // namespace

Campaign campaign_of(const std::string& structure, const std::string& name) {
  Campaign c;
  if (structure == "short_bellows") {
    c.lines = every(400, 4, 1800);
    for (const int base : {1, 0})
      for (const double level : {1., 5., 20.}) c.runs.push_back({base, level, "", false});
    for (const int base : {1, 0}) c.runs.push_back({base, 40, "", true});
    for (const int base : {1, 0}) c.runs.push_back({base, 5, "loaded", true});
    c.states["loaded"] = {{"parts.extra.mass", 0.08}};
  } else if (structure == "bolted_lap") {
    c.lines = every(60, 0.75, 759);
    for (const double level : {1., 3., 10., 30.}) c.runs.push_back({2, level, "", level > 20});
  } else if (name == "sets") { // 36 frequencies and dampings
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

std::string sensors_of(const std::string& structure) {
  if (structure == "short_bellows")
    return "sensors:\n"
           "  - {name: mid, at: [0, 25 mm, 46 mm], axes: [x, y, z], mass: 2 g}\n"
           "  - {name: quarter, at: [46 mm, 13 mm, 0], axes: [x, y, z], mass: 2 g}\n";
  if (structure == "bolted_lap")
    return "sensors: [{name: joint, at: [0, 250 mm, 0], axes: [x, y, z], mass: 5 g}]\n";
  return "sensors: [{name: tip, at: [0, 600 mm, 0], axes: [x, y, z], mass: 5 g}]\n";
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
