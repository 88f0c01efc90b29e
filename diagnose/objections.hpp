// Why what leads must not be named: what is asked of it once it leads, since it takes solutions of
// its own (judge.hpp has the rules, reasons.hpp those of what is solved, thresholds.hpp what they
// ask for).
#pragma once

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judge.hpp"
#include "diagnose/judge/sets.hpp"
#include "diagnose/resonating.hpp"

namespace plica {

class Objections {
public:
  // All must outlive it. `tempting`: factors on everything that would close the gap. `resonators`
  // lists those of effects/resonators.hpp.
  Objections(const GapProblem& problem, const SetSearch& search, const HypothesisFit& plain,
             const std::vector<Compensator>& tempting, Resonating::Listed resonators,
             const Inclusion& inclusion)
      : problem_(problem), search_(search), context_(search.context), plain_(plain),
        tempting_(tempting), resonating_(search, plain, std::move(resonators)),
        inclusion_(inclusion) {}

  Referee referee(); // which must not outlive this
  // What was asked about last, with one effect more beside it each; empty where nothing was.
  const std::vector<JudgedFit>& beside() const { return beside_; }
  // Where nothing is named, or what is listed leaves more than healthy specimens do: what hangs on
  // a spring of its own and explains far more; none = nothing does.
  std::optional<JudgedFit> resonator_beyond(const Judgement& judgement);

private:
  // To effects that would explain all, one or together, and to such that would explain most.
  Objection to_all(const JudgedFit& leads);
  Objection to_sets(const JudgedFit& leads);
  Objection to_most(const JudgedFit& leads);

  Objection to_most_alone(const JudgedFit& leads) const;
  std::string closes_too_little_beside(const JudgedFit& leads, const HypothesisFit& sampled) const;
  Objection outdone_by_resonator(const JudgedFit& leads, double nats_more);
  bool beside_baseline() const;
  std::string what_remains(const JudgedFit& leads) const;

  const GapProblem& problem_;
  const SetSearch& search_;
  const FitContext& context_;
  const HypothesisFit& plain_;
  const std::vector<Compensator>& tempting_;
  Resonating resonating_;
  const Inclusion& inclusion_;
  std::vector<JudgedFit> beside_;
};

} // namespace plica
