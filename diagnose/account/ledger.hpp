// What the gap is made of (results/diagnosis.hpp): the share of each effect, and what is left.
#pragma once

#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judged_fit.hpp"
#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/evidence.hpp"

namespace plica {

// Effects at the numbers that the test leaves open: sets whose `members`, in this order, stand for
// one another row by row; empty = all of a fit. What else acts in a fit makes its numbers less
// certain and is left out of the account. Fits without draws are represented by the Gaussian at
// their optimum.
struct LedgerSet {
  const HypothesisFit* fit = nullptr;
  double weight = 1;
  std::vector<std::size_t> members = {};
};

// What leads with one effect more beside it (fit_beside), by its probability: the members that lead
// are accounted for. What is hardly probable is left out.
std::vector<LedgerSet> sets_beside(const JudgedFit& lead, const std::vector<JudgedFit>& beside,
                                   const Inclusion& inclusion);

// Rows of effects come first, without their `effects`; none where `sets` is empty. `none`: the
// weight, beside those of the sets, of that none of their effects acts. Intervals are of 90 %, hold
// the share and end at whole percents.
Ledger ledger_of(const FitContext& context, const HypothesisFit& nominal,
                 const std::vector<LedgerSet>& sets, double none = 0);

// What a set explains over the numbers that the test leaves open: a column each.
struct ShareDraws {
  Eigen::MatrixXd z;      // parameters x draws
  Eigen::MatrixXd shares; // of its effects, in their order, and last of what stays unexplained
};
// Fewer where the structure is not stable at some.
ShareDraws share_draws(const FitContext& context, const HypothesisFit& nominal,
                       const HypothesisFit& fit, int count);

} // namespace plica
