#include "diagnose/account/tried.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace plica {
namespace {

std::string why_inadequate(const JudgedFit& j, const Standards& limit) {
  if (j.worst.first > limit.worst_block)
    return fmt::format("does not explain {} (z {:.1f}, limit {:.1f})", j.worst.second,
                       j.worst.first, limit.worst_block);
  if (j.fit.chi2 > limit.chi2)
    return fmt::format("all readings together (chi-square {:.1f}, limit {:.1f})", j.fit.chi2,
                       limit.chi2);
  if (j.chi2_of_means > limit.chi2_of_means)
    return fmt::format("the means over the levels (chi-square {:.1f}, limit {:.1f})",
                       j.chi2_of_means, limit.chi2_of_means);
  return fmt::format("leaves a gap of {:.1f}", j.gap_after);
}

TriedHypothesis told(const JudgedFit& j, const GapProblem& problem, const Findings& found,
                     const NamedEffects& names) {
  const double nominal = found.nominal.fit.log_evidence;
  TriedHypothesis t{.effects = {},
                    .log_evidence = j.fit.log_evidence,
                    .sampled_log_evidence = j.fit.sampled_log_evidence,
                    .log_bayes_factor = j.log_bayes_factor,
                    .half_width = log_evidence_at_width(j.fit, 0.5) - nominal,
                    .double_width = log_evidence_at_width(j.fit, 2) - nominal,
                    .chi2 = j.fit.chi2,
                    .chi2_of_means = j.chi2_of_means,
                    .adequate = j.adequate,
                    .share_of_healthy_worse = j.p,
                    .worst_block = j.worst.second,
                    .worst_block_z = j.worst.first,
                    .gap_after = j.gap_after,
                    .held_out_after = j.held_out_after,
                    .absurd = j.absurd,
                    .fails_held_out = j.fails_held_out,
                    .rejected = why_rejected(j, found.standards)};
  for (std::size_t h = 0; h < j.fit.together.size(); ++h)
    t.effects.push_back(names.named(j.fit, h, 0, {}));
  for (Eigen::Index i : j.fit.aside)
    t.aside.push_back(problem.readings.readings[std::size_t(i)].name);
  return t;
}

} // namespace

std::string why_rejected(const JudgedFit& j, const Standards& limit) {
  if (!j.adequate) return why_inadequate(j, limit);
  if (j.absurd) return "only with a value far out of its prior";
  return j.fails_held_out ? "does not predict the held-out readings" : "";
}

Tried tried(const GapProblem& problem, const Findings& found, const NamedEffects& names,
            const JudgedFit& best) {
  std::vector<const JudgedFit*> all{&found.nominal};
  for (const EffectFits& f : found.ranked) all.push_back(f.best);
  for (const JudgedFit& set : found.sets) all.push_back(&set);
  if (std::find(all.begin(), all.end(), &best) == all.end()) all.push_back(&best);
  std::stable_sort(all.begin(), all.end(), [](const JudgedFit* a, const JudgedFit* b) {
    return a->log_bayes_factor > b->log_bayes_factor;
  });
  Tried result;
  for (const JudgedFit* j : all) {
    if (j == &best && j != &found.nominal) result.best = result.all.size();
    result.all.push_back(told(*j, problem, found, names));
  }
  return result;
}

} // namespace plica
