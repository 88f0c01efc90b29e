// Effects of a fit as they are told: place, values with intervals, probability, other places.
#pragma once

#include "diagnose/account/findings.hpp"

namespace plica {

class NamedEffects {
public:
  // Both must outlive it.
  NamedEffects(const GapProblem& problem, const Findings& found)
      : problem_(problem), found_(found) {}

  // All that is told of the members of a fit.
  std::vector<NamedEffect> members_of(const HypothesisFit& fit) const;

  // Name, values and probability of one member of a fit. `fits`: of single hypotheses, where other
  // ways of the same effect are looked for.
  NamedEffect named(const HypothesisFit& fit, std::size_t member, double probability,
                    const std::vector<JudgedFit>& fits) const;

private:
  std::function<CaseEdits(const Case&)>
  in_case(const Hypothesis& h, const std::vector<EstimatedParameter>& parameters) const;
  void add_other_places(NamedEffect& e) const;
  void add_exchanged_places(NamedEffect& e, const HypothesisFit& set, std::size_t member) const;

  const GapProblem& problem_;
  const Findings& found_;
};

// Of sets that explain a test alike, the members of the first, each with what takes its place in
// the others: the same effect elsewhere, else another one.
std::vector<std::vector<NamedEffect>>
alternatives(const std::vector<std::vector<NamedEffect>>& sets);

} // namespace plica
