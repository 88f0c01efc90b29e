// How large each effect is at weak, medium, strong, and where it can be.
#include "specimen.hpp"

#include <fmt/format.h>
#include <numbers>

namespace sealed {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Graded {
  const char* key;
  std::array<double, 3> values;
};

Effect at(const std::string& name, const std::string& place, int strength,
          const std::vector<Graded>& parameters) {
  Effect e{name, place, {}};
  for (const Graded& p : parameters) e.value[p.key] = p.values[std::size_t(strength)];
  return e;
}

std::string pick(const std::vector<std::string>& places, int variant) {
  return places[std::size_t(variant) % places.size()];
}

std::vector<Effect> everywhere(const std::string& name, int strength, int variant) {
  if (name == "damping")
    return {at(name, "all", strength,
               variant % 3 == 2 ? std::vector<Graded>{{"ratio", {0.67, 0.5, 0.33}}}
                                : std::vector<Graded>{{"ratio", {1.5, 2, 3}}})};
  if (name == "temperature") return {at(name, "all", strength, {{"delta_T", {40, 90, 180}}})};
  return {};
}

std::vector<Effect> on_bellows(const std::string& name, int g, int variant) {
  const std::string end = pick({"mount.left", "mount.right"}, variant);
  const std::string sensor = pick({"sensor.mid", "sensor.quarter"}, variant);
  const int k = 2 + (3 * variant + g) % 6;
  const std::string convolution = fmt::format("bellows.convolution[{}]", k);
  if (name == "ply_slip") return {at(name, "bellows", g, {{"bond", {0.36, 0.2, 0}}})};
  if (name == "forming_thinning") return {at(name, "bellows", g, {{"exponent", {0.4, 0.8, 1.3}}})};
  if (name == "local_damage")
    return {at(name, convolution, g,
               {{"loss", {0.4, 0.65, 0.9}}, {"angle", {20 * degree, 75 * degree, 170 * degree}}})};
  if (name == "joint_friction")
    return {at(name, "interlock", g, {{"slip_ratio", {4, 1.5, 0.5}}, {"share", {0.6, 0.6, 0.6}}})};
  if (name == "joint_stiffness")
    return {at(name, "interlock", g,
               variant % 3 == 1 ? std::vector<Graded>{{"ratio", {1.25, 1.6, 2.2}}}
                                : std::vector<Graded>{{"ratio", {0.8, 0.5, 0.2}}})};
  if (name == "fixture_flexibility")
    return {at(name, end, g, {{"mass", {4, 4, 4}}, {"frequency", {2500, 1500, 1000}}})};
  if (name == "boundary_compliance")
    return {at(name, end, g,
               {{"k_translation", {1.5e8, 4e7, 1.2e7}}, {"k_rotation", {2.5e5, 7e4, 2.5e4}}})};
  if (name == "extra_support") return {at(name, convolution, g, {{"k", {1.5e5, 4e5, 1.2e6}}})};
  if (name == "added_mass")
    return {at(name, variant % 2 ? convolution : sensor, g, {{"mass", {0.003, 0.008, 0.02}}})};
  if (name == "component_mass")
    return {at(name, pick({"interlock", "caps.left"}, variant), g, {{"ratio", {1.06, 1.2, 1.5}}})};
  if (name == "cross_axis_base_motion")
    return {at(name, "base", g, {{"fraction", {0.04, 0.08, 0.16}}})};
  if (name == "rotated_sensor")
    return {at(name, sensor, g, {{"angle", {4 * degree, 10 * degree, 25 * degree}}})};
  if (name == "sensor_gain")
    return {at(name, sensor, g,
               variant % 3 == 1 ? std::vector<Graded>{{"gain", {0.95, 0.88, 0.75}}}
                                : std::vector<Graded>{{"gain", {1.05, 1.12, 1.3}}})};
  if (name == "unweighed_mass") return {at(name, "bellows", g, {{"ratio", {0.06, 0.15, 0.35}}})};
  return everywhere(name, g, variant);
}

std::vector<Effect> on_cantilever(const std::string& name, int g, int variant) {
  const int k = 1 + (variant + g) % 4;
  if (name == "added_mass")
    return {at(name, fmt::format("beam.point[{}]", 2 + (variant + g) % 3), g,
               {{"mass", {0.015, 0.04, 0.1}}})};
  if (name == "component_mass")
    return {at(name, fmt::format("m{}", k), g, {{"ratio", {0.8, 0.5, 0}}})};
  if (name == "boundary_compliance")
    return {at(name, "mount.root", g,
               {{"k_translation", {1e8, 3e7, 1e7}}, {"k_rotation", {1e5, 3e4, 1e4}}})};
  if (name == "fixture_flexibility")
    return {at(name, "mount.root", g, {{"mass", {20, 20, 20}}, {"frequency", {500, 330, 220}}})};
  if (name == "extra_support")
    return {at(name, fmt::format("beam.point[{}]", 3 + (variant + g) % 3), g,
               {{"k", {600, 2e3, 8e3}}})};
  return everywhere(name, g, variant);
}

std::vector<Effect> on_lap(const std::string& name, int g, int variant) {
  if (name == "joint_friction")
    return {at(name, "caps.lap", g, {{"slip_ratio", {4, 1.5, 0.5}}, {"share", {0.7, 0.7, 0.7}}})};
  if (name == "joint_stiffness") return {at(name, "caps.lap", g, {{"ratio", {0.6, 0.35, 0.15}}})};
  if (name == "cross_axis_base_motion")
    return {at(name, "base", g, {{"fraction", {0.04, 0.08, 0.16}}})};
  if (name == "rotated_sensor") return {};
  if (name == "sensor_gain") return {at(name, "sensor.joint", g, {{"gain", {1.05, 1.12, 1.3}}})};
  if (name == "boundary_compliance")
    return {at(name, "mount.left", g,
               {{"k_translation", {1e8, 3e7, 1e7}}, {"k_rotation", {1e5, 3e4, 1e4}}})};
  return everywhere(name, g, variant);
}

} // namespace

const std::vector<std::string>& effect_names() {
  static const std::vector<std::string> names{"ply_slip",
                                              "joint_friction",
                                              "joint_stiffness",
                                              "fixture_flexibility",
                                              "boundary_compliance",
                                              "extra_support",
                                              "added_mass",
                                              "component_mass",
                                              "local_damage",
                                              "forming_thinning",
                                              "damping",
                                              "cross_axis_base_motion",
                                              "temperature",
                                              "rotated_sensor",
                                              "sensor_gain",
                                              "unweighed_mass"};
  return names;
}

std::vector<Effect> graded(const std::string& structure, const std::string& name, int strength,
                           int variant) {
  if (structure == "short_bellows") return on_bellows(name, strength, variant);
  if (structure == "cantilever_masses") return on_cantilever(name, strength, variant);
  return on_lap(name, strength, variant);
}

Effect stranger(const std::string& structure, const std::string& cls, int variant) {
  const int g = variant % 3;
  const bool bellows = structure == "short_bellows", lap = structure == "bolted_lap";
  const std::string spot = bellows ? fmt::format("bellows.convolution[{}]", 3 + variant % 4)
                           : lap   ? "sensor.joint"
                                   : "beam.point[4]";
  const std::string sensor = bellows ? pick({"sensor.mid", "sensor.quarter"}, variant)
                             : lap   ? "sensor.joint"
                                     : "sensor.tip";
  const double stiff = bellows ? 2e6 : lap ? 2e5 : 5e3;
  if (cls == "clearance")
    return at(cls, spot, g,
              {{"stiffness", {stiff, stiff, 2 * stiff}}, {"slip_ratio", {1, 0.6, 0.4}}});
  if (cls == "hardening")
    return at(
        cls, spot, g,
        {{"stiffness", {0.02 * stiff, 0.05 * stiff, 0.1 * stiff}}, {"slip_ratio", {1, 1, 1}}});
  if (cls == "absorber")
    return bellows
               ? at(cls, spot, g, {{"mass", {0.006, 0.01, 0.015}}, {"frequency", {760, 1450, 800}}})
               : at(cls, spot, g, {{"mass", {0.05, 0.08, 0.12}}, {"frequency", {30, 150, 25}}});
  if (cls == "sloshing")
    return at(cls, "middle", g, {{"mass", {0.01, 0.02, 0.03}}, {"frequency", {1200, 900, 2200}}});
  if (cls == "coupling_spring") return at(cls, "bellows", g, {{"k", {3e5, 8e5, 2e6}}});
  if (cls == "eccentric_mass")
    return at(cls, "extra", g, {{"mass", {0.01, 0.02, 0.03}}, {"offset", {0.03, 0.03, 0.03}}});
  if (cls == "rocking_table") return at(cls, "base", g, {{"per_metre", {1, 2, 4}}});
  if (cls == "time_delay") return at(cls, sensor, g, {{"delay", {2e-5, 4e-5, 8e-5}}});
  if (cls == "sensor_resonance") return at(cls, sensor, g, {{"frequency", {5000, 3500, 2500}}});
  if (cls == "rubber") return at(cls, "extra", g, {{"k", {2e5, 5e5, 1e6}}});
  throw std::runtime_error("no stranger " + cls);
}

const Effect* find(const Specimen& s, const std::string& name) {
  for (const Effect& e : s.effects)
    if (e.name == name) return &e;
  return nullptr;
}

double value_of(const Specimen& s, const std::string& name, const std::string& place,
                const std::string& key, double otherwise) {
  for (const Effect& e : s.effects)
    if (e.name == name && e.place == place) return e.value.at(key);
  return otherwise;
}

} // namespace sealed
