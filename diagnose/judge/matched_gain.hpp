// What a hypothesis would be worth beside what is fitted, by the matched filter of its signature.
#pragma once

#include "diagnose/judge/identifiability.hpp"

namespace plica {

// Beside a set, in nats: its filter on what the set leaves, of which the set takes up its share.
double gain_beside(const HypothesisFit& set, const Signature& s);
// The most that one further effect would be worth, nats.
double worth_of_one_more(const HypothesisFit& fit, const std::vector<Signature>& all);

} // namespace plica
