#include "lab/identification/peak_picking.hpp"

#include "lab/signals/peaks.hpp"

namespace plica {

std::vector<PickedPeak> pick_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXd& magnitude,
                                   double prominence, double floor) {
  std::vector<PickedPeak> picked;
  for (const Peak& p : find_peaks(hertz, magnitude, floor)) {
    Eigen::Index at = 0;
    (hertz.array() - p.frequency).abs().minCoeff(&at);
    while (at > 0 && magnitude[at - 1] > magnitude[at]) --at;
    while (at + 1 < hertz.size() && magnitude[at + 1] > magnitude[at]) ++at;
    if (magnitude[at] < prominence * higher_valley(magnitude, at)) continue;
    PickedPeak q{.frequency = p.frequency, .amplitude = p.height, .damping = p.damping};
    q.lines = static_cast<int>((hertz.array() >= p.f1 && hertz.array() <= p.f2).count());
    picked.push_back(q);
  }
  return picked;
}

} // namespace plica
