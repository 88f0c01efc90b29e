#include "reduction/substructures.hpp"

#include <algorithm>

namespace plica {

std::shared_ptr<const PartReduction> ReductionMemory::find(const Substructure& part,
                                                           const PartReductionRequest& request) {
  std::deque<Entry> known; // compared without the lock: a comparison walks through all elements
  {
    const std::lock_guard lock(mutex_);
    known = entries_;
  }
  const auto found = std::find_if(known.begin(), known.end(), [&](const Entry& e) {
    return e.request == request && is_copy(*e.part, part, 0);
  });
  if (found == known.end()) return nullptr;
  const std::lock_guard lock(mutex_);
  const auto own = std::find_if(entries_.begin(), entries_.end(),
                                [&](const Entry& e) { return e.reduction == found->reduction; });
  if (own != entries_.end()) std::rotate(entries_.begin(), own, own + 1);
  return found->reduction;
}

void ReductionMemory::keep(std::shared_ptr<const Substructure> part,
                           const PartReductionRequest& request,
                           std::shared_ptr<const PartReduction> reduction) {
  constexpr std::size_t most = 16; // with the mesh of its part each
  const std::lock_guard lock(mutex_);
  entries_.push_front({std::move(part), request, std::move(reduction)});
  if (entries_.size() > most) entries_.pop_back();
}

} // namespace plica
