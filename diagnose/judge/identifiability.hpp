// What a set of readings can tell apart.
//
//   g_i = L^-1 (y(theta_i) - y(0)),   cos_ij = |g_i' g_j| / (|g_i| |g_j|)
//
// Scatter is in L, so what it could explain is projected out. The non-centrality of the chi-square
// test for an effect is |g|^2 by the covariance that the effect itself leaves (evidence.hpp), less
// twice what the evidence pays for it.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/evidence.hpp"

#include <functional>

namespace plica {

inline constexpr double silent = 0.3; // |g| below which no data speak of an effect

// Signature of a hypothesis at a size that can be expected: whitened change of the fitted readings;
// of one that lies between others (Hypothesis::between) the mean of theirs.
struct Signature {
  const Hypothesis* hypothesis = nullptr;
  Eigen::VectorXd z, g;
  double noncentrality = 0;
  double at = 0;                  // value of the parameter of its size there
  std::optional<double> smallest; // the one that is found with 95 % power
};
// Reduced models with each hypothesis alone in it, in every state that is fitted: a few at a time
// they take less time than one by one, as signatures and fits would ask for them. `one_is_done` is
// called after each in each state, from several threads.
void reduce_each(
    const FitContext& context, const std::vector<const Hypothesis*>& all,
    const std::function<void()>& one_is_done = [] {});
// Those that lie between no others.
std::vector<const Hypothesis*> looked_at(const std::vector<Hypothesis>& all);
// `one_is_done` is called after each, from several threads.
std::vector<Signature> signatures(
    const FitContext& context, const std::vector<Hypothesis>& all,
    const std::function<void()>& one_is_done = [] {});
// Fills `smallest` of the hypothesis of each effect that shows most, among those looked at.
void find_smallest(const FitContext& context, std::vector<Signature>& all);

// Root of the non-centrality from which on an effect is found with 95 % power at ln BF = 3.
constexpr double detectable_size = 4.6;

// Largest cosine of two effects over their places, by name.
struct Likeness {
  std::vector<std::string> effects;
  Eigen::MatrixXd cosine;
};
Likeness likeness(const std::vector<Signature>& all);
std::vector<Mimic> mimics(const Likeness& likeness);
std::vector<SmallestDetectable> detectable(const std::vector<Signature>& all);

// ln BF of the best effect over the nominal case that a share of 97.5 % of healthy specimens stays
// below, by the signatures; at least 3.
double evidence_threshold(const FitContext& context, const std::vector<Signature>& all);

} // namespace plica
