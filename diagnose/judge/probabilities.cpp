#include "diagnose/judge/probabilities.hpp"

#include "diagnose/judge/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace plica {

void weigh_singles(const JudgedFit& nominal, const std::vector<EffectFits>& effects,
                   Judgement& result) {
  result.weighing = {.over = Weighing::Over::singles};
  const double none = nominal.fit.log_evidence;
  double highest = none, sum = 0;
  for (const EffectFits& f : effects) highest = std::max(highest, f.log_evidence);
  const auto weigh = [&](const std::string& name, double log_evidence, bool counts) {
    if (!counts) return;
    result.probabilities.emplace_back(name, std::exp(log_evidence - highest));
    sum += result.probabilities.back().second;
  };
  weigh("none", none, nominal.adequate);
  for (const EffectFits& f : effects) weigh(f.effect, f.log_evidence, f.best->stands());
  for (auto& [name, p] : result.probabilities) p /= std::max(sum, 1e-300);
  std::stable_sort(result.probabilities.begin(), result.probabilities.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  for (const EffectFits& f : effects) result.places[f.effect] = f.places;
}

void weigh_with_doubt(double apart, Judgement& result) {
  const double trust = std::log(threshold::far_ahead / (1 - threshold::far_ahead)) / apart;
  double sum = 0;
  for (auto& [name, p] : result.probabilities) sum += p = std::pow(p, trust);
  for (auto& [name, p] : result.probabilities) p /= sum;
}

void weigh_standing(const std::vector<const JudgedFit*>& sets, Judgement& result) {
  result.weighing = {.over = Weighing::Over::standing_sets};
  std::map<std::string, double> effects;
  std::map<std::string, std::map<std::string, double>> places;
  double all = 0, highest = -1e300;
  for (const JudgedFit* set : sets) highest = std::max(highest, evidence_of(set->fit));
  for (const JudgedFit* set : sets) {
    const double weight = std::exp(evidence_of(set->fit) - highest);
    all += weight;
    std::set<std::string> own;
    std::set<std::pair<std::string, std::string>> where;
    for (const Hypothesis* h : set->fit.together) {
      if (own.insert(h->effect).second) effects[h->effect] += weight;
      if (where.emplace(h->effect, h->place).second) places[h->effect][h->place] += weight;
    }
  }
  result.probabilities.clear();
  for (const auto& [effect, weight] : effects) {
    result.probabilities.emplace_back(effect, weight / all);
    std::vector<std::pair<std::string, double>>& shares = result.places[effect];
    shares.assign(places[effect].begin(), places[effect].end());
    for (auto& [place, share] : shares) share /= weight;
    std::stable_sort(shares.begin(), shares.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
  }
}

void weigh_all(const Inclusion& inclusion, Judgement& result) {
  result.weighing = {.over = Weighing::Over::all_sets};
  result.probabilities = inclusion.effects();
  for (const auto& [effect, probability] : result.probabilities) {
    if (effect == "none") continue;
    auto& places = result.places[effect] = inclusion.places(effect);
    for (auto& [place, share] : places) share /= std::max(probability, 1e-300);
  }
}

void claim_no_more_than_is_closed(const JudgedFit& nominal, const JudgedFit* nearest, double odds,
                                  Judgement& result) {
  result.weighing.limited = true;
  const double before = nominal.gap_after;
  const double left = !nearest ? 1 : before > 0 ? nearest->gap_after / before : 0;
  const double closed = std::clamp(1 - left * left, 0., 1.);
  for (auto& [effect, probability] : result.probabilities)
    if (effect != "none") probability *= odds * closed;
}

} // namespace plica
