#include "diagnose/effects/joints_together.hpp"

namespace plica {

std::optional<JointsTogether> joints_together(const std::vector<JointGroup>& groups) {
  JointsTogether all{.group = {.place = "joints", .bushings = {}, .beams = {}}, .places = {}};
  double compliance = 0;
  for (const JointGroup& g : groups) {
    if (g.mount || g.bushings.empty() || !g.beams.empty()) continue;
    all.group.bushings.insert(all.group.bushings.end(), g.bushings.begin(), g.bushings.end());
    all.places.push_back(g.place);
    compliance += 1 / g.stiffness;
  }
  if (all.places.size() < 2) return std::nullopt;
  all.group.stiffness = 1 / compliance;
  return all;
}

} // namespace plica
