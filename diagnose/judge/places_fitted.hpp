// Hypotheses fitted each alone, of places that lie close to each other as few as need be.
#pragma once

#include "diagnose/judge/judged_fit.hpp"

#include <functional>

namespace plica {

// Whether one of two places of an effect, in one way, lies between the other and a third.
bool lie_next(const Hypothesis& a, const Hypothesis& b);

struct PlacesFitted {
  std::vector<JudgedFit> fits; // that were solved; those between others last
  PassedOver passed_over;
};

// First those that lie between no others, then, until there are no more, those that lie between
// (Hypothesis::between) one of the best three places of their effect and others, in the way that is
// best there; where the effect comes within 7 nats of the best of all, also those next to what lies
// within 7 nats of its own best. Dispersed nats where
// errors are larger than stated. The latter are reduced here.
// `fit` is called from several threads.
PlacesFitted fit_places(const FitContext& context, const std::vector<const Hypothesis*>& all,
                        const std::function<JudgedFit(const Hypothesis&)>& fit);

} // namespace plica
