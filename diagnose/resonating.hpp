// What hangs on the structure by a spring of its own (effects/resonators.hpp), held against what
// leads a diagnosis. It is fitted when it is first asked for.
#pragma once

#include "diagnose/judge/sets.hpp"

namespace plica {

class Resonating {
public:
  // All must outlive it.
  Resonating(const SetSearch& search, const HypothesisFit& plain,
             const std::vector<Hypothesis>& hypotheses)
      : search_(search), plain_(plain), hypotheses_(hypotheses) {}

  // The best in words, in place of what leads or of one of several, that is worth so many nats
  // more, resonates among the frequencies that were measured and is itself believed; empty = none.
  std::string instead_of(const JudgedFit& leads, double nats_more);

private:
  JudgedFit judged_fit(const std::vector<const Hypothesis*>& together,
                       const Eigen::VectorXd& start = {}) const;
  void fit_alone();
  // The best of them, each in place of one of several.
  std::vector<JudgedFit> beside_others_of(const HypothesisFit& lead) const;

  const SetSearch& search_;
  const HypothesisFit& plain_;
  const std::vector<Hypothesis>& hypotheses_;
  bool fitted_ = false;
  std::vector<JudgedFit> alone_; // the best first
};

} // namespace plica
