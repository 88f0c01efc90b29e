#include "diagnose/gap/pairs.hpp"

#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t first_halves = 3, second_halves = 5; // that are tried

// A frequency or damping moves with the level by more than its uncertainty: what slips may be in
// it.
bool changes_with_level(const TestReadings& test) {
  constexpr double beyond = 3; // standard deviations
  const std::vector<LevelTrend> trends = level_trends(test);
  return std::any_of(trends.begin(), trends.end(),
                     [](const LevelTrend& t) { return std::abs(t.slope) > beyond * t.sigma; });
}

} // namespace

std::vector<JudgedFit> fit_pairs(const FitContext& context, const std::vector<Family>& ranked,
                                 const std::vector<Signature>& all, const HypothesisFit& plain,
                                 const Whitening& held_out, const BlockScores& scores,
                                 const Standards& standards) {
  std::vector<std::vector<const Hypothesis*>> together;
  std::vector<VectorXd> starts;
  const bool levels_matter = changes_with_level(context.test);
  // The best effects, each with those that its residual asks for (matched filter).
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
      if (std::any_of(together.begin(), together.end(),
                      [&](const auto& t) { return t[0] == b && t[1] == a; }))
        continue;
      together.push_back({a, b});
      VectorXd z(Index(a->parameters.size() + b->parameters.size()));
      z << first.z, VectorXd::Zero(Index(b->parameters.size()));
      starts.push_back(z);
    }
  }
  std::vector<JudgedFit> pairs(together.size());
  in_parallel(int(together.size()), [&](int i) {
    pairs[std::size_t(i)] =
        judged(fit_of(context, together[std::size_t(i)], starts[std::size_t(i)]), plain, context,
               held_out, scores, standards);
  });
  std::erase_if(pairs, [](const JudgedFit& j) { return !j.fit.solved; });
  std::sort(pairs.begin(), pairs.end(), [](const JudgedFit& a, const JudgedFit& b) {
    return a.fit.log_evidence > b.fit.log_evidence;
  });
  return pairs;
}

} // namespace plica
