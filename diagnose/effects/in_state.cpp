#include "diagnose/effects/in_state.hpp"

#include <algorithm>

namespace plica {

bool asked_for(const Structure& s, const std::string& effect) {
  const DiagnosisRequest& asked = s.data.diagnose;
  return std::find(asked.effects.begin(), asked.effects.end(), effect) != asked.effects.end() ||
         std::any_of(asked.priors.begin(), asked.priors.end(),
                     [&](const PriorRequest& p) { return p.effect == effect; });
}

std::vector<std::function<void(Case&)>>
into_states(const std::vector<std::function<void(OperatingState&)>>& states) {
  std::vector<std::function<void(Case&)>> changes;
  changes.reserve(states.size());
  for (const auto& state : states)
    changes.emplace_back([state](Case& data) {
      if (!data.state) data.state.emplace();
      state(*data.state);
    });
  return changes;
}

} // namespace plica
