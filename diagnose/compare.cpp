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

char letter(Axis axis) {
  return "xyz"[static_cast<std::size_t>(axis)];
}

// Response to motion of the base along an axis; null when there is none.
const ResponseResult* response_to(const Results& results, Axis base) {
  for (const ResponseResult& r : results.responses)
    if (!r.is_force && r.excitation == std::string(1, letter(base))) return &r;
  return nullptr;
}

// Largest peak of the channels in a direction; null when none of them has one.
const ResponsePeak* largest_peak(const ResponseResult& r, Axis direction) {
  const ResponsePeak* largest = nullptr;
  for (const ResponsePeak& p : r.peaks)
    if (r.channels[p.channel].second == std::string(1, letter(direction)) &&
        (!largest || p.amplitude > largest->amplitude))
      largest = &p;
  return largest;
}

void add_peak(std::vector<MeasuredComparison>& rows, const MeasuredMode& m,
              const ResponsePeak& peak) {
  const std::string of = std::string(" of the peak, base ") + letter(*m.base);
  rows.push_back({.quantity = "frequency" + of,
                  .unit = "Hz",
                  .measured = m.frequency,
                  .sigma = m.sigma.value_or(0),
                  .computed = peak.frequency});
  if (m.damping)
    rows.push_back({.quantity = "half-power damping" + of,
                    .unit = "%",
                    .measured = 100 * *m.damping,
                    .sigma = 100 * m.sigma_damping.value_or(0),
                    .computed = 100 * peak.damping});
}

} // namespace

std::vector<std::string> unanswered(const Results& results, const Measured& measured) {
  std::vector<std::string> remarks;
  for (const MeasuredMode& m : measured.modes) {
    if (!m.base || !m.direction) continue;
    const ResponseResult* response = response_to(results, *m.base);
    if (!response || largest_peak(*response, *m.direction)) continue;
    double cross = 0, largest = 0;
    for (std::size_t c = 0; c < response->channels.size(); ++c) {
      const double high = response->acceleration.col(Eigen::Index(c)).cwiseAbs().maxCoeff();
      largest = std::max(largest, high);
      if (response->channels[c].second == std::string(1, letter(*m.direction)))
        cross = std::max(cross, high);
    }
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(),
                  "the test saw %.0f Hz in %c while the base moved in %c; the model answers in %c "
                  "with %.1g of its largest channel. A body of revolution on a rigid mount has no "
                  "path from one to the other: only what breaks the symmetry (a dent, a sensor's "
                  "mass, a flexible fixture, a base that also moves in %c) can make one.",
                  m.frequency, letter(*m.direction), letter(*m.base), letter(*m.direction),
                  largest > 0 ? cross / largest : 0, letter(*m.direction));
    remarks.emplace_back(text.data());
  }
  return remarks;
}

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
    const std::string direction = m.direction ? std::string(1, letter(*m.direction)) : "";
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
  for (const MeasuredMode& m : measured.modes) {
    const ResponseResult* response = m.base ? response_to(results, *m.base) : nullptr;
    if (!response) continue;
    if (const ResponsePeak* peak = largest_peak(*response, m.direction.value_or(*m.base)))
      add_peak(rows, m, *peak);
  }
  return rows;
}

} // namespace plica
