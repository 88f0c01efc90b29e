#include "diagnose/judge/places_fitted.hpp"

#include "diagnose/judge/identifiability.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace plica {
namespace {

using Where = std::tuple<std::string, std::string, std::string>; // effect, place, way

Where where(const Hypothesis& h, const std::string& place) {
  return {h.effect, place, h.way};
}

// Of those that were fitted, places of each effect that are near its best.
std::set<Where> near_the_best(const std::vector<JudgedFit>& fits) {
  constexpr std::size_t best_places = 3;
  std::map<std::string, std::vector<const JudgedFit*>> by_effect;
  for (const JudgedFit& j : fits) by_effect[j.fit.together[0]->effect].push_back(&j);
  std::set<Where> near;
  for (auto& [effect, own] : by_effect) {
    std::stable_sort(own.begin(), own.end(), [](const JudgedFit* a, const JudgedFit* b) {
      return a->fit.log_evidence > b->fit.log_evidence;
    });
    for (std::size_t i = 0; i < own.size(); ++i)
      if (const Hypothesis& h = *own[i]->fit.together[0];
          i < best_places ||
          own[i]->fit.log_evidence > own.front()->fit.log_evidence - threshold::beyond_chance)
        near.insert(where(h, h.place));
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
  const std::set<Where> near = near_the_best(result.fits);
  const auto lies_beside_them = [&](const Hypothesis* h) {
    return std::any_of(h->between.begin(), h->between.end(),
                       [&](const auto& beside) { return near.contains(where(*h, beside.first)); });
  };
  const auto far = std::stable_partition(between.begin(), between.end(), lies_beside_them);
  for (auto h = far; h != between.end(); ++h) ++result.passed_over[(*h)->effect];
  between.erase(far, between.end());
  reduce_each(context, between);
  fit_each(between);
  return result;
}

} // namespace plica
