#include "diagnose/judge/judge.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::VectorXd;

constexpr double told_apart = 3;          // nats between effects that are told apart
constexpr double open_to = 8;             // nats, where the one that leads is not believed
constexpr std::size_t most_listed = 3;    // of these
constexpr double pair_gain = 5;           // over the best single one
constexpr double pair_shrink = 0.3;       // of held-out readings
constexpr double absurd_z = 3;            // standard deviations of a prior
constexpr double most_allowed = 1.5;      // gap without what a hypothesis is allowed to be off
constexpr double most_left = 0.5;         // of a change from a baseline
constexpr double believable_shrink = 0.6; // of held-out readings, though they are not met

double evidence(const HypothesisFit& fit) {
  return fit.sampled_log_evidence.value_or(fit.log_evidence);
}

template <class Chi2> std::vector<double> of_healthy(const FitContext& context, const Chi2& chi2) {
  std::vector<double> all;
  for (Eigen::Index k = 0; k < context.uncertainty.healthy.cols(); ++k)
    all.push_back(chi2(VectorXd(context.uncertainty.healthy.col(k))));
  std::sort(all.begin(), all.end());
  return all;
}

double point(const std::vector<double>& sorted, double share) {
  return sorted.empty() ? 0 : sorted[std::size_t(share * double(sorted.size() - 1) + 0.5)];
}

int free_parameters(const HypothesisFit& fit) {
  constexpr double narrower = 0.5, moves = 0.1; // standard deviations of prior and of a reading
  int count = 0;
  for (Eigen::Index k = 0; k < fit.z.size(); ++k)
    count +=
        std::sqrt(fit.covariance(k, k)) < narrower || fit.J.col(k).cwiseAbs().maxCoeff() > moves;
  return count;
}

// Worth of each half: what the other loses without it.
bool both_needed(const JudgedFit& pair, const std::vector<Family>& families) {
  for (const Hypothesis* half : pair.fit.together) {
    const Hypothesis* other =
        pair.fit.together[0] == half ? pair.fit.together[1] : pair.fit.together[0];
    for (const Family& f : families)
      if (f.best->fit.together[0]->effect == other->effect &&
          evidence(pair.fit) - evidence(f.best->fit) < told_apart)
        return false;
  }
  return true;
}

} // namespace

Standards standards_of(const FitContext& context, const Whitening& held_out,
                       const BlockScores& scores) {
  Standards s;
  const auto by = [](const Whitening& white) {
    return [&white](const VectorXd& d) { return white(d).squaredNorm(); };
  };
  s.healthy_chi2 = of_healthy(context, by(context.fitted));
  s.chi2 = point(s.healthy_chi2, 0.99);
  s.chi2_of_means =
      point(of_healthy(context, [&](const VectorXd& d) { return scores.of_means(d); }), 0.99);
  if (!held_out.rows().empty()) s.held_out_chi2 = point(of_healthy(context, by(held_out)), 0.999);
  return s;
}

JudgedFit judged(HypothesisFit fit, const HypothesisFit& nominal, const FitContext& context,
                 const Whitening& held_out, const BlockScores& scores, const Standards& standards) {
  JudgedFit j;
  j.fit = std::move(fit);
  if (!j.fit.solved) return j;
  j.log_bayes_factor = evidence(j.fit) - nominal.log_evidence;
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
                             ? std::max(most_allowed, most_left * before)
                             : most_allowed;
  j.adequate = !standards.gate ||
               (j.fit.chi2 <= standards.chi2 && j.worst.first <= standards.worst_block &&
                j.chi2_of_means <= standards.chi2_of_means && (slips || j.gap_after <= allowed));
  j.absurd = j.fit.farthest > absurd_z;
  j.free_parameters = free_parameters(j.fit);
  if (!held_out.rows().empty() && j.adequate) complete(context, j.fit);
  if (!held_out.rows().empty() && j.fit.complete) {
    const double n = double(held_out.rows().size());
    const double chi2 = held_out(j.fit.deviation).squaredNorm();
    const double by_law = held_out.widened(j.fit.further)(j.fit.deviation).squaredNorm();
    const double of_nominal = held_out(nominal.deviation).squaredNorm();
    j.held_out_after = std::sqrt(chi2 / n);
    j.held_out_shrink = 1 - std::sqrt(chi2 / of_nominal);
    j.held_out_met = by_law <= standards.held_out_chi2;
    j.fails_held_out = !j.held_out_met && *j.held_out_shrink < believable_shrink;
  }
  return j;
}

std::vector<Family> families(const std::vector<JudgedFit>& fits) {
  std::map<std::string, std::vector<const JudgedFit*>> by_effect;
  for (const JudgedFit& j : fits)
    if (j.fit.solved) by_effect[j.fit.together[0]->effect].push_back(&j);
  std::vector<Family> all;
  for (const auto& [effect, own] : by_effect) {
    Family f{.effect = effect};
    double highest = -1e300;
    for (const JudgedFit* j : own) highest = std::max(highest, evidence(j->fit));
    double sum = 0;
    for (const JudgedFit* j : own) {
      sum += std::exp(evidence(j->fit) - highest) / double(own.size());
      // Among equals the one that stands up.
      const auto rank = [](const JudgedFit* a) {
        return evidence(a->fit) + (a->credible() ? 2 : 0);
      };
      if (!f.best || rank(j) > rank(f.best)) f.best = j;
    }
    f.log_evidence = highest + std::log(sum);
    std::map<std::string, double> places;
    for (const JudgedFit* j : own)
      places[j->fit.together[0]->place] +=
          std::exp(evidence(j->fit) - highest) / (sum * double(own.size()));
    f.places.assign(places.begin(), places.end());
    std::stable_sort(f.places.begin(), f.places.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    all.push_back(f);
  }
  std::sort(all.begin(), all.end(),
            [](const Family& a, const Family& b) { return a.log_evidence > b.log_evidence; });
  return all;
}

double Judgement::probability_of(const std::string& effect) const {
  for (const auto& [name, p] : probabilities)
    if (name == effect) return p;
  return 0;
}

double Judgement::share_of(const std::string& effect, const std::string& place) const {
  const auto known = places.find(effect);
  if (known == places.end()) return 1;
  for (const auto& [name, share] : known->second)
    if (name == place) return share;
  return 0;
}

Judgement judge(const JudgedFit& nominal, const std::vector<Family>& families,
                const std::vector<JudgedFit>& pairs, const Standards& standards,
                const Objecting& objecting) {
  Judgement result;
  for (const Family& f : families) result.places[f.effect] = f.places;
  const double none = nominal.fit.log_evidence;
  // Probabilities among what is credible; where nothing is, among all.
  std::vector<const Family*> credible;
  for (const Family& f : families)
    if (f.best->credible()) credible.push_back(&f);
  double highest = none;
  for (const Family& f : families) highest = std::max(highest, f.log_evidence);
  const bool any = !credible.empty() || nominal.adequate;
  double sum = 0;
  const auto weigh = [&](const std::string& name, double log_evidence, bool counts) {
    if (any && !counts) return;
    result.probabilities.emplace_back(name, std::exp(log_evidence - highest));
    sum += result.probabilities.back().second;
  };
  weigh("none", none, nominal.adequate);
  for (const Family& f : families) weigh(f.effect, f.log_evidence, f.best->credible());
  for (auto& [name, p] : result.probabilities) p /= std::max(sum, 1e-300);
  std::stable_sort(result.probabilities.begin(), result.probabilities.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });

  const double best = credible.empty() ? -1e300 : credible.front()->log_evidence;
  if (nominal.adequate && best - none < standards.evidence) {
    result.verdict = Verdict::none;
    return result;
  }
  if (!credible.empty() && best - none >= standards.evidence) {
    for (const Family* f : credible)
      if (best - f->log_evidence < standards.apart &&
          f->log_evidence - none >= standards.evidence - standards.apart)
        result.named.push_back(f->best);
    if (result.named.size() == 1 && objecting) {
      Objection objection = objecting(*result.named.front());
      result.withheld = std::move(objection.why);
      result.in_turn = objection.in_turn;
    }
    if (!result.withheld.empty())
      for (const Family* f : credible)
        if (result.named.size() < most_listed && f->best != result.named.front() &&
            best - f->log_evidence < open_to)
          result.named.push_back(f->best);
    result.verdict = result.named.size() == 1 && result.withheld.empty() ? Verdict::identified
                                                                         : Verdict::ambiguous;
    return result;
  }
  std::vector<const JudgedFit*> standing;
  for (const JudgedFit& pair : pairs) {
    if (!pair.fit.solved || !pair.credible()) continue;
    if (pair.free_parameters >= pair.fit.error.size() && pair.fit.error.size() > 0) continue;
    // With so many parameters only what was held out can speak for it.
    if (!pair.held_out_met || pair.held_out_shrink.value_or(0) < pair_shrink) continue;
    const double single = families.empty() ? none : evidence(families.front().best->fit);
    if (evidence(pair.fit) - std::max(single, none) < pair_gain) continue;
    if (both_needed(pair, families)) standing.push_back(&pair);
  }
  result.verdict = standing.empty() ? Verdict::unknown : Verdict::pair;
  if (standing.empty()) return result;
  std::stable_sort(standing.begin(), standing.end(), [](const JudgedFit* a, const JudgedFit* b) {
    return evidence(a->fit) > evidence(b->fit);
  });
  const double most = evidence(standing.front()->fit);
  std::erase_if(standing,
                [&](const JudgedFit* pair) { return most - evidence(pair->fit) >= told_apart; });
  result.named = standing;
  // Of the effects, over the pairs that explain as well.
  result.probabilities.clear();
  std::map<std::string, double> shares;
  double all = 0;
  for (const JudgedFit* pair : standing) {
    const double weight = std::exp(evidence(pair->fit) - most);
    all += weight;
    for (const Hypothesis* h : pair->fit.together) shares[h->effect] += weight;
  }
  for (const auto& [effect, share] : shares) result.probabilities.emplace_back(effect, share / all);
  return result;
}

} // namespace plica
