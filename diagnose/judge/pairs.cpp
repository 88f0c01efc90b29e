#include "diagnose/judge/pairs.hpp"

#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t first_halves = 3, second_halves = 4; // that are tried
constexpr std::size_t moved_pairs = 2, other_places = 3;   // of the best, for one half

// A frequency or damping moves with the level by more than its uncertainty: what slips may be in
// it.
bool changes_with_level(const TestReadings& test) {
  constexpr double beyond = 3; // standard deviations
  const std::vector<LevelTrend> trends = level_trends(test);
  return std::any_of(trends.begin(), trends.end(),
                     [](const LevelTrend& t) { return std::abs(t.slope) > beyond * t.sigma; });
}

struct Asked {
  std::vector<const Hypothesis*> together;
  VectorXd start;
};

bool known(const std::vector<Asked>& all, const Hypothesis* a, const Hypothesis* b) {
  return std::any_of(all.begin(), all.end(), [&](const Asked& own) {
    return (own.together[0] == a && own.together[1] == b) ||
           (own.together[0] == b && own.together[1] == a);
  });
}

// The best effects, each with those that its residual asks for (matched filter).
std::vector<Asked> first_round(const FitContext& context, const std::vector<Family>& ranked,
                               const std::vector<Signature>& all) {
  std::vector<Asked> asked;
  const bool levels_matter = changes_with_level(context.test);
  for (std::size_t i = 0; i < std::min(first_halves, ranked.size()); ++i) {
    const HypothesisFit& first = ranked[i].best->fit;
    if (ranked[i].best->log_bayes_factor < 1) continue;
    std::map<std::string, std::pair<double, const Signature*>> gains;
    for (const Signature& s : all) {
      if (s.hypothesis->effect == first.together[0]->effect) continue;
      if (s.hypothesis->softening && (first.together[0]->softening || !levels_matter)) continue;
      // Of the residual, what the first effect could not take up itself.
      const MatrixXd J = first.J;
      const MatrixXd A = MatrixXd::Identity(J.cols(), J.cols()) + J.transpose() * J;
      const VectorXd g = s.g - J * A.ldlt().solve(J.transpose() * s.g);
      const double gain = std::pow(g.dot(first.error), 2) / (2 * (g.squaredNorm() + 1)) -
                          std::log1p(g.squaredNorm()) / 2;
      auto& best = gains[s.hypothesis->effect];
      if (!best.second || gain > best.first) best = {gain, &s};
    }
    std::vector<std::pair<double, const Signature*>> order;
    for (const auto& [effect, gain] : gains) order.push_back(gain);
    std::sort(order.begin(), order.end(),
              [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t k = 0; k < std::min(second_halves, order.size()); ++k) {
      const Hypothesis *a = first.together[0], *b = order[k].second->hypothesis;
      if (known(asked, a, b)) continue;
      VectorXd z(Index(a->parameters.size() + b->parameters.size()));
      z << first.z, VectorXd::Zero(Index(b->parameters.size()));
      asked.push_back({{a, b}, z});
    }
  }
  return asked;
}

// The best pairs with one half at the places that come next: alone, an effect may have been drawn
// to another place by what the other one does.
std::vector<Asked> second_round(const std::vector<JudgedFit>& pairs,
                                const std::vector<JudgedFit>& fits, std::vector<Asked> asked) {
  std::vector<Asked> more;
  for (std::size_t i = 0; i < 2 * std::min(moved_pairs, pairs.size()); ++i) {
    const HypothesisFit& pair = pairs[i / 2].fit;
    const std::size_t half = i % 2;
    const Hypothesis *moved = pair.together[half], *kept = pair.together[1 - half];
    const auto own = Index(kept->parameters.size());
    const VectorXd of_kept = half == 0 ? VectorXd(pair.z.tail(own)) : VectorXd(pair.z.head(own));
    std::vector<const HypothesisFit*> others;
    for (const JudgedFit& j : fits)
      if (const Hypothesis& h = *j.fit.together[0]; h.effect == moved->effect && &h != moved)
        others.push_back(&j.fit);
    std::stable_sort(others.begin(), others.end(), [](const auto* a, const auto* b) {
      return a->log_evidence > b->log_evidence;
    });
    for (std::size_t k = 0; k < std::min(other_places, others.size()); ++k) {
      const Hypothesis* a = others[k]->together[0];
      if (known(asked, a, kept)) continue;
      VectorXd z(others[k]->z.size() + own);
      z << others[k]->z, of_kept;
      asked.push_back({{a, kept}, z});
      more.push_back(asked.back());
    }
  }
  return more;
}

// What the halves change is prepared once: each is in several pairs.
void keep_halves(const FitContext& context, const std::vector<Asked>& asked) {
  StateFamilies::Together halves;
  for (const Asked& pair : asked)
    for (const Hypothesis* h : pair.together)
      if (std::find(halves.begin(), halves.end(), h) == halves.end()) halves.push_back(h);
  StateFamilies& families = *context.predictors.families();
  for (std::size_t state : families.fitted_states(context.test)) families.keep(state, halves);
}

} // namespace

std::vector<JudgedFit> fit_pairs(const FitContext& context, const std::vector<Family>& ranked,
                                 const std::vector<JudgedFit>& fits,
                                 const std::vector<Signature>& all, const HypothesisFit& plain,
                                 const Whitening& held_out, const BlockScores& scores,
                                 const Standards& standards) {
  std::vector<JudgedFit> pairs;
  const auto fit = [&](const std::vector<Asked>& asked) {
    keep_halves(context, asked);
    std::vector<JudgedFit> own(asked.size());
    in_parallel(int(asked.size()), [&](int i) {
      const Asked& pair = asked[std::size_t(i)];
      own[std::size_t(i)] = judged(fit_of(context, pair.together, pair.start), plain, context,
                                   held_out, scores, standards);
    });
    for (JudgedFit& j : own)
      if (j.fit.solved) pairs.push_back(std::move(j));
    std::stable_sort(pairs.begin(), pairs.end(), [](const JudgedFit& a, const JudgedFit& b) {
      return a.fit.log_evidence > b.fit.log_evidence;
    });
  };
  std::vector<Asked> asked = first_round(context, ranked, all);
  fit(asked);
  // Where a pair cannot be named, its places need not be weighed.
  if (!held_out.rows().empty()) fit(second_round(pairs, fits, asked));
  return pairs;
}

} // namespace plica
