#include "diagnose/weigh/hypothesis_fit.hpp"

#include <algorithm>

namespace plica {

using Eigen::Index;

Index HypothesisFit::first_of(std::size_t member) const {
  Index first = 0;
  for (std::size_t i = 0; i < member; ++i) first += Index(together[i]->parameters.size());
  return first;
}

std::vector<std::string> HypothesisFit::effects() const {
  std::vector<std::string> names;
  for (const Hypothesis* h : together) names.push_back(h->effect);
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace plica
