// How probable it is that an effect is part of the cause, over all sets that were tried.
//
//   P(S | test) ~ exp(ln Z(S)) prod over members (1 / N) w / W(effect),   N effects tried
//
// that is, one effect is expected, anywhere; w the weight of the hypothesis, W that of all of its
// effect. ln Z is the dispersed one (evidence.hpp), since a set
// that does not explain the test cannot claim the errors that were stated.
#pragma once

#include "diagnose/judge/judged_fit.hpp"

#include <map>

namespace plica {

class Inclusion {
public:
  // `fits`: of single hypotheses, `sets`: of several. Both must outlive it.
  Inclusion(const JudgedFit& nominal, const std::vector<JudgedFit>& fits,
            const std::vector<JudgedFit>& sets, const PassedOver& passed_over = {});

  double of(const std::string& effect) const; // anywhere
  double at(const std::string& effect, const std::string& place) const;
  // With "none", the largest first.
  std::vector<std::pair<std::string, double>> effects() const;
  std::vector<std::pair<std::string, double>> places(const std::string& effect) const;

  double none() const { return none_; } // the nominal case
  // ln P(S | test) but for a constant, of any set.
  double log_weight(const JudgedFit& set) const;
  // Sets of different effects, each at its best places, with the probability of these effects,
  // wherever they sit; the most probable first.
  std::vector<std::pair<const JudgedFit*, double>> first(std::size_t count) const;

  // The most probable; null: the nominal case.
  const JudgedFit* leading() const { return leading_; }
  // The most probable of those whose effects all have at least this probability, each where it most
  // probably sits whatever else acts; null: none.
  const JudgedFit* leading_with(double each_at_least) const;
  // What was tried of its other members alone; null: that was not.
  const JudgedFit* without(const JudgedFit& set,
                           const std::vector<const Hypothesis*>& members) const;

private:
  struct Weighed {
    const JudgedFit* fit;
    double weight;
  };
  // Of the sets of the same effects.
  const JudgedFit* placed_best(const JudgedFit& set) const;

  std::map<std::string, double> places_; // weight of all hypotheses of an effect
  std::vector<Weighed> all_;
  double none_ = 1;
  const JudgedFit* leading_ = nullptr;
};

} // namespace plica
