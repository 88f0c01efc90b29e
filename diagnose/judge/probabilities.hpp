// Probabilities of effects and of their places, as a verdict states them: among single effects,
// among sets that explain the test alike, or over all that was tried.
#pragma once

#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judgement.hpp"

namespace plica {

// Of single effects and of none among what stands, were one of them all there is.
void weigh_singles(const JudgedFit& nominal, const std::vector<EffectFits>& effects,
                   Judgement& result);

// Nats by which effects are not told apart yet may come from errors of the model, so that none of a
// list is sure: as far ahead of the next as would tell them apart is 0.9 of two.
void weigh_with_doubt(double apart, Judgement& result);

// Over sets that explain the test.
void weigh_standing(const std::vector<const JudgedFit*>& sets, Judgement& result);

// Over all sets that were tried.
void weigh_all(const Inclusion& inclusion, Judgement& result);

// Where nothing explains the test, being ahead of all others that are known does not make an effect
// the cause: of what it leaves, something that is not known is. `nearest`: what leaves least; null:
// the nominal case. `odds`: at most, of effects that close all.
void claim_no_more_than_is_closed(const JudgedFit& nominal, const JudgedFit* nearest, double odds,
                                  Judgement& result);

} // namespace plica
