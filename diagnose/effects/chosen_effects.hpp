// The hypotheses of a case: of all effects, or of those that the case lets in.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

struct ChosenEffects {
  std::vector<Hypothesis> hypotheses;
  std::vector<std::string> without_place; // effects that the case has no place for
  std::vector<std::string> words;         // what the case says of them, a line each
};

// By `diagnose:` of the case: effects left out, places, priors. Throws InputError with the key of
// what names no effect, no parameter or no place, or leaves nothing.
ChosenEffects chosen_effects(const Structure& s);

// Those whose neighbours (Hypothesis::between) are not among them are looked at themselves.
void look_at_those_alone(std::vector<Hypothesis>& all);

// Whether it sits at a place that the case lets in. What acts everywhere or on the test has no
// place that could be elsewhere.
bool sits_where_asked(const Case& data, const Hypothesis& h);

} // namespace plica
