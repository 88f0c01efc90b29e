#include "run/analyses/seen_enough.hpp"

#include "solve/supports.hpp"

namespace plica {
namespace {

bool needs_all_nodes(const Case& data) {
  const Analyses& a = data.analyses;
  const bool by_response = a.response && (!a.response->motions.empty() || a.response->referee > 0);
  return data.state || has_friction(data) || a.levels || a.life || a.stress || a.deck_loads ||
         a.damping.coupled || by_response;
}

} // namespace

std::optional<SeenCase> seen_enough(const Case& data, const BuiltCase& built) {
  if (!data.analyses.reduction || needs_all_nodes(data) || has_supports(built.model))
    return std::nullopt;
  std::vector<std::string> sets;
  if (data.analyses.response)
    for (const Force& force : data.analyses.response->forces) sets.push_back(force.at);
  constexpr SeenRings rings{.most = 384, .around = 64};
  return seen_case(built, rings, sets);
}

} // namespace plica
