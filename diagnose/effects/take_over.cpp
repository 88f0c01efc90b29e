#include "diagnose/effects/take_over.hpp"

#include "model/description/place_keys.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plica {
namespace {

template <class List, class Match> const auto* first_of(const List& list, const Match& match) {
  const auto found = std::find_if(list.begin(), list.end(), match);
  return found == list.end() ? nullptr : &*found;
}

CaseEdits with_section(const std::string& part, const BeamSection& section, double E, double rho) {
  const std::string path = part_key(part) + ".section.";
  CaseEdits edits;
  for (const auto& [key, value] : {std::pair{"EA", section.EA}, std::pair{"EI", section.EI},
                                   std::pair{"GJ", section.GJ}, std::pair{"GA", section.GA}})
    scale(edits, path + key, value.value_or(0), E);
  scale(edits, path + "mass_per_length", section.mass_per_length, rho);
  scale(edits, path + "rotary_inertia_per_length", section.rotary_inertia_per_length, rho);
  scale(edits, path + "polar_inertia_per_length", section.polar_inertia_per_length, rho);
  return edits;
}

std::string entry_of(const Sensor& s) {
  std::vector<std::string> axes;
  for (int axis : s.axes) axes.push_back(signed_axis_word(axis));
  std::string text = fmt::format("{{name: {}, at: [{}], axes: [{}]", s.name, fmt::join(s.at, ", "),
                                 fmt::join(axes, ", "));
  if (s.mass > 0) text += ", mass: " + yaml_of(s.mass);
  return text + "}";
}

} // namespace

const Part* part_named(const Case& data, const std::string& name) {
  return first_of(data.parts, [&](const Part& p) { return p.name == name; });
}
const Cap* cap_named(const Case& data, const std::string& name) {
  return first_of(data.caps, [&](const Cap& c) { return c.name == name; });
}
std::vector<Mount> mounts_at(const Case& data, const std::string& place) {
  std::vector<Mount> found;
  for (const Mount& m : data.mount)
    if (m.kind != MountKind::free && (place == all_mounts || place == mount_key(m.cap)))
      found.push_back(m);
  return found;
}

std::string yaml_of(double value) {
  return fmt::format("{}", value);
}
std::string yaml_of(const Sextuple& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}
std::string yaml_of(const Triple& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

void scale(CaseEdits& edits, const std::string& path, double value, double factor) {
  if (value != 0 && factor != 1) edits.push_back({path, yaml_of(value * factor)});
}

CaseEdits with_own_material(const Case& data, const std::string& part, double E, double rho) {
  const Part* found = part_named(data, part);
  if (!found) return {};
  std::string path = part_key(part) + ".material", name;
  if (const auto* bellows = std::get_if<Bellows>(&found->body)) name = bellows->material;
  if (const auto* plate = std::get_if<Plate>(&found->body)) name = plate->material;
  if (const auto* surface = std::get_if<SurfacePart>(&found->body)) name = surface->material;
  if (const auto* beam = std::get_if<BeamPart>(&found->body)) {
    if (beam->section.shape == BeamShape::general) return with_section(part, beam->section, E, rho);
    name = beam->section.material;
    path = part_key(part) + ".section.material";
  }
  const auto material = data.materials.find(name);
  if (material == data.materials.end()) return {};
  const Material& m = material->second;
  const std::string tail = "_of_" + part, own = name.ends_with(tail) ? name : name + tail;
  return {
      {"materials." + own, fmt::format("{{E: {}, nu: {}, rho: {}}}", E * m.E, m.nu, rho * m.rho)},
      {path, own}};
}

CaseEdits with_damping(const Case& data, double factor) {
  const Damping& damping = data.analyses.damping;
  const std::string path = "analyses.damping.";
  CaseEdits edits;
  scale(edits, path + "modal", damping.modal, factor);
  const auto each = [&](const char* list, const char* key, const auto& entries, auto number) {
    for (std::size_t i = 0; i < entries.size(); ++i)
      scale(edits, fmt::format("{}{}[{}].{}", path, list, i, key), entries[i].*number, factor);
  };
  each("ranges", "ratio", damping.ranges, &DampingRange::ratio);
  each("modes", "ratio", damping.modes, &ModeDamping::ratio);
  each("loss_factors", "value", damping.loss_factors, &LossFactor::value);
  const auto spring = [&](const std::string& at, const std::optional<SpringDamping>& own) {
    if (!own) return;
    scale(edits, at + ".damping.loss_factor", own->loss_factor, factor);
    for (std::size_t i = 0; own->dashpot && i < own->dashpot->size(); ++i)
      scale(edits, fmt::format("{}.damping.dashpot[{}]", at, i), (*own->dashpot)[i], factor);
  };
  for (const Cap& cap : data.caps) {
    spring(cap_key(cap.name), cap.damping);
    for (std::size_t i = 0; i < cap.ends.size(); ++i)
      spring(fmt::format("{}.ends[{}]", cap_key(cap.name), i), cap.ends[i].damping);
  }
  for (const Mount& mount : data.mount) spring(mount_key(mount.cap), mount.damping);
  return edits;
}

CaseEdits with_mass_at(const Case& data, const Triple& at, double mass) {
  constexpr double same = 1e-6; // m
  std::vector<std::string> all;
  std::vector<Sensor> sensors = data.sensors;
  const auto there = std::find_if(sensors.begin(), sensors.end(), [&](const Sensor& s) {
    return std::hypot(s.at[0] - at[0], s.at[1] - at[1], s.at[2] - at[2]) < same;
  });
  if (there != sensors.end())
    return {
        {fmt::format("sensors[{}].mass", there - sensors.begin()), yaml_of(there->mass + mass)}};
  const auto taken = [&](const std::string& name) {
    return std::any_of(sensors.begin(), sensors.end(),
                       [&](const Sensor& s) { return s.name == name; });
  };
  std::string name = "added_mass";
  for (int k = 2; taken(name); ++k) name = fmt::format("added_mass_{}", k);
  sensors.push_back({.name = name, .at = at, .mass = mass});
  for (const Sensor& s : sensors) all.push_back(entry_of(s));
  return {{"sensors", fmt::format("[{}]", fmt::join(all, ", "))}};
}

} // namespace plica
