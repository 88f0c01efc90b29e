// What was found, as the user is told: effects with their intervals, where the gap lies, how far it
// shrinks, what else would close it, what to measure next.
#pragma once

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judge.hpp"
#include "diagnose/results/settings.hpp"

namespace plica {

struct Findings {
  const FitContext& context;
  const BlockScores& scores;
  const Standards& standards;
  const JudgedFit& nominal;
  const std::vector<Family>& ranked;  // effects, the best first
  const std::vector<JudgedFit>& fits; // single hypotheses
  const std::vector<JudgedFit>& sets; // several at once, where no single one explains the test
  const Inclusion& inclusion;
  const Judgement& judgement;
  const std::vector<Signature>& signatures;
  const std::vector<Compensator>& compensators;
};

// Tells the stage of what takes time.
Diagnosis account_of(GapProblem& problem, const Findings& found, const DiagnosisSettings& settings);

} // namespace plica
