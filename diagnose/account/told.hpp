// What the user is told of, solved as far as the account of it asks for.
#pragma once

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/judge/judge.hpp"

namespace plica {

struct Told {
  // The effects named, else what comes nearest, else none. Where several act at once, or errors are
  // larger than stated, with draws of all their parameters together.
  std::vector<HypothesisFit> fits;
  const JudgedFit* first; // the best of these; none: the nominal case
  // On all readings, what was held out among them: the best, and the best effect beside it.
  HypothesisFit best;
  std::optional<HypothesisFit> second;
  std::optional<HypothesisFit>
      resonator;                      // with draws (Judgement::resonator), which comes last in it
  std::optional<GapShrink> in_turn;   // of the best, where nothing is held out
  std::vector<ParameterDrift> drifts; // of one effect
};

// `ranked`: effects, the best first. Refers to `nominal` and what was judged.
Told told_of(GapProblem& problem, const JudgedFit& nominal, const std::vector<EffectFits>& ranked,
             const Judgement& judgement, int particles);

} // namespace plica
