// What hangs on the structure by a spring of its own (effects/resonators.hpp), held against what
// leads a diagnosis. It is fitted when it is first asked for.
#pragma once

#include "diagnose/judge/sets.hpp"

namespace plica {

class Resonating {
public:
  using Listed = std::function<std::vector<Hypothesis>()>;
  // `search` and `plain` must outlive it. `list` is asked when a resonator is first asked for; it
  // must outlive what was found of it.
  Resonating(const SetSearch& search, const HypothesisFit& plain, Listed list)
      : search_(search), plain_(plain), list_(std::move(list)) {}

  // The best, in place of what leads or of one of several, that is worth so many nats more,
  // resonates among the frequencies that were measured and is itself believed. None, too, where the
  // search was stopped.
  std::optional<JudgedFit> instead_of(const JudgedFit& leads, double nats_more);

private:
  JudgedFit judged_fit(const std::vector<const Hypothesis*>& together,
                       const Eigen::VectorXd& start = {}) const;
  void fit_alone();
  // The best of them, each in place of one of several.
  std::vector<JudgedFit> beside_others_of(const HypothesisFit& lead) const;

  const SetSearch& search_;
  const HypothesisFit& plain_;
  const Listed list_;
  bool fitted_ = false;
  std::vector<Hypothesis> hypotheses_;
  std::vector<JudgedFit> alone_; // the best first
};

} // namespace plica
