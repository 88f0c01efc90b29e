#include "lab/identification/identified_measured.hpp"

#include "lab/measured/entries.hpp"
#include "lab/measured/entry_lists.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plica {
namespace {

using Eigen::Index;

// Axis of the part frame, 0..2, along which "mid.y" measures; -1 = none.
int part_axis(const std::string& channel, const std::vector<MeasuredSensor>& sensors) {
  if (!is_translation(channel)) return -1;
  const int own = axis_of_channel(channel);
  for (const MeasuredSensor& s : sensors)
    if (s.name == sensor_of_channel(channel) && s.axes.size() == 3)
      return axis_of_signed(s.axes[std::size_t(own)]);
  return own;
}

// How the mode was driven, where one thing drove it.
void add_drive(const FrfSet& set, const Measured& test, MeasuredMode& mode) {
  if (set.references.size() != 1) return;
  const std::string& reference = set.references[0];
  if (set.quantity == FrfQuantity::transmissibility && reference.starts_with("base.") &&
      reference.size() == 6) {
    mode.base = static_cast<Axis>(axis_of_channel(reference));
    mode.level = set.level;
    return;
  }
  const std::string_view sensor = sensor_of_channel(reference);
  if (!set.level || set.quantity == FrfQuantity::transmissibility ||
      std::none_of(test.sensors.begin(), test.sensors.end(),
                   [&](const MeasuredSensor& s) { return s.name == sensor; }))
    return;
  mode.drive = reference;
  mode.force = set.level;
}

MeasuredMode entry_of(const IdentifiedRun& run, const IdentifiedMode& m, const Measured& test) {
  const FrfSet& set = run.found.set;
  MeasuredMode mode;
  mode.frequency = m.frequency;
  mode.damping = m.damping;
  if (m.sigma_frequency > 0) mode.sigma = m.sigma_frequency;
  if (m.sigma_damping > 0) mode.sigma_damping = m.sigma_damping;
  const KindOfShape kind = kind_of(m.shape, set.responses, test.sensors);
  mode.shape = kind.shape;
  mode.direction = kind.direction;
  mode.state = run.state;
  mode.note = run.title + (m.mass_normalised ? "; mass-normalised shape, 1/sqrt(kg)" : "");
  if (run.found.source == IdentifiedFrom::responses) add_drive(set, test, mode);
  if (set.responses.size() < 2) return mode;
  MeasuredVector& vector = mode.vector.emplace();
  vector.channels = set.responses;
  for (const std::complex<double>& x : m.shape) {
    vector.real.push_back(x.real());
    vector.imaginary.push_back(x.imag());
  }
  return mode;
}

} // namespace

KindOfShape kind_of(const Eigen::VectorXcd& shape, const std::vector<std::string>& channels,
                    const std::vector<MeasuredSensor>& sensors) {
  std::array<double, 3> square{};
  double all = 0;
  for (Index c = 0; c < shape.size(); ++c) {
    all += std::norm(shape[c]);
    const int axis = part_axis(channels[std::size_t(c)], sensors);
    if (axis >= 0) square[std::size_t(axis)] += std::norm(shape[c]);
  }
  for (const int axis : {0, 1, 2})
    if (square[std::size_t(axis)] >= 0.8 * all && all > 0)
      return {.shape = axis == 1 ? MeasuredShape::axial : MeasuredShape::transverse,
              .direction = static_cast<Axis>(axis)};
  return {};
}

Measured identified_measured(const Measured& test, const std::vector<IdentifiedRun>& runs) {
  Measured result = test;
  result.frf.clear();
  result.signals.clear();
  result.modes.clear();
  std::set<std::string> identified;
  for (const IdentifiedRun& run : runs)
    if (!run.found.modes.empty()) identified.insert(run.state);
  std::map<std::string, std::string> renamed;
  for (std::size_t i = 0; i < test.modes.size(); ++i) {
    if (identified.contains(test.modes[i].state)) continue;
    renamed[entry_name("modes", i)] = entry_name("modes", result.modes.size());
    result.modes.push_back(test.modes[i]);
    result.modes.back().repeats.clear(); // their scatter is the sigma
  }
  for (const IdentifiedRun& run : runs) {
    std::map<std::pair<MeasuredShape, int>, int> so_far;
    for (const IdentifiedMode& m : run.found.modes) {
      MeasuredMode mode = entry_of(run, m, test);
      mode.order = ++so_far[{mode.shape, mode.direction ? int(*mode.direction) : -1}];
      result.modes.push_back(std::move(mode));
    }
  }
  // In the responses of others nothing was found.
  std::erase_if(result.states, [used = states_in_use(result)](const MeasuredState& s) {
    return !used.contains(s.name);
  });
  const auto stays = [&](const char* list, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) renamed[entry_name(list, i)] = entry_name(list, i);
  };
  renamed["mass"] = "mass";
  stays("mass", test.weighings.size());
  stays("static", test.statics.size());
  stays("stiffness", test.stiffness.size());
  stays("peaks", test.peaks.size());
  result.hold_out = renamed_paths(test.hold_out, renamed);
  result.caveats.emplace_back(
      "kinds and orders of the identified modes follow from the axes of the channels: torsion and "
      "shell modes, and modes that were not found, need a correction by hand");
  return result;
}

} // namespace plica
