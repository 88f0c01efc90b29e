#include "diagnose/judge/places_fitted.hpp"

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
  for (const JudgedFit& j : fits)
    if (j.fit.solved) by_effect[j.fit.together[0]->effect].push_back(&j);
  std::set<Where> near;
  for (auto& [effect, own] : by_effect) {
    std::stable_sort(own.begin(), own.end(), [](const JudgedFit* a, const JudgedFit* b) {
      return a->fit.log_evidence > b->fit.log_evidence;
    });
    for (std::size_t i = 0; i < own.size(); ++i)
      if (const Hypothesis& h = *own[i]->fit.together[0];
          i < best_places || own[i]->fit.log_evidence >
                                 own.front()->fit.log_evidence - threshold::beyond_chance)
        near.insert(where(h, h.place));
  }
  return near;
}

} // namespace

PlacesFitted fit_places(const std::vector<const Hypothesis*>& all,
                        const std::function<JudgedFit(const Hypothesis&)>& fit) {
  PlacesFitted result;
  result.fits.resize(all.size());
  const auto fit_those = [&](const auto& chosen) {
    in_parallel(int(all.size()), [&](int i) {
      const Hypothesis& h = *all[std::size_t(i)];
      if (chosen(h)) result.fits[std::size_t(i)] = fit(h);
    });
  };
  fit_those([](const Hypothesis& h) { return h.between.empty(); });
  const std::set<Where> near = near_the_best(result.fits);
  const auto is_beside_them = [&](const Hypothesis& h) {
    return std::any_of(h.between.begin(), h.between.end(),
                       [&](const auto& beside) { return near.contains(where(h, beside.first)); });
  };
  fit_those(is_beside_them);
  for (const Hypothesis* h : all)
    if (!h->between.empty() && !is_beside_them(*h)) ++result.passed_over[h->effect];
  std::erase_if(result.fits, [](const JudgedFit& j) { return !j.fit.solved; });
  return result;
}

} // namespace plica
