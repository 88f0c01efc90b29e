#include "diagnose/compare.hpp"

#include <algorithm>
#include <array>

namespace plica {
namespace {

struct StaticEntry {
  const char* name;
  const char* unit;
  double value;
};

StaticEntry static_entry(const StaticStiffness& k, StaticDirection direction) {
  switch (direction) {
  case StaticDirection::axial:
    break;
  case StaticDirection::transverse_x:
    return {"transverse stiffness x", "N/m", k.k_transverse_x};
  case StaticDirection::transverse_z:
    return {"transverse stiffness z", "N/m", k.k_transverse_z};
  case StaticDirection::bending_x:
    return {"bending stiffness x", "Nm/rad", k.k_bending_x};
  case StaticDirection::bending_z:
    return {"bending stiffness z", "Nm/rad", k.k_bending_z};
  case StaticDirection::torsion:
    return {"torsional stiffness", "Nm/rad", k.k_torsion};
  }
  return {"axial stiffness", "N/m", k.k_axial};
}

const char* shape_name(MeasuredShape shape) {
  constexpr std::array names{"axial", "transverse", "torsion", "shell", "other"};
  return names[static_cast<std::size_t>(shape)];
}

} // namespace

std::vector<MeasuredComparison> compare(const Results& results, const Measured& measured) {
  std::vector<MeasuredComparison> rows;
  if (measured.mass)
    rows.push_back({.quantity = "mass",
                    .unit = "kg",
                    .measured = measured.mass->value,
                    .sigma = measured.mass->sigma.value_or(0),
                    .computed = results.model.mass});
  for (const MeasuredStatic& k : measured.statics) {
    if (!results.statics) break;
    const StaticEntry entry = static_entry(*results.statics, k.direction);
    rows.push_back({.quantity = entry.name,
                    .unit = entry.unit,
                    .measured = k.value,
                    .sigma = k.sigma.value_or(0),
                    .computed = entry.value});
  }
  for (const MeasuredMode& m : measured.modes) {
    const std::string direction =
        m.direction ? std::string(1, "xyz"[static_cast<std::size_t>(*m.direction)]) : "";
    const auto found =
        std::find_if(results.modes.begin(), results.modes.end(), [&](const ModeResult& mode) {
          return mode.shape == shape_name(m.shape) &&
                 (direction.empty() || mode.direction == direction);
        });
    if (found == results.modes.end()) continue;
    rows.push_back({.quantity = std::string(shape_name(m.shape)) + " mode 1",
                    .unit = "Hz",
                    .measured = m.frequency,
                    .sigma = m.sigma.value_or(0),
                    .computed = found->frequency});
  }
  return rows;
}

} // namespace plica
