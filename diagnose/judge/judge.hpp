// The verdict, by rules that are fixed before a test is seen. Thresholds come from healthy
// specimens.
//
//   adequate    chi2 of all readings, and of their means over the levels, at most that of 99 % of
//               healthy specimens, no block beyond its 99.95 %; without what the hypothesis is
//               allowed to be off (evidence.hpp), which carries laws of slip, a gap of 1.5
//   none        the nominal case is adequate and no effect has ln BF above the threshold
//   identified  best effect adequate, ln BF above the threshold over the nominal case and 3 (beside
//               a baseline 5) over every other adequate effect, no parameter beyond |z| = 3,
//               held-out readings met
//   ambiguous   several adequate effects within that of the best; or what would be identified has
//   as
//               many free parameters as there are fitted readings, or foretells readings taken in
//               turn no better than no effect does: then up to three effects within 8 of it. A
//               parameter is free where its posterior is narrower than half its prior, or a move
//               within the prior changes a reading by a tenth of its standard deviation
//   pair        no single one adequate; a pair is, with 5 more than the best single one, each half
//               worth 3, held-out readings met and better by three tenths, or where nothing is held
//               out readings in turn (the interval of their shrink above zero), and fewer free
//               parameters than readings; with it all such pairs within 3 of it
//   unknown     everything else
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/blocks.hpp"
#include "diagnose/weigh/evidence.hpp"

#include <functional>
#include <map>

namespace plica {

// Of healthy specimens; computed once per test.
struct Standards {
  double chi2 = 0, chi2_of_means = 0, held_out_chi2 = 0; // 99 %, 99 % and 99.9 % points
  double worst_block = 3.3;                              // standard score
  double evidence = 3;                                   // ln BF over the nominal case
  double apart = 3;                                      // nats between effects told apart
  std::vector<double> healthy_chi2;                      // sorted
  bool gate = true; // false: adequacy is not asked for (an ablation)
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
  int free_parameters = 0;
  bool credible() const { return adequate && !absurd && !fails_held_out; }
};
JudgedFit judged(HypothesisFit fit, const HypothesisFit& nominal, const FitContext& context,
                 const Whitening& held_out, const BlockScores& scores, const Standards& standards);

// An effect over all its places.
struct Family {
  std::string effect;
  double log_evidence = 0;                                 // places weigh alike
  const JudgedFit* best = nullptr;                         // place
  std::vector<std::pair<std::string, double>> places = {}; // with their shares, the largest first
};
std::vector<Family> families(const std::vector<JudgedFit>& fits); // by evidence

struct Judgement {
  Verdict verdict = Verdict::none;
  std::vector<const JudgedFit*> named; // one; the ambiguous set; or the pairs, the best first
  std::vector<std::pair<std::string, double>> probabilities; // of effects, wherever they sit
  std::map<std::string, std::vector<std::pair<std::string, double>>> places; // of an effect
  std::string withheld; // why an effect that leads is not identified; empty = nothing is
  std::optional<GapShrink> in_turn; // of what leads, where its readings were taken in turn
  double probability_of(const std::string& effect) const;
  double share_of(const std::string& effect, const std::string& place) const; // 1 where not known
};

// Why a fit that leads must not be called identified; empty = it may.
struct Objection {
  std::string why;
  std::optional<GapShrink> in_turn = {}; // where it was asked for
};
using Objecting = std::function<Objection(const JudgedFit&)>;

Judgement judge(const JudgedFit& nominal, const std::vector<Family>& families,
                const std::vector<JudgedFit>& pairs, const Standards& standards,
                const Objecting& objecting = {});

} // namespace plica
