#include "diagnose/weigh/twins.hpp"

#include <algorithm>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

bool may_be_twin(const Hypothesis& h, const Members& set) {
  return !h.along.empty() && std::count_if(set.begin(), set.end(), [&](const Hypothesis* own) {
                               return own->effect == h.effect && own->place == h.place;
                             }) < 2;
}

bool ends_with_twin(const Members& set) {
  return set.size() > 1 && std::find(set.begin(), set.end() - 1, set.back()) != set.end() - 1;
}

Members without(Members set, const Members& these) {
  for (const Hypothesis* h : these)
    if (const auto own = std::find(set.begin(), set.end(), h); own != set.end()) set.erase(own);
  return set;
}

VectorXd in_order_of(const HypothesisFit& fit, VectorXd z) {
  for (std::size_t a = 0; a < fit.together.size(); ++a)
    for (std::size_t b = a + 1; b < fit.together.size(); ++b) {
      const Hypothesis& h = *fit.together[a];
      if (fit.together[b] != &h || h.along.empty()) continue;
      const Index size = Index(h.parameters.size()), along = Index(h.along.front());
      const Index first = fit.first_of(a), second = fit.first_of(b);
      const bool now = z[first + along] < z[second + along];
      const bool optimum = fit.z[first + along] < fit.z[second + along];
      if (now != optimum) z.segment(first, size).swap(z.segment(second, size));
    }
  return z;
}

} // namespace plica
