// What a search for effects has found, before it is told.
#pragma once

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/account/told.hpp"
#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judge.hpp"

namespace plica {

struct Findings {
  const FitContext& context;
  const BlockScores& scores;
  const Standards& standards;
  const JudgedFit& nominal;
  const std::vector<EffectFits>& ranked; // effects, the best first
  const std::vector<JudgedFit>& fits;    // single hypotheses
  const std::vector<JudgedFit>& sets;    // several at once, where no single one explains all
  const std::vector<JudgedFit>& beside;  // what leads, with one effect more each
  const Inclusion& inclusion;
  const Judgement& judgement;
  const Told& told;
  const std::vector<Signature>& signatures;
  const std::vector<Compensator>& compensators;
};

} // namespace plica
