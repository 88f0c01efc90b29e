// Hypotheses fitted each alone, of places that lie close to each other as few as need be.
#pragma once

#include "diagnose/judge/judged_fit.hpp"

#include <functional>

namespace plica {

struct PlacesFitted {
  std::vector<JudgedFit> fits; // that were solved; those between others last
  PassedOver passed_over;
};

// First those that lie between no others, then those that lie between (Hypothesis::between) one of
// the best three places of their effect, or one within 7 nats of the best, and others, until there
// are no more; dispersed nats where errors are larger than stated. The latter are reduced here.
// `fit` is called from several threads.
PlacesFitted fit_places(const FitContext& context, const std::vector<const Hypothesis*>& all,
                        const std::function<JudgedFit(const Hypothesis&)>& fit);

} // namespace plica
