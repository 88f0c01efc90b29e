#include "diagnose/effects/in_state.hpp"

namespace plica {

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
