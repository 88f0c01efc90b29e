#include "diagnose/judge/added_up.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace plica {

bool change_together(const std::vector<const Hypothesis*>& members) {
  return std::count_if(members.begin(), members.end(), [](const Hypothesis* h) {
           return !h->changes.empty() || !h->case_changes.empty();
         }) > 1;
}

const JudgedFit& best_of(const std::vector<JudgedFit>& sets) {
  const auto credible =
      std::find_if(sets.begin(), sets.end(), [](const JudgedFit& j) { return j.credible(); });
  return credible == sets.end() ? sets.front() : *credible;
}

std::string warning_of_added_up(const std::vector<JudgedFit>& sets) {
  if (sets.empty()) return "";
  const double least = best_of(sets).fit.log_evidence - may_count;
  const auto count = std::count_if(sets.begin(), sets.end(), [&](const JudgedFit& j) {
    return j.added_up && j.fit.log_evidence >= least;
  });
  if (count == 0) return "";
  return fmt::format("{} more sets of effects come within {:g} nats of the best: no more than {} "
                     "are solved anew, of these changes of stiffness and mass are added up",
                     count, may_count, most_solved_anew);
}

} // namespace plica
