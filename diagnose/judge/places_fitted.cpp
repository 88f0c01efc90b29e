#include "diagnose/judge/places_fitted.hpp"

#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace plica {
namespace {

using EffectAtPlace = std::pair<std::string, std::string>;

// Of what was fitted: the best three places of each effect, and those within so many nats of its
// best, by the errors as stated or as a fit that leaves much makes them.
std::set<EffectAtPlace> near_the_best(const std::vector<JudgedFit>& fits) {
  constexpr std::size_t best_places = 3;
  std::map<std::string, std::vector<const JudgedFit*>> by_effect;
  for (const JudgedFit& j : fits) by_effect[j.fit.together[0]->effect].push_back(&j);
  std::set<EffectAtPlace> near;
  for (auto& [effect, own] : by_effect) {
    std::stable_sort(own.begin(), own.end(), [](const JudgedFit* a, const JudgedFit* b) {
      return a->fit.log_evidence > b->fit.log_evidence;
    });
    double dispersed = dispersed_log_evidence(own.front()->fit);
    for (const JudgedFit* j : own) dispersed = std::max(dispersed, dispersed_log_evidence(j->fit));
    std::set<std::string> places;
    for (const JudgedFit* j : own) {
      const std::string& place = j->fit.together[0]->place;
      if (places.size() < best_places) places.insert(place);
      if (places.contains(place) ||
          j->fit.log_evidence > own.front()->fit.log_evidence - threshold::beyond_chance ||
          dispersed_log_evidence(j->fit) > dispersed - threshold::beyond_chance)
        near.insert({effect, place});
    }
  }
  return near;
}

} // namespace

PlacesFitted fit_places(const FitContext& context, const std::vector<const Hypothesis*>& all,
                        const std::function<JudgedFit(const Hypothesis&)>& fit) {
  std::vector<const Hypothesis*> first, between;
  for (const Hypothesis* h : all) (h->between.empty() ? first : between).push_back(h);
  PlacesFitted result;
  const auto fit_each = [&](const std::vector<const Hypothesis*>& chosen) {
    std::vector<JudgedFit> own(chosen.size());
    in_parallel(int(own.size()),
                [&](int i) { own[std::size_t(i)] = fit(*chosen[std::size_t(i)]); });
    for (JudgedFit& j : own)
      if (j.fit.solved) result.fits.push_back(std::move(j));
  };
  fit_each(first);
  for (std::vector<const Hypothesis*> chosen = first; !chosen.empty();) {
    const std::set<EffectAtPlace> near = near_the_best(result.fits);
    const auto lies_far = [&](const Hypothesis* h) {
      return std::none_of(h->between.begin(), h->between.end(), [&](const auto& beside) {
        return near.contains({h->effect, beside.first});
      });
    };
    const auto close = std::stable_partition(between.begin(), between.end(), lies_far);
    chosen.assign(close, between.end());
    between.erase(close, between.end());
    reduce_each(context, chosen);
    fit_each(chosen);
  }
  for (const Hypothesis* h : between) result.passed_over[h->effect] += h->weight;
  return result;
}

} // namespace plica
