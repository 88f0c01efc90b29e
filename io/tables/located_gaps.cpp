#include "io/tables/located_gaps.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

std::vector<LocatedGap> farthest_first(const Diagnosis& d, bool components) {
  std::vector<LocatedGap> list;
  for (const LocatedGap& b : d.where)
    if (b.component.empty() != components) list.push_back(b);
  std::stable_sort(list.begin(), list.end(), [](const LocatedGap& a, const LocatedGap& b) {
    return std::abs(a.z) > std::abs(b.z);
  });
  return list;
}

} // namespace

std::vector<LocatedGap> located_blocks(const Diagnosis& d) {
  return farthest_first(d, false);
}

std::vector<LocatedGap> located_components(const Diagnosis& d) {
  return farthest_first(d, true);
}

} // namespace plica
