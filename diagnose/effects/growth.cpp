#include "diagnose/effects/growth.hpp"

#include "lab/measured/states.hpp"

#include <algorithm>

namespace plica {

std::vector<std::string> changed_states(const Measured& measured) {
  std::vector<std::string> found;
  if (!has_baseline(measured)) return found;
  for (const MeasuredState& s : measured.states) {
    const auto in_it = [&](const auto& entries) {
      return std::any_of(entries.begin(), entries.end(),
                         [&](const auto& entry) { return entry.state == s.name; });
    };
    if (!s.baseline && s.set.empty() &&
        (in_it(measured.statics) || in_it(measured.modes) || in_it(measured.peaks) ||
         in_it(measured.frf) || in_it(measured.weighings)))
      found.push_back(s.name);
  }
  return found;
}

Hypothesis grown(Hypothesis h, const std::vector<std::string>& states) {
  if (states.size() < 2 || h.softening) return h;
  const auto own = Eigen::Index(h.parameters.size()), size = Eigen::Index(h.size);
  const EffectParameter first = h.parameters[h.size];
  h.parameters[h.size].name += ", " + states.front();
  for (std::size_t i = 1; i < states.size(); ++i)
    h.parameters.push_back({first.name + ", " + states[i], first.unit, first.prior});
  h.values_in = [own, size, states](const Eigen::VectorXd& values, const std::string& state) {
    Eigen::VectorXd there = values.head(own);
    const auto found = std::find(states.begin(), states.end(), state);
    const auto number = Eigen::Index(std::min<std::ptrdiff_t>(
        found - states.begin(), static_cast<std::ptrdiff_t>(states.size()) - 1));
    if (number > 0) there[size] = values[own + number - 1];
    return there;
  };
  return h;
}

} // namespace plica
