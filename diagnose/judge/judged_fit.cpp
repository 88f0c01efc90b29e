#include "diagnose/judge/judged_fit.hpp"

#include "model/description/place_keys.hpp"
#include "words/sample_ranks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>
#include <tuple>

namespace plica {
namespace {

using Eigen::VectorXd;

template <class Chi2> std::vector<double> of_healthy(const FitContext& context, const Chi2& chi2) {
  std::vector<double> all;
  for (Eigen::Index k = 0; k < context.uncertainty.healthy.cols(); ++k)
    all.push_back(chi2(VectorXd(context.uncertainty.healthy.col(k))));
  std::sort(all.begin(), all.end());
  return all;
}

double point(const std::vector<double>& sorted, double share) {
  return sorted.empty() ? 0 : sorted[nearest_rank(sorted.size(), share)];
}

int free_parameters(const HypothesisFit& fit) {
  int count = 0;
  for (const Hypothesis* h : fit.together) count += h->free_numbers;
  for (Eigen::Index k = 0; k < fit.z.size(); ++k)
    count += std::sqrt(fit.covariance(k, k)) < threshold::narrower ||
             fit.J.col(k).cwiseAbs().maxCoeff() > threshold::moves;
  return count;
}

// Whether all parameters are as they were expected, and as well known, once the readings are seen.
bool stays_at_priors(const HypothesisFit& fit) {
  if (fit.together.empty()) return false;
  return fit.farthest < threshold::untold_z &&
         fit.covariance.diagonal().cwiseSqrt().minCoeff() > threshold::untold;
}

// How many readings are fitted, and how many of them the fit moves: a shape stands for all of its
// components.
std::pair<Eigen::Index, Eigen::Index> fitted_and_moved(const HypothesisFit& fit,
                                                       const FitContext& context) {
  std::set<Eigen::Index> fitted, moved;
  for (Eigen::Index k = 0; k < fit.error.size(); ++k) {
    const Eigen::Index row = context.fitted.rows()[std::size_t(k)];
    const int shape = context.test.readings[std::size_t(row)].of_shape;
    const Eigen::Index number = shape < 0 ? row : -1 - shape;
    fitted.insert(number);
    if (fit.J.cols() > 0 && fit.J.row(k).cwiseAbs().maxCoeff() > threshold::moves)
      moved.insert(number);
  }
  return {Eigen::Index(fitted.size()), Eigen::Index(moved.size())};
}

} // namespace

double evidence_of(const HypothesisFit& fit) {
  return fit.sampled_log_evidence.value_or(fit.log_evidence);
}

Standards standards_of(const FitContext& context, const Whitening& held_out,
                       const BlockScores& scores) {
  Standards s;
  const auto by = [](const Whitening& white) {
    return [&white](const VectorXd& d) { return white(d).squaredNorm(); };
  };
  s.healthy_chi2 = of_healthy(context, by(context.fitted));
  s.chi2 = point(s.healthy_chi2, threshold::healthy);
  s.sure_chi2 = point(s.healthy_chi2, threshold::sure);
  const std::vector<double> of_means =
      of_healthy(context, [&](const VectorXd& d) { return scores.of_means(d); });
  s.chi2_of_means = point(of_means, threshold::healthy);
  s.sure_chi2_of_means = point(of_means, threshold::sure);
  if (!held_out.rows().empty())
    s.held_out_chi2 = point(of_healthy(context, by(held_out)), threshold::healthy_held_out);
  return s;
}

JudgedFit judged(HypothesisFit fit, const HypothesisFit& nominal, const FitContext& context,
                 const Whitening& held_out, const BlockScores& scores, const Standards& standards) {
  JudgedFit j;
  j.fit = std::move(fit);
  if (!j.fit.solved) return j;
  j.log_bayes_factor = evidence_of(j.fit) - nominal.log_evidence;
  j.worst = scores.worst(j.fit.deviation, j.fit.further);
  j.chi2_of_means = scores.of_means(j.fit.deviation, j.fit.further);
  const auto& healthy = standards.healthy_chi2;
  j.p = double(healthy.end() - std::lower_bound(healthy.begin(), healthy.end(), j.fit.chi2)) /
        double(healthy.size());
  j.gap_after = std::sqrt(context.fitted(j.fit.deviation).squaredNorm() /
                          double(context.fitted.rows().size()));
  const bool slips = std::any_of(j.fit.together.begin(), j.fit.together.end(),
                                 [](const Hypothesis* h) { return h->law_error > 0; });
  // Beside a baseline what a hypothesis may be off grows with what it changes.
  const double before = std::sqrt(nominal.chi2 / double(context.fitted.rows().size()));
  const double allowed = context.uncertainty.change_error > 0
                             ? std::max(threshold::most_allowed, threshold::most_left * before)
                             : threshold::most_allowed;
  j.explains_nothing = !j.fit.together.empty() &&
                       std::pow(j.gap_after / before, 2) >=
                           (nominal.chi2 > standards.chi2 ? 1 - threshold::least_closed : 1);
  j.adequate = !standards.gate ||
               (j.fit.chi2 <= standards.chi2 && j.worst.first <= standards.worst_block &&
                j.chi2_of_means <= standards.chi2_of_means && (slips || j.gap_after <= allowed));
  j.at_the_edge =
      standards.gate && j.adequate &&
      (j.fit.chi2 > standards.sure_chi2 || j.chi2_of_means > standards.sure_chi2_of_means);
  j.absurd = j.fit.farthest > threshold::absurd_z;
  j.free_parameters = free_parameters(j.fit);
  // What is there at all may say much, whatever its size: a bolt that is lost.
  constexpr double says_much = 0.5; // of the gap is left
  j.stays_at_priors = stays_at_priors(j.fit) && std::pow(j.gap_after / before, 2) > says_much;
  std::tie(j.readings, j.moved) = fitted_and_moved(j.fit, context);
  if (!held_out.rows().empty() && j.adequate) complete(context, j.fit);
  if (!held_out.rows().empty() && j.fit.complete) {
    const double n = double(held_out.rows().size());
    const double chi2 = held_out(j.fit.deviation).squaredNorm();
    const double by_law = held_out.widened(j.fit.further)(j.fit.deviation).squaredNorm();
    const double of_nominal = held_out(nominal.deviation).squaredNorm();
    j.held_out_after = std::sqrt(chi2 / n);
    j.held_out_shrink = 1 - std::sqrt(chi2 / of_nominal);
    j.held_out_met = by_law <= standards.held_out_chi2;
    j.fails_held_out = !j.held_out_met && *j.held_out_shrink < threshold::believable_shrink;
  }
  return j;
}

std::vector<JudgedFit> of_different_effects(const std::vector<JudgedFit>& sets, std::size_t most) {
  std::vector<JudgedFit> chosen;
  std::set<std::vector<std::string>> seen;
  for (const JudgedFit& j : sets)
    if (chosen.size() < most && seen.insert(j.fit.effects()).second) chosen.push_back(j);
  return chosen;
}

std::vector<EffectFits> fits_by_effect(const std::vector<JudgedFit>& fits,
                                       const PassedOver& passed_over) {
  std::map<std::string, std::vector<const JudgedFit*>> by_effect;
  for (const JudgedFit& j : fits)
    if (j.fit.solved) by_effect[j.fit.together[0]->effect].push_back(&j);
  std::vector<EffectFits> all;
  for (const auto& [effect, own] : by_effect) {
    EffectFits f{.effect = effect};
    const auto further = passed_over.find(effect);
    double all_weights = further == passed_over.end() ? 0 : further->second;
    for (const JudgedFit* j : own) all_weights += j->fit.together[0]->weight;
    double highest = -1e300;
    for (const JudgedFit* j : own) highest = std::max(highest, evidence_of(j->fit));
    double sum = 0;
    for (const JudgedFit* j : own) {
      sum += j->fit.together[0]->weight * std::exp(evidence_of(j->fit) - highest) / all_weights;
      // Among equals the one that stands up.
      const auto rank = [](const JudgedFit* a) {
        return evidence_of(a->fit) + (a->credible() ? 2 : 0);
      };
      if (!f.best || rank(j) > rank(f.best)) f.best = j;
    }
    f.log_evidence = highest + std::log(sum);
    std::map<std::string, double> places;
    for (const JudgedFit* j : own)
      places[j->fit.together[0]->place] += j->fit.together[0]->weight *
                                           std::exp(evidence_of(j->fit) - highest) /
                                           (sum * all_weights);
    f.places.assign(places.begin(), places.end());
    std::stable_sort(f.places.begin(), f.places.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    all.push_back(f);
  }
  std::sort(all.begin(), all.end(), [](const EffectFits& a, const EffectFits& b) {
    return a.log_evidence > b.log_evidence;
  });
  return all;
}

bool JudgedFit::leaves_cause_open() const {
  return std::any_of(fit.together.begin(), fit.together.end(),
                     [](const Hypothesis* h) { return h->names_place_only; });
}

bool JudgedFit::too_free() const {
  return readings > 0 && threshold::readings_each * free_parameters > readings;
}

std::string JudgedFit::saturated() const {
  if (readings == 0) return "";
  if (free_parameters >= readings)
    return fmt::format("{} free parameters for {} fitted readings", free_parameters, readings);
  if (free_parameters < 2 || free_parameters + threshold::spare_readings <= moved) return "";
  return fmt::format("{} free parameters for {} readings that they move", free_parameters, moved);
}

void drop_places_with_a_cause(std::vector<JudgedFit>& fits, const JudgedFit& nominal) {
  const auto component = [](const JudgedFit& j) {
    const std::string& place = j.fit.together[0]->place;
    return part_of_set(place);
  };
  const auto closed = [&](const JudgedFit& j) {
    return nominal.gap_after * nominal.gap_after - j.gap_after * j.gap_after;
  };
  // Of many spots one closes some of whatever it is: it has to close all.
  const auto counted = [&](const JudgedFit& j) {
    return j.fit.together[0]->free_numbers > 0 ? threshold::cause_closes * closed(j) : closed(j);
  };
  std::map<std::string, double> by_causes;
  for (const JudgedFit& j : fits)
    if (!j.leaves_cause_open() && !j.absurd)
      by_causes[component(j)] = std::max(by_causes[component(j)], counted(j));
  std::erase_if(fits, [&](const JudgedFit& j) {
    return j.leaves_cause_open() && by_causes[component(j)] >= threshold::cause_closes * closed(j);
  });
}

} // namespace plica
