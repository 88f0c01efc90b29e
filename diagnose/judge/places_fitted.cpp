#include "diagnose/judge/places_fitted.hpp"

#include "diagnose/judge/identifiability.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace plica {
namespace {

using InWay = std::tuple<std::string, std::string, std::string>; // effect, place, way

// The largest evidence of fits, by the errors as stated and as a fit that leaves much makes them.
struct Most {
  double stated = -std::numeric_limits<double>::infinity(), dispersed = stated;
  void take(const HypothesisFit& fit) {
    stated = std::max(stated, fit.log_evidence);
    dispersed = std::max(dispersed, dispersed_log_evidence(fit));
  }
  bool is_near(double own_stated, double own_dispersed) const {
    return own_stated > stated - threshold::beyond_chance ||
           own_dispersed > dispersed - threshold::beyond_chance;
  }
};

// Of what was fitted: the best way at the best three places of each effect, and where it comes near
// the best of all what is within so many nats of its best.
std::set<InWay> near_the_best(const std::vector<JudgedFit>& fits) {
  constexpr std::size_t best_places = 3;
  std::map<std::string, std::vector<const JudgedFit*>> by_effect;
  std::map<std::string, Most> most;
  Most of_all;
  for (const JudgedFit& j : fits) {
    const std::string& effect = j.fit.together[0]->effect;
    by_effect[effect].push_back(&j);
    most[effect].take(j.fit);
    of_all.take(j.fit);
  }
  std::set<InWay> near;
  for (auto& [effect, own] : by_effect) {
    std::stable_sort(own.begin(), own.end(), [](const JudgedFit* a, const JudgedFit* b) {
      return a->fit.log_evidence > b->fit.log_evidence;
    });
    const Most& best = most[effect];
    const bool comes_near = of_all.is_near(best.stated, best.dispersed);
    std::set<std::string> places;
    for (const JudgedFit* j : own) {
      const Hypothesis& h = *j->fit.together[0];
      const bool best_there = places.size() < best_places && places.insert(h.place).second;
      if (best_there ||
          (comes_near && best.is_near(j->fit.log_evidence, dispersed_log_evidence(j->fit))))
        near.insert({effect, h.place, h.way});
    }
  }
  return near;
}

} // namespace

bool lie_next(const Hypothesis& a, const Hypothesis& b) {
  const auto names = [](const Hypothesis& h, const Hypothesis& other) {
    return std::any_of(h.between.begin(), h.between.end(),
                       [&](const auto& beside) { return beside.first == other.place; });
  };
  return a.effect == b.effect && a.way == b.way && (names(a, b) || names(b, a));
}

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
    const std::set<InWay> near = near_the_best(result.fits);
    const auto lies_far = [&](const Hypothesis* h) {
      return std::none_of(h->between.begin(), h->between.end(), [&](const auto& beside) {
        return near.contains({h->effect, beside.first, h->way});
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
