// What the gap is made of (results/diagnosis.hpp): the share of each effect, and what is left.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/evidence.hpp"

namespace plica {

// Effects at the numbers that the test leaves open: sets of as many effects each, which stand for
// one another row by row (an ambiguous list), or a single one. Fits without draws are represented
// by the Gaussian at their optimum.
struct LedgerSet {
  const HypothesisFit* fit = nullptr;
  double weight = 1;
};

// Rows of effects come first, without their `effects`; none where `sets` is empty.
Ledger ledger_of(const FitContext& context, const HypothesisFit& nominal,
                 const std::vector<LedgerSet>& sets);

} // namespace plica
