// Several effects at once, tried where no single one explains all of the test.
//
// Sets grow by one effect at a time: the best of a size, of different effects, each with every
// effect at the place that its residual asks for (matched filter, which far from the nominal case
// is no more than a hint), and where the effect is best alone. Members of the best sets are then
// exchanged for the same effect elsewhere, since alone an effect may have been drawn to another
// place by what the others do, and left out in turn. Of places that lie between others
// (Hypothesis::between) sets have those that were worth a fit alone, and in the end those next to
// the members of the best. Growth ends at five effects or where the readings carry no more, three
// each, where a further one is worth too little, or with a set that explains the test and whose
// residual asks for no more.
//
// While sets are searched, changes of the model are added up; those that may count are then fitted
// anew (added_up.hpp), and so is all that is tried from there on.
#pragma once

#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/judge.hpp"
#include "diagnose/results/settings.hpp"

namespace plica {

// What sets grow from.
struct SetSearch {
  const FitContext& context;
  const std::vector<EffectFits>& ranked; // single effects by evidence
  const std::vector<JudgedFit>& fits;    // all single hypotheses
  const PassedOver& passed_over;         // of single hypotheses
  const std::vector<Signature>& all;     // of all hypotheses
  const JudgedFit& nominal;
  const Whitening& held_out;
  const BlockScores& scores;
  const Standards& standards;
  const DiagnosisSettings& settings;
};

// By evidence, those of two and more effects; where it is stopped, those that were tried until
// then.
std::vector<JudgedFit> fit_sets(const SetSearch& search);

// The set that leads with one effect more, solved anew: those that its residual asks for most,
// though too little to be named. How far they may act as well is part of what is not known of it.
std::vector<JudgedFit> fit_beside(const SetSearch& search, const JudgedFit& lead);

} // namespace plica
