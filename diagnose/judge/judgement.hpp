// What a verdict says of a test: what is named, how probable effects and their places are, and why
// something is not named.
#pragma once

#include "diagnose/judge/judged_fit.hpp"
#include "diagnose/results/diagnosis.hpp"

#include <map>

namespace plica {

struct Judgement {
  Verdict verdict = Verdict::none;
  std::vector<const JudgedFit*> named; // one; an ambiguous list; or sets, the best first
  // Where nothing is named, what comes nearest; null: nothing is better than the nominal case.
  const JudgedFit* nearest = nullptr;
  std::vector<std::pair<std::string, double>> probabilities; // of effects, wherever they sit
  std::map<std::string, std::vector<std::pair<std::string, double>>> places; // of an effect
  Weighing weighing;                                                         // of these
  bool stopped = false;                                                      // before all was tried
  std::string withheld;                 // why an effect that leads is not named; empty = nothing is
  std::optional<GapShrink> in_turn;     // of what leads, where its readings were taken in turn
  std::optional<HypothesisFit> sampled; // the same with draws (Objection)
  std::string warning;                  // what it is named in spite of; empty = nothing
  // What hangs on a spring of its own and explains as much as what leads, or far more, though it is
  // no effect here; none = nothing is known of such a thing.
  std::optional<JudgedFit> resonator;
  bool mounted_anew = false; // none, though the nominal case is not adequate
  // Whether what is named are sets that explain the test.
  bool names_sets() const {
    return verdict == Verdict::several ||
           (verdict == Verdict::ambiguous && named.front()->fit.together.size() > 1);
  }
  // Whether what leads was found by all rules, none of which withheld it.
  bool is_settled() const { return verdict != Verdict::unknown && withheld.empty(); }
  // What is told first: the best of what is named, else what comes nearest, else the nominal case.
  const JudgedFit& told(const JudgedFit& nominal) const {
    if (!named.empty()) return *named.front();
    return nearest ? *nearest : nominal;
  }
  // Whether the resonator is far ahead of it.
  bool resonator_is_ahead(const JudgedFit& nominal) const;
  double probability_of(const std::string& effect) const;
  double share_of(const std::string& effect, const std::string& place) const; // 1 where not known
};

} // namespace plica
