// Several effects at once, tried where no single one explains the test.
//
// Sets grow by one effect at a time: the best of a size, each with those effects that its residual
// asks for (matched filter). Members of the best sets are then exchanged for the same effect
// elsewhere, since alone an effect may have been drawn to another place by what the others do, and
// left out in turn. Growth ends with a set that explains the test, at five effects, or where a
// further one is worth too little.
#pragma once

#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/judge.hpp"

namespace plica {

// `ranked`: single effects by evidence; `fits`: all single hypotheses; `all`: signatures of all
// hypotheses. By evidence, those of two and more effects.
std::vector<JudgedFit> fit_sets(const FitContext& context, const std::vector<Family>& ranked,
                                const std::vector<JudgedFit>& fits,
                                const std::vector<Signature>& all, const JudgedFit& nominal,
                                const Whitening& held_out, const BlockScores& scores,
                                const Standards& standards);

} // namespace plica
