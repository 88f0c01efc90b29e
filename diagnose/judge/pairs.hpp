// Two effects at once, tried where no single one explains the test.
#pragma once

#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/judge.hpp"

namespace plica {

// The best effects, each with those that its residual asks for (matched filter); by evidence.
// `ranked`: single effects by evidence; `fits`: all single hypotheses; `all`: signatures of all
// hypotheses.
std::vector<JudgedFit> fit_pairs(const FitContext& context, const std::vector<Family>& ranked,
                                 const std::vector<JudgedFit>& fits,
                                 const std::vector<Signature>& all, const HypothesisFit& plain,
                                 const Whitening& held_out, const BlockScores& scores,
                                 const Standards& standards);

} // namespace plica
