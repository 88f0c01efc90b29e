#include "model/description/case.hpp"

#include "model/description/deck_model.hpp"
#include "words/did_you_mean.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace plica {

Case in_state(const Case& data, const std::string& name) {
  const auto found = std::find_if(data.states.begin(), data.states.end(),
                                  [&](const OperatingState& s) { return s.name == name; });
  if (found == data.states.end()) {
    std::vector<std::string> names;
    for (const OperatingState& s : data.states) names.push_back(s.name);
    input_error("states", "there is no state '" + shown(name) + "'",
                names.empty() ? "the case has no named states" : suggestion(name, names));
  }
  Case changed = data;
  changed.state = *found;
  changed.states.clear();
  return changed;
}

bool is_on_axis(const BeamPart& beam) {
  return std::all_of(beam.points.begin(), beam.points.end(),
                     [](const Triple& p) { return p[0] == 0 && p[2] == 0; });
}

double outer_radius(const BeamSection& s) {
  switch (s.shape) {
  case BeamShape::pipe:
    return s.radius + s.thickness / 2;
  case BeamShape::solid:
    return s.radius;
  case BeamShape::rectangle:
    return std::hypot(s.width, s.depth) / 2;
  case BeamShape::general:
    return 0;
  }
  return 0;
}

PlaceOnAxis nearest_on_axis(const BeamPart& beam, const Triple& at) {
  using Eigen::Vector3d;
  PlaceOnAxis nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  const Vector3d x = Vector3d::Map(at.data());
  for (std::size_t p = 1; p < beam.points.size(); ++p) {
    const Vector3d from = Vector3d::Map(beam.points[p - 1].data());
    const Vector3d along = Vector3d::Map(beam.points[p].data()) - from;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((x - from).dot(along) / length, 0., 1.) : 0;
    if (const double d = (x - from - share * along).norm(); d < nearest.distance)
      nearest = {p - 1, share, d};
  }
  return nearest;
}

std::string name_of(const Motion& motion) {
  if (!motion.name.empty()) return motion.name;
  std::string name;
  for (const std::string& cap : motion.move) name += cap + "_";
  return name + direction_names[std::size_t(motion.direction)];
}

double highest_frequency(const Analyses& analyses) {
  return std::max(analyses.response ? analyses.response->band[1] : 0,
                  analyses.modes ? analyses.modes->band[1] : 0);
}

double reduction_cutoff(const Analyses& analyses) {
  if (analyses.reduction && analyses.reduction->cutoff > 0) return analyses.reduction->cutoff;
  const double highest = highest_frequency(analyses);
  return highest > 0 ? 2 * highest : 1000;
}

bool held_by_deck(const Case& data) {
  return std::any_of(data.parts.begin(), data.parts.end(), [](const Part& part) {
    const auto* deck = std::get_if<DeckPart>(&part.body);
    return deck != nullptr && deck->held && (!deck->content || !deck->content->supports.empty());
  });
}

std::vector<std::string> excitation_names(const Response& response) {
  std::vector<std::string> names;
  for (const int base : response.bases) names.emplace_back(direction_names[std::size_t(base)]);
  for (const Motion& motion : response.motions) names.push_back(name_of(motion));
  for (const Force& force : response.forces) names.push_back(force.name);
  return names;
}

bool hangs_on_springs(const Cap& cap, const std::string& end) {
  return std::any_of(cap.ends.begin(), cap.ends.end(),
                     [&](const SprungEnd& e) { return e.end == end; });
}

bool has_damped_springs(const Case& data) {
  const auto damped = [](const auto& held) { return held.damping.has_value(); };
  const auto at_cap = [&](const Cap& cap) {
    return damped(cap) || std::any_of(cap.ends.begin(), cap.ends.end(), damped);
  };
  return std::any_of(data.caps.begin(), data.caps.end(), at_cap) ||
         std::any_of(data.mount.begin(), data.mount.end(), damped);
}

bool has_friction(const Case& data) {
  const auto in_part = [](const Part& part) {
    if (const auto* bellows = std::get_if<Bellows>(&part.body))
      return bellows->wall.slip.has_value();
    if (const auto* liner = std::get_if<Interlock>(&part.body))
      return liner->friction || (liner->contact && liner->contact->friction);
    const auto* chain = std::get_if<ConnectorChain>(&part.body);
    if (!chain) return false;
    const auto curved = [](const ConnectorSpring& s) {
      return !s.axial_curve.empty() || !s.transverse_curve.empty();
    };
    return chain->friction || curved(chain->spring) ||
           (chain->end_spring && curved(*chain->end_spring));
  };
  const auto slips = [](const auto& held) { return held.friction.has_value(); };
  const auto at_cap = [&](const Cap& cap) {
    return slips(cap) || std::any_of(cap.ends.begin(), cap.ends.end(), slips);
  };
  return std::any_of(data.parts.begin(), data.parts.end(), in_part) ||
         std::any_of(data.caps.begin(), data.caps.end(), at_cap) ||
         std::any_of(data.mount.begin(), data.mount.end(), slips);
}

} // namespace plica
