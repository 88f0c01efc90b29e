#include "model/description/case.hpp"

#include "model/description/deck_model.hpp"

#include <algorithm>

namespace plica {

bool is_on_axis(const BeamPart& beam) {
  return std::all_of(beam.points.begin(), beam.points.end(),
                     [](const Triple& p) { return p[0] == 0 && p[2] == 0; });
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

bool has_friction(const Case& data) {
  const auto in_part = [](const Part& part) {
    if (const auto* bellows = std::get_if<Bellows>(&part.body))
      return bellows->wall.slip.has_value();
    if (const auto* liner = std::get_if<Interlock>(&part.body)) return liner->friction.has_value();
    const auto* chain = std::get_if<ConnectorChain>(&part.body);
    if (!chain) return false;
    const auto curved = [](const ConnectorSpring& s) {
      return !s.axial_curve.empty() || !s.transverse_curve.empty();
    };
    return chain->friction || curved(chain->spring) ||
           (chain->end_spring && curved(*chain->end_spring));
  };
  return std::any_of(data.parts.begin(), data.parts.end(), in_part) ||
         std::any_of(data.caps.begin(), data.caps.end(),
                     [](const Cap& c) { return c.friction.has_value(); }) ||
         std::any_of(data.mount.begin(), data.mount.end(),
                     [](const Mount& m) { return m.friction.has_value(); });
}

} // namespace plica
