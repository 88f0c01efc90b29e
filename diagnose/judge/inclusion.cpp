#include "diagnose/judge/inclusion.hpp"

#include "diagnose/weigh/twins.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

bool has(const JudgedFit& j, const std::string& effect) {
  return std::any_of(j.fit.together.begin(), j.fit.together.end(),
                     [&](const Hypothesis* h) { return h->effect == effect; });
}

std::vector<std::pair<std::string, double>>
largest_first(const std::map<std::string, double>& shares) {
  std::vector<std::pair<std::string, double>> list(shares.begin(), shares.end());
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return list;
}

} // namespace

Inclusion::Inclusion(const JudgedFit& nominal, const std::vector<JudgedFit>& fits,
                     const std::vector<JudgedFit>& sets, const PassedOver& passed_over) {
  for (const JudgedFit& j : fits) places_[j.fit.together[0]->effect] += j.fit.together[0]->weight;
  for (const auto& [effect, weight] : passed_over)
    if (const auto own = places_.find(effect); own != places_.end()) own->second += weight;
  for (const std::vector<JudgedFit>* list : {&fits, &sets})
    for (const JudgedFit& j : *list)
      if (j.fit.solved && !j.explains_nothing) all_.push_back({&j, log_weight(j)});
  none_ = log_weight(nominal);
  double highest = none_;
  for (const Weighed& w : all_) highest = std::max(highest, w.weight);
  double sum = none_ = std::exp(none_ - highest), most = none_;
  for (Weighed& w : all_) sum += w.weight = std::exp(w.weight - highest);
  for (const Weighed& w : all_)
    if (w.weight > most) {
      most = w.weight;
      leading_ = w.fit;
    }
  none_ /= sum;
  for (Weighed& w : all_) w.weight /= sum;
}

double Inclusion::log_weight(const JudgedFit& set) const {
  const double effect = 1 / std::max(1., double(places_.size()));
  double value = dispersed_log_evidence(set.fit);
  for (const Hypothesis* h : set.fit.together) {
    const auto known = places_.find(h->effect);
    value += std::log(effect * (known == places_.end() ? 1 : h->weight / known->second));
  }
  return value;
}

std::vector<std::pair<const JudgedFit*, double>> Inclusion::first(std::size_t count) const {
  struct Best {
    const JudgedFit* fit = nullptr;
    double weight = 0, all = 0;
  };
  std::map<std::vector<std::string>, Best> best;
  for (const Weighed& w : all_) {
    Best& own = best[w.fit->fit.effects()];
    own.all += w.weight;
    if (!own.fit || w.weight > own.weight) {
      own.fit = w.fit;
      own.weight = w.weight;
    }
  }
  std::vector<std::pair<const JudgedFit*, double>> list;
  for (const auto& [effects, own] : best) list.emplace_back(own.fit, own.all);
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (list.size() > count) list.resize(count);
  return list;
}

double Inclusion::of(const std::string& effect) const {
  double sum = 0;
  for (const Weighed& w : all_)
    if (has(*w.fit, effect)) sum += w.weight;
  return sum;
}

double Inclusion::at(const std::string& effect, const std::string& place) const {
  for (const auto& [name, share] : places(effect))
    if (name == place) return share;
  return 0;
}

std::vector<std::pair<std::string, double>> Inclusion::effects() const {
  std::map<std::string, double> shares{{"none", none_}};
  for (const Weighed& w : all_) {
    const std::vector<std::string> all = w.fit->fit.effects();
    for (const std::string& effect : std::set<std::string>(all.begin(), all.end()))
      shares[effect] += w.weight;
  }
  return largest_first(shares);
}

std::vector<std::pair<std::string, double>> Inclusion::places(const std::string& effect) const {
  std::map<std::string, double> shares;
  for (const Weighed& w : all_) {
    std::set<std::string> own;
    for (const Hypothesis* h : w.fit->fit.together)
      if (h->effect == effect) own.insert(h->place);
    for (const std::string& place : own) shares[place] += w.weight;
  }
  return largest_first(shares);
}

const JudgedFit* Inclusion::leading_with(double each_at_least) const {
  const Weighed* best = nullptr;
  for (const Weighed& w : all_) {
    const bool all =
        std::all_of(w.fit->fit.together.begin(), w.fit->fit.together.end(),
                    [&](const Hypothesis* h) { return of(h->effect) >= each_at_least; });
    if (all && (!best || w.weight > best->weight)) best = &w;
  }
  return best ? placed_best(*best->fit) : nullptr;
}

const JudgedFit* Inclusion::placed_best(const JudgedFit& set) const {
  const auto probability = [&](const JudgedFit& j) {
    double product = 1;
    for (const Hypothesis* h : j.fit.together) product *= at(h->effect, h->place);
    return product;
  };
  const JudgedFit* best = &set;
  double most = probability(set);
  for (const Weighed& w : all_)
    if (w.fit->fit.effects() == set.fit.effects() && probability(*w.fit) > most) {
      most = probability(*w.fit);
      best = w.fit;
    }
  return best;
}

const JudgedFit* Inclusion::without(const JudgedFit& set,
                                    const std::vector<const Hypothesis*>& members) const {
  const Members others = plica::without(set.fit.together, members);
  for (const Weighed& w : all_)
    if (w.fit->fit.together.size() == others.size() &&
        std::is_permutation(others.begin(), others.end(), w.fit->fit.together.begin()))
      return w.fit;
  return nullptr;
}

} // namespace plica
