#include "compare/simulated.hpp"

#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"
#include "words/mode_kinds.hpp"

#include <cmath>

namespace plica {
namespace {

std::optional<Axis> axis_of(const std::string& letter) {
  const int axis = place_among(axis_names, letter);
  return axis < 0 ? std::nullopt : std::optional(static_cast<Axis>(axis));
}

MeasuredShape shape_of(const std::string& shape) {
  const int known = place_among(measured_shape_names, shape);
  return known < 0 ? MeasuredShape::other : static_cast<MeasuredShape>(known);
}

MeasuredVector at_sensors(const Results& results, std::size_t mode) {
  MeasuredVector v;
  for (const SensorResult& s : results.sensors)
    for (int k = 0; k < 3; ++k) {
      const int axis = s.axes[k];
      v.channels.push_back(s.name + "." + axis_word(k));
      v.real.push_back(sign_of(axis) * results.shapes[mode](s.node, axis_of_signed(axis)));
    }
  return v;
}

} // namespace

Measured as_measured(const Results& results) {
  Measured m;
  m.specimen = results.case_name;
  m.source = results.case_name + " computed by Plica " + results.plica_version;
  for (const SensorResult& s : results.sensors) {
    constexpr double rounding = 1e-12; // m
    const Eigen::Vector3d x =
        (results.mesh.nodes[s.node].array().abs() < rounding).select(0, results.mesh.nodes[s.node]);
    m.sensors.push_back({.name = s.name,
                         .at = {x[0], x[1], x[2]},
                         .axes = {s.axes[0], s.axes[1], s.axes[2]},
                         .mass = 0,
                         .node = static_cast<int>(m.sensors.size()) + 1});
  }
  if (results.model.mass > 0) m.weighings.emplace_back().value = results.model.mass;
  if (results.statics) {
    const std::array values = results.statics->all();
    for (std::size_t d = 0; d < values.size(); ++d) {
      if (!(values[d] > 0)) continue;
      m.statics.emplace_back();
      m.statics.back().direction = static_cast<StaticDirection>(d);
      m.statics.back().value = values[d];
    }
  }
  std::map<std::pair<std::string, std::string>, int> so_far; // of a shape and direction
  for (std::size_t i = 0; i < results.modes.size(); ++i) {
    const ModeResult& mode = results.modes[i];
    if (mode.shape == mode_kind::rigid || !(mode.frequency > 0)) continue;
    MeasuredMode& out = m.modes.emplace_back();
    out.frequency = mode.frequency;
    if (mode.damping > 0) out.damping = mode.damping;
    out.shape = shape_of(mode.shape);
    out.order = ++so_far[{mode.shape, mode.direction}];
    out.direction = axis_of(mode.direction);
    if (!m.sensors.empty()) out.vector = at_sensors(results, i);
  }
  for (const ResponseResult& r : results.responses) {
    const std::optional<Axis> base = axis_of(r.excitation);
    if (r.source != Source::base || !base || r.channels.empty()) continue;
    MeasuredFrf& frf = m.frf.emplace_back();
    frf.file = "response_" + r.excitation + ".csv";
    frf.base = base;
    frf.level = r.level;
  }
  return m;
}

namespace {

FrfSet set_of(const ResponseResult& r, FrfQuantity quantity, const std::string& reference) {
  FrfSet set;
  set.quantity = quantity;
  set.hertz = r.hertz;
  for (const auto& [sensor, axis] : r.channels) set.responses.push_back(sensor + "." + axis);
  set.references = {reference};
  set.H = {r.acceleration};
  set.level = r.level;
  return set;
}

} // namespace

std::vector<FrfSet> responses_to_base(const Results& results) {
  std::vector<FrfSet> sets;
  for (const ResponseResult& r : results.responses)
    if (r.source == Source::base && !r.channels.empty())
      sets.push_back(set_of(r, FrfQuantity::transmissibility, "base." + r.excitation));
  return sets;
}

std::vector<FrfSet> responses_to_forces(const Results& results) {
  std::vector<FrfSet> sets;
  for (const ResponseResult& r : results.responses)
    if (r.source == Source::force && r.unit == "N" && !r.channels.empty())
      sets.push_back(set_of(r, FrfQuantity::accelerance, r.excitation + "." + r.direction));
  return sets;
}

} // namespace plica
