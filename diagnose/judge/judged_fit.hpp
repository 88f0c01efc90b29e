// Fits held against what healthy specimens show, and effects over their places.
#pragma once

#include "diagnose/judge/thresholds.hpp"
#include "diagnose/weigh/blocks.hpp"
#include "diagnose/weigh/evidence.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace plica {

// Of healthy specimens; computed once per test.
struct Standards {
  double chi2 = 0, chi2_of_means = 0, held_out_chi2 = 0; // 99 %, 99 % and 99.9 % points
  double sure_chi2 = 0, sure_chi2_of_means = 0;          // 90 % points
  double worst_block = threshold::worst_block;
  double evidence = threshold::over_nothing; // ln BF over the nominal case
  double apart = threshold::effects_apart;
  std::vector<double> healthy_chi2; // sorted
  bool gate = true;                 // false: adequacy is not asked for (an ablation)
};
Standards standards_of(const FitContext& context, const Whitening& held_out,
                       const BlockScores& scores);

// A fit with what it is worth.
struct JudgedFit {
  HypothesisFit fit;
  double log_bayes_factor = 0;
  bool adequate = false, absurd = false, held_out_met = false, fails_held_out = false;
  double p = 1, chi2_of_means = 0;
  std::pair<double, std::string> worst;
  double gap_after = 0;
  std::optional<double> held_out_after, held_out_shrink;
  bool at_the_edge = false; // adequate, though nine of ten healthy specimens leave less
  bool added_up =
      false; // changes of several effects, which were not solved together (added_up.hpp)
  int free_parameters = 0;
  Eigen::Index readings = 0, moved = 0; // fitted, and that it moves; a shape counts as one
  // It closes nothing of the gap, or less than a tenth where the nominal case does not explain the
  // test: what it is allowed to be off (evidence.hpp) is larger than what it explains.
  bool explains_nothing = false;
  bool stays_at_priors = false; // no reading says anything of any of its parameters
  bool credible() const { return stands() && !absurd; }
  // Not refuted by any reading: what is named has to be told apart from it, though it may be too
  // far out of its prior to be named for sure.
  bool stands() const {
    return adequate && !fails_held_out && !explains_nothing && !stays_at_priors;
  }
  // Whether there are too few readings for several effects, or for what explains most: less than
  // three for each free parameter.
  bool too_free() const;
  // Why so few readings identify nothing: as many parameters are free as there are readings, or,
  // where several are free, all but one of the readings that they move by a tenth of their standard
  // deviation: one reading more is met by chance. Empty = they may.
  std::string saturated() const;
  // Whether an effect in it names a place only (Hypothesis::names_place_only).
  bool leaves_cause_open() const;
};
JudgedFit judged(HypothesisFit fit, const HypothesisFit& nominal, const FitContext& context,
                 const Whitening& held_out, const BlockScores& scores, const Standards& standards);

// An effect over all its places.
struct EffectFits {
  std::string effect;
  double log_evidence = 0;         // over its hypotheses, by Hypothesis::weight
  const JudgedFit* best = nullptr; // place
  std::vector<std::pair<std::string, double>> places = {}; // with their shares, the largest first
};
// By effect, the weight (Hypothesis::weight) of hypotheses that were left out, as places beside
// them are far behind the best: places as the others, of no evidence.
using PassedOver = std::map<std::string, double>;
// By evidence.
std::vector<EffectFits> fits_by_effect(const std::vector<JudgedFit>& fits,
                                       const PassedOver& passed_over = {});

// The first sets of different effects: one effect with many places would take all the turns.
std::vector<JudgedFit> of_different_effects(const std::vector<JudgedFit>& sets, std::size_t most);

// Without effects that name a place only (Hypothesis::names_place_only) where another effect at
// that place closes half as much of the gap.
void drop_places_with_a_cause(std::vector<JudgedFit>& fits, const JudgedFit& nominal);

// ln Z, by Markov chains where they were followed.
double evidence_of(const HypothesisFit& fit);

} // namespace plica
