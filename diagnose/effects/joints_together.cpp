#include "diagnose/effects/joints_together.hpp"

namespace plica {

std::vector<JointsTogether> joints_together(const std::vector<JointGroup>& groups) {
  std::vector<JointsTogether> found;
  for (const bool rigid : {false, true}) {
    JointsTogether all{.group = {.place = rigid ? "clamps" : "joints",
                                 .bushings = {},
                                 .beams = {},
                                 .rigid = rigid},
                       .places = {}};
    double compliance = 0;
    for (const JointGroup& g : groups) {
      if (g.mount || g.beside || g.rigid != rigid || g.bushings.empty() || !g.beams.empty())
        continue;
      all.group.bushings.insert(all.group.bushings.end(), g.bushings.begin(), g.bushings.end());
      all.places.push_back(g.place);
      compliance += 1 / g.stiffness;
    }
    if (all.places.size() < 2) continue;
    all.group.stiffness = 1 / compliance;
    found.push_back(std::move(all));
  }
  return found;
}

} // namespace plica
