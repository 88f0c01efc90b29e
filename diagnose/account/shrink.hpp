// How much of the gap goes when effects are modelled.
//
//   G = sqrt(r' Sigma^-1 r / n),   shrink = 1 - G_after / G_before
//
// Interval: draws of the posterior times a bootstrap over the readings.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/evidence.hpp"

namespace plica {

GapShrink gap_shrink(const FitContext& context, const Whitening& white,
                     const HypothesisFit& nominal, const HypothesisFit& best);

// Every reading of the fit predicted by the hypothesis fitted to the others, its value given what
// is known to scatter with it: for tests that hold nothing out. Of more than 24 readings, twelve
// groups of neighbours in turn, which are of one run.
GapShrink in_turn(const FitContext& context, const HypothesisFit& nominal,
                  const HypothesisFit& best);
// "each reading in turn, the others fitted"
std::string how_in_turn(std::size_t readings);

// A parameter of a fit from the readings of one level, direction or band alone.
std::vector<ParameterDrift> drifts(const FitContext& context, const HypothesisFit& fit);

// What would close the gap without being the cause: Young's modulus, density, all damping, each
// left free.
std::vector<Compensator> compensators(const FitContext& context, const Whitening& held_out,
                                      const HypothesisFit& nominal, const Structure& structure);

} // namespace plica
